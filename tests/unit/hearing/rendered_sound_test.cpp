#include "stridor/hearing/rendered_sound.hpp"

#include "stridor/base/error.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/parameters/paper_cases.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace stridor::hearing {
namespace {

std::vector<double> rest_of(RenderedSound& sound) {
    std::vector<double> all, block(7);
    for (std::size_t count = sound.read(block); count > 0; count = sound.read(block))
        all.insert(all.end(), block.begin(), block.begin() + static_cast<std::ptrdiff_t>(count));
    return all;
}

TEST(RenderedSound, IsReadAsItWasMadeAsOftenAsWanted) {
    RenderedSound sound(8000.0, "m/s");
    EXPECT_EQ(sound.mean_square(), 0.0);
    sound.append(std::vector{0.25, -0.5});
    sound.append(std::vector{0.0, 0.125, 0.25, -0.25, 0.5, 0.25});
    const std::vector<double> all{0.25, -0.5, 0.0, 0.125, 0.25, -0.25, 0.5, 0.25};
    EXPECT_EQ(sound.frames(), 8U);
    EXPECT_EQ(sound.layout().frames, 8U);
    EXPECT_EQ(sound.peak(), 0.5);
    EXPECT_EQ(sound.mean_square(), (4.0 * 0.0625 + 2.0 * 0.25 + 0.015625) / 8.0);
    EXPECT_EQ(rest_of(sound), all);
    EXPECT_TRUE(rest_of(sound).empty());
    sound.rewind();
    EXPECT_EQ(rest_of(sound), all);
}

TEST(RenderedSound, OfACaseIsItsSound) {
    parameters::Case c = parameters::paper_case(parameters::PaperCase::squeal);
    c.run.duration = c.run.window = 0.3;
    sound::AuralisationSettings settings;
    settings.rate = 16000.0;
    double told = 0.0;
    const auto progress = [&](double time) {
        EXPECT_GE(time, told);
        told = time;
    };
    const Rendering made = render(c, settings, record::KeepHistory::yes, {}, progress);
    EXPECT_EQ(rest_of(*made.sound), sound_of_case(c, settings, {}).samples);
    EXPECT_GT(made.record.histories.front().size(), 10U);
    EXPECT_NEAR(told, 0.3, 1e-3);
    EXPECT_EQ(made.sound->layout().rate, 16000.0);
    c.run.engine = parameters::Engine::beta_2;
    c.run.step = 1e-4;
    EXPECT_THROW(render(c, settings, {}, progress), Error);
}

}  // namespace
}  // namespace stridor::hearing
