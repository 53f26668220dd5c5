// A run taken apart into its modes: all of them are what is heard, and harmonics of a string are its modes.

#include "stridor/hearing/heard_modes.hpp"

#include "stridor/io/case/ready_files.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace stridor::hearing {
namespace {

TEST(HeardModes, OfABowedStringAreItsHarmonics) {
    const parameters::Case c =
        io::read_case({io::ready_file("string"), "string.toml", {"run.duration=0.6", "run.window=0.6"}});
    const HeardModes heard = heard_modes(c, {});
    EXPECT_EQ(heard.of, "bow velocity along x");
    EXPECT_EQ(heard.from, 0.3);
    EXPECT_EQ(heard.modes.frequencies.size(), 41U);
    const std::vector<analysis::ModalLine> lines = analysis::modal_lines(heard.spectrum, 3);
    ASSERT_EQ(lines.size(), 3U);
    for (std::size_t k = 0; k < lines.size(); ++k) {
        EXPECT_NEAR(lines[k].frequency, 200.0 * static_cast<double>(k + 1), 0.02 * lines[k].frequency);
        const auto most = std::max_element(lines[k].shares.begin(), lines[k].shares.end());
        const auto mode = static_cast<std::size_t>(most - lines[k].shares.begin());
        EXPECT_NEAR(heard.modes.frequencies[mode], 200.0 * static_cast<double>(k + 1), 1e-6);
        EXPECT_GT(*most, 0.9);
    }
}

TEST(HeardModes, OfTheJointAndThePlateAddUp) {
    const parameters::Case c = parameters::paper_case(parameters::PaperCase::squeal);
    for (const char* of : {"joint", "plate"}) {
        const HeardModes heard = heard_modes(c, {of});
        ASSERT_EQ(heard.spectrum.parts.size(), 3U);
        ASSERT_GT(heard.spectrum.whole.frames, 2U);
        for (std::size_t line = 0; line < heard.spectrum.whole.density.size(); ++line) {
            double sum = 0.0, size = 0.0;
            for (const std::vector<double>& part : heard.spectrum.parts) {
                sum += part[line];
                size += std::abs(part[line]);
            }
            EXPECT_NEAR(sum, heard.spectrum.whole.density[line], 1e-12 * size);
        }
    }
}

TEST(HeardModes, OfAMotionThatHasDiedOutAreNone) {
    parameters::Case c = parameters::paper_case(parameters::PaperCase::quiet);
    c.drive = {};
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = 0.1;
    c.run.duration = 20.0;
    EXPECT_TRUE(analysis::modal_lines(heard_modes(c, {}).spectrum).empty());
}

TEST(HeardModes, AreOfAVelocity) {
    const parameters::Case c = parameters::paper_case(parameters::PaperCase::squeal);
    EXPECT_EQ(support::thrown_by([&] {
                  heard_modes(c, {"joint", "", signal::MotionQuantity::acceleration});
              }).kind,
              ErrorKind::input);
    EXPECT_EQ(support::thrown_by([&] { heard_modes(c, {"nobody"}); }).kind, ErrorKind::input);
}

}  // namespace
}  // namespace stridor::hearing
