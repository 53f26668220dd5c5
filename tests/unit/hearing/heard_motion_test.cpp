#include "stridor/hearing/heard_motion.hpp"

#include "stridor/analysis/evidence.hpp"
#include "stridor/hearing/hearing.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/hearing/sound_comparison.hpp"
#include "stridor/io/case/ready_files.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/signal/level.hpp"
#include "support/effort.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace stridor::hearing {
namespace {

using parameters::Case;
using signal::MotionQuantity;
using support::thrown_by;

// two lips that both squeal, the upper at the higher level, while the pane comes; the lower while it goes
Case lips(parameters::Direction direction) {
    Case c = parameters::two_lips();
    c.drive.velocity = direction == parameters::Direction::going ? 0.1 : -0.1;
    c.run.duration = support::effort(c.run.duration, 0.6);
    c.run.window = support::effort(c.run.window, 0.3);
    return c;
}

// two masses on springs; the first sticks to the belt, the second rubs with its own friction
Case blocks() {
    Case c = parameters::paper_case(parameters::PaperCase::squeal);
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = 0.1;
    c.contact() = {};
    c.contact().preload = 2.0;
    c.contact().static_friction = 1.0;
    c.contact().kinetic_friction = 0.5;
    c.run.duration = 4.0;
    c.run.window = 4.0;
    auto own = std::make_shared<parameters::OwnStructure>();
    own->row = {"x1", "y1", "x2", "y2"};
    own->mass = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    own->stiffness = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 100, 0, 0, 0, 0, 1};
    own->contacts = {{.name = "slow", .normal = {0, 1, 0, 0}, .tangent = {1, 0, 0, 0}, .preload_share = 1.0},
                     {.name = "fast", .normal = {0, 0, 0, 1}, .tangent = {0, 0, 1, 0}, .preload_share = 1.0}};
    c.own_structure = own;
    return c;
}

double energy_of(const Case& c, const std::string& of) {
    sound::AuralisationSettings settings;
    settings.rate = 8000.0;
    settings.pickup = heard_motion(c, {of}).pickup;
    settings.stretches = heard_stretches(c, parameters::Direction::going);
    double square = 0.0;
    for (const double sample : sound_of_case(c, settings).samples)
        square += sample * sample;
    return square;
}

TEST(HeardMotion, IsThatOfTheStrongestOfSeveralJoints) {
    const HeardMotion first = heard_motion(lips(parameters::Direction::coming), {});
    EXPECT_EQ(first.of, "upper");
    EXPECT_EQ(first.pickup.weights, parameters::weight_of_one(lips(parameters::Direction::coming), 0));
    const Case c = lips(parameters::Direction::going);
    const HeardMotion second = heard_motion(c, {});
    EXPECT_EQ(second.of, "lower");
    EXPECT_EQ(second.contact, std::optional<std::size_t>(1));
    EXPECT_EQ(second.pickup.weights, parameters::weight_of_one(c, 2));
    EXPECT_EQ(motion_words(second), "lower velocity along x");
    // what is heard of it, too, is the stronger one
    EXPECT_GT(energy_of(c, "lower"), energy_of(c, "upper"));
    EXPECT_EQ(energy_of(c, "joint"), energy_of(c, "lower"));
}

TEST(HeardMotion, TakesTheFirstOfEqualContacts) {
    Case c = lips(parameters::Direction::coming);
    c.joints[1].joint = c.joint();
    c.joints[1].contact = c.contact();
    EXPECT_EQ(heard_motion(c, {}).of, "upper");
}

TEST(HeardMotion, IsThatOfAContactOfAnOwnStructure) {
    const Case c = blocks();
    // the soft spring lets the first one stick for 10 s, and so all the time; the other is let go again and again
    const HeardMotion heard = heard_motion(c, {});
    EXPECT_EQ(heard.of, "fast");
    EXPECT_EQ(heard.pickup.weights, c.own_structure->contacts[1].tangent);
    EXPECT_EQ(heard_motion(c, {"fast", "y"}).pickup.weights, c.own_structure->contacts[1].normal);
    EXPECT_EQ(heard_motion(c, {"x2"}).pickup.weights, parameters::weight_of_one(c, 2));
    EXPECT_EQ(motion_words(heard_motion(c, {"x2"})), "x2 velocity");
    EXPECT_EQ(motion_words(c, {}), "velocity along x of the strongest contact");
    EXPECT_TRUE(thrown_by([&] { heard_motion(c, {"plate"}); }).says("is no contact, output or row"));
    EXPECT_TRUE(thrown_by([&] { heard_motion(c, {"x2", "y"}); }).says("it has one direction"));
}

