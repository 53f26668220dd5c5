// The soft parts hold what the study of each promises: valid in every cell, long enough for its slowest beat.

#include "stridor/sweep/soft_parts.hpp"

#include "stridor/hearing/hearing.hpp"
#include "stridor/model/frequencies.hpp"
#include "stridor/model/rubbing_system.hpp"
#include "stridor/parameters/check.hpp"
#include "stridor/parameters/paper_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

namespace stridor::sweep {
namespace {

using parameters::Direction;
using parameters::DriveKind;

constexpr double two_pi = 6.283185307179586;

std::vector<SoftPart> every_part() {
    std::vector<SoftPart> parts;
    for (std::size_t k = 0; k < soft_part_names.size(); ++k)
        parts.push_back(static_cast<SoftPart>(k));
    return parts;
}

std::string_view name_of(SoftPart part) {
    return soft_part_names[static_cast<std::size_t>(part)].name;
}

TEST(SoftParts, AreCalledByDifferentNamesAndTitles) {
    std::set<std::string> names;
    std::set<std::string> titles;
    for (const SoftPart part : every_part()) {
        names.emplace(name_of(part));
        titles.insert(soft_part(part).base.title);
    }
    EXPECT_EQ(names.size(), soft_part_names.size());
    EXPECT_EQ(titles.size(), soft_part_names.size());
}

TEST(SoftParts, AreValidInEveryCell) {
    for (const SoftPart part : every_part()) {
        const Study study = soft_part(part);
        EXPECT_NO_THROW(check(study)) << name_of(part);
        for (std::size_t index = 0; index < cell_count(study); ++index)
            EXPECT_TRUE(parameters::findings(case_at(study, place_of(study, index))).empty())
                << name_of(part) << ", cell " << index;
    }
}

TEST(SoftParts, AreSofterAcrossTheirAxisThanTheStiffJointOfTable1) {
    const parameters::Joint stiff = parameters::paper_case(parameters::PaperCase::squeal).joint;
    for (const SoftPart part : every_part())
        EXPECT_LE(soft_part(part).base.joint.flexural_stiffness, stiff.flexural_stiffness) << name_of(part);
}

// sliding without friction, the slowest vibration between two sticks
TEST(SoftParts, AreJudgedOverTensOfTheirSlowestPeriods) {
    constexpr double least = 30.0;
    for (const SoftPart part : every_part()) {
        const parameters::Case c = soft_part(part).base;
        const std::vector<double> omega =
            model::natural_frequencies(model::rubbing_system(c), model::ContactState::slip);
        EXPECT_GE(c.run.window * omega.front() / two_pi, least) << name_of(part);
    }
}

TEST(SoftParts, AreJudgedByTheSecondHalf) {
    for (const SoftPart part : every_part()) {
        const Study study = soft_part(part);
        EXPECT_EQ(study.base.run.window, 0.5 * study.base.run.duration) << name_of(part);
        const bool is_shaken = part == SoftPart::weatherstrip_shaken;
        EXPECT_EQ(study.base.drive.kind, is_shaken ? DriveKind::sinusoidal : DriveKind::constant) << name_of(part);
    }
}

// The clip's slips come every 0.19 s with rest between them: no knock, but a creak, as the contact states have it.
TEST(SoftParts, ASlowCreakOfAClipIsHeardAsACreak) {
    parameters::Case c = soft_part(SoftPart::clip).base;
    c.contact.preload = 80.0;
    c.contact.kinetic_friction = 0.21;
    constexpr std::array going{Direction::going};
    integration::Workspace workspace;
    const std::vector<hearing::HeardSound> sounds = hearing::hear(c, going, {}, {}, workspace);
    ASSERT_EQ(sounds.size(), 1u);
    EXPECT_EQ(sounds[0].cell.category, classification::Category::creak);
    EXPECT_EQ(sounds[0].heard, classification::Category::creak) << sounds[0].reason;
}

}  // namespace
}  // namespace stridor::sweep
