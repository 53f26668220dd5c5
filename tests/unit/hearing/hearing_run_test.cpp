#include "stridor/hearing/hearing_run.hpp"

#include "stridor/base/error.hpp"
#include "support/expected_error.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <limits>
#include <optional>
#include <stop_token>

namespace stridor::hearing {
namespace {

TEST(HeardText, GivesBackACellSound) {
    CellSound sound{42, sweep::Status::done, "", classification::Category::squeal, classification::Category::squeak,
                    {}};
    sound.profile.features.frequency = 428.5;
    sound.profile.features.impulses = 3;
    sound.profile.features.clearness = std::numeric_limits<double>::infinity();
    sound.profile.impulse_regularity = 0.25;
    const std::optional<CellSound> back = unpacked_cell_sound(packed(sound));
    ASSERT_TRUE(back);
    EXPECT_EQ(back->index, 42U);
    EXPECT_EQ(back->contact, sound.contact);
    EXPECT_EQ(back->heard, sound.heard);
    EXPECT_EQ(std::memcmp(&back->profile, &sound.profile, sizeof(sound.profile)), 0);
}

TEST(HeardText, GivesBackHeardSounds) {
    std::array<HeardSound, 2> sounds;
    sounds[0].index = 5;
    sounds[0].cell.status = sweep::Status::done;
    sounds[0].cell.category = classification::Category::creak;
    set_figure(sounds[0].cell, sweep::cell_figure("frequency"), 12.5);
    sounds[0].reason = "a reason: with\nsigns";
    sounds[0].perturbed.assign(perturbations().size(), classification::Category::none);
    sounds[1].cell.status = sweep::Status::invalid;
    sounds[1].cell.message = "mu_d exceeds mu_s";
    const std::string text = packed(sounds);
    const std::optional<std::vector<HeardSound>> back = unpacked_heard_sounds(text);
    ASSERT_TRUE(back);
    ASSERT_EQ(back->size(), 2U);
    EXPECT_EQ(packed(*back), text);
    EXPECT_EQ(figure_of((*back)[0].cell, "frequency"), 12.5);
    EXPECT_EQ((*back)[0].reason, sounds[0].reason);
    EXPECT_EQ((*back)[0].perturbed.size(), perturbations().size());
    EXPECT_EQ((*back)[1].cell.message, "mu_d exceeds mu_s");
}

// as a newer or a damaged program may have written them
TEST(HeardText, TakesNoWordsThatItDoesNotKnow) {
    std::array<HeardSound, 1> sounds;
    sounds[0].perturbed.assign(perturbations().size(), classification::Category::none);
    const HeardSound good = sounds[0];
    ASSERT_TRUE(unpacked_heard_sounds(packed(sounds)));
    const auto is_refused = [&] {
        const bool refused = !unpacked_heard_sounds(packed(sounds));
        sounds[0] = good;
        return refused;
    };
    sounds[0].cell.status = static_cast<sweep::Status>(99);
    EXPECT_TRUE(is_refused());
    sounds[0].cell.category = static_cast<classification::Category>(99);
    EXPECT_TRUE(is_refused());
    sounds[0].cell.quiet = static_cast<classification::Quiet>(99);
    EXPECT_TRUE(is_refused());
    sounds[0].heard = static_cast<classification::Category>(99);
    EXPECT_TRUE(is_refused());
    sounds[0].perturbed[0] = static_cast<classification::Category>(99);
    EXPECT_TRUE(is_refused());
    sounds[0].perturbed.pop_back();
    EXPECT_TRUE(is_refused());
}

TEST(HeardText, TakesNothingElse) {
    const std::string text = packed(std::array<HeardSound, 1>{});
    EXPECT_FALSE(unpacked_heard_sounds(text + "1:1"));
    EXPECT_FALSE(unpacked_heard_sounds(text.substr(0, text.size() - 3)));
    EXPECT_FALSE(unpacked_heard_sounds("1:9"));
    EXPECT_FALSE(unpacked_cell_sound("1:01:9"));
    EXPECT_FALSE(unpacked_cell_sound(""));
}

using classification::Category;

TEST(HeardCases, AreThoseOfTable1EachPhaseAndTheWhole) {
    const std::vector<HeardCase> cases = hear_table_1({});
    ASSERT_EQ(cases.size(), 4U);
    EXPECT_EQ(cases[0].name, "squeal");
    EXPECT_EQ(cases[3].name, "quiet");
    for (const HeardCase& heard : cases) {
        ASSERT_EQ(heard.phases.size(), 2U) << heard.name;
        EXPECT_FALSE(heard.reason.empty()) << heard.name;
        // by ear as by contact states
        for (const HeardSound& phase : heard.phases)
            EXPECT_EQ(phase.heard, phase.cell.category) << heard.name;
    }
    EXPECT_EQ(cases[0].phases[0].heard, Category::squeal);
    EXPECT_EQ(cases[0].whole, Category::squeal);
    EXPECT_EQ(cases[3].whole, Category::none);
}

TEST(HeardCases, SayWhereTheyWereStopped) {
    std::stop_source stop;
    stop.request_stop();
    HearingOptions options;
    options.stop = stop.get_token();
    const std::optional<Error> thrown = support::error_of([&] { hear_table_1(options); });
    support::expect_error(thrown, "stopped in Table 1", "");
    EXPECT_EQ(thrown->kind(), ErrorKind::interrupted);
}

}  // namespace
}  // namespace stridor::hearing