TEST(HeardMotion, IsThatOfAnOutputWhereThereIsOne) {
    Case c = blocks();
    auto own = std::make_shared<parameters::OwnStructure>(*c.own_structure);
    own->outputs = {{"mean", {0.5, 0, 0.5, 0}}, {"stretch", {1, 0, -1, 0}}};
    c.own_structure = own;
    EXPECT_EQ(heard_motion(c, {}).pickup.weights, own->outputs[0].weights);
    EXPECT_EQ(motion_words(c, {}), "mean velocity");
    EXPECT_EQ(heard_motion(c, {"stretch"}).of, "stretch");
    EXPECT_EQ(heard_motion(c, {"slow"}).contact, std::optional<std::size_t>(0));
    EXPECT_TRUE(thrown_by([&] { heard_motion(c, {"mean", "x"}); }).says("it has one direction"));
    // a mean of two motions is heard as the mean of their sounds
    const auto sound = [&](const std::string& of) {
        sound::AuralisationSettings settings;
        settings.rate = 8000.0;
        settings.pickup = heard_motion(c, {of}).pickup;
        return sound_of_case(c, settings).samples;
    };
    const std::vector<double> mean = sound("mean"), first = sound("x1"), second = sound("x2");
    ASSERT_EQ(mean.size(), first.size());
    for (std::size_t k = 0; k < mean.size(); ++k)
        ASSERT_NEAR(mean[k], 0.5 * (first[k] + second[k]), 1e-12);
}

TEST(HeardMotion, OfARunWithoutResultIsThatOfTheFirst) {
    Case c = blocks();
    c.contact().kinetic_friction = 2.0;  // above the static one: no case at all
    EXPECT_EQ(heard_motion(c, {}).of, "slow");
}

TEST(HeardMotion, IsInEvaluationsThatOfTheStrongest) {
    const Case c = lips(parameters::Direction::going);
    constexpr std::array directions{parameters::Direction::going};
    integration::Workspace workspace;
    HearingSettings settings;
    const std::vector<HeardSound> strongest = hear(c, directions, settings, {}, workspace);
    settings.motion.of = "lower";
    const std::vector<HeardSound> lower = hear(c, directions, settings, {}, workspace);
    settings.motion.of = "upper";
    const std::vector<HeardSound> upper = hear(c, directions, settings, {}, workspace);
    ASSERT_EQ(strongest.size(), 1U);
    EXPECT_EQ(strongest[0].features.mean_square, lower[0].features.mean_square);
    EXPECT_NE(strongest[0].features.mean_square, upper[0].features.mean_square);
}

TEST(HeardMotion, StandsBesideRecordingsWithTheStatesOfItsContact) {
    ComparisonSettings settings;
    settings.rate = 8000.0;
    const classification::ComparedSound sound = compared({"b", "b", "simulation", SimulatedSound{blocks()}}, settings);
    EXPECT_EQ(sound.what, "fast velocity along x");
    EXPECT_EQ(sound.contact.histories.size(), 1U);
}

TEST(MotionWords, SayWhatMovesAndWhereTo) {
    const Case c = parameters::paper_case(parameters::PaperCase::squeal);
    EXPECT_EQ(motion_words(heard_motion(c, {})), "joint velocity along x");
    EXPECT_EQ(motion_words(c, {}), "joint velocity along x");
    EXPECT_EQ(motion_words(heard_motion(c, {"joint", "y"})), "joint velocity along y");
    EXPECT_EQ(motion_words(heard_motion(c, {"plate", "", MotionQuantity::acceleration})), "plate acceleration along y");
    EXPECT_EQ(motion_words(c, {"plate", "", MotionQuantity::acceleration}), "plate acceleration along y");
    EXPECT_TRUE(thrown_by([&] { heard_motion(c, {"plate", "x"}); }).says("is imposed"));
    EXPECT_TRUE(thrown_by([&] { heard_motion(c, {"plat"}); }).says("nothing that moves"));
}

// A run taken apart into its modes: all of them are what is heard, and harmonics of a string are its modes.

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
