// The soft parts hold what the study of each promises: valid in every cell, long enough for its slowest beat.

#include "stridor/sweep/ready_charts.hpp"

#include "stridor/base/quantity.hpp"
#include "stridor/hearing/hearing.hpp"
#include "stridor/model/built/rubbing_system.hpp"
#include "stridor/model/linear/frequencies.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/fields/field_name.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/parameters/rules/check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

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
    const parameters::Joint stiff = parameters::paper_case(parameters::PaperCase::squeal).joint();
    for (const SoftPart part : every_part())
        EXPECT_LE(soft_part(part).base.joint().flexural_stiffness, stiff.flexural_stiffness) << name_of(part);
}

// "25 N/mm J (5 to 100)": the number and its unit; without a unit, the number
std::string number_and_unit(const std::string& cell) {
    std::istringstream words(cell);
    std::string number, unit;
    words >> number >> unit;
    std::erase(unit, '\\');
    return unit.size() == 1 && std::string_view("SDFJ").find(unit) != std::string_view::npos ? number
                                                                                             : number + " " + unit;
}

// the rows of a table of a page, by their first cell; the rest as it stands
std::map<std::string, std::vector<std::string>> table_of(const std::string& page) {
    std::ifstream file(STRIDOR_SOURCE_DIR + page);
    std::map<std::string, std::vector<std::string>> rows;
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("| ")) continue;
        std::istringstream cells(line.substr(2));
        std::string name, cell;
        std::getline(cells, name, '|');
        name.erase(name.find_last_not_of(' ') + 1);
        while (std::getline(cells, cell, '|'))
            rows[name].push_back(cell);
    }
    return rows;
}

// whose words say where each number comes from
TEST(SoftParts, HoldTheNumbersOfTheirPage) {
    constexpr std::array parts{SoftPart::weatherstrip, SoftPart::glass_run, SoftPart::clip, SoftPart::wiper,
                               SoftPart::brake_pad};
    constexpr std::array<std::pair<const char*, const char*>, 14> rows{{
        {"mass", "joint.mass"},
        {"axial stiffness", "joint.axial_stiffness"},
        {"flexural stiffness", "joint.flexural_stiffness"},
        {"axial damping", "joint.axial_damping"},
        {"flexural damping", "joint.flexural_damping"},
        {"incidence angle", "joint.incidence_angle"},
        {"plate: mass", "plate.mass"},
        {"plate: stiffness", "plate.stiffness"},
        {"plate: damping", "plate.damping"},
        {"preload", "contact.preload"},
        {"static friction", "contact.static_friction"},
        {"kinetic friction", "contact.kinetic_friction"},
        {"velocity", "drive.velocity"},
        {"simulated, of it judged", "run.duration"},
    }};
    const auto table = table_of("/docs/methods/soft-parts.md");
    for (const auto& [words, key] : rows) {
        const auto row = table.find(words);
        ASSERT_NE(row, table.end()) << words;
        ASSERT_EQ(row->second.size(), parts.size()) << words;
        const parameters::Field& field = parameters::quantity_named(key);
        for (std::size_t k = 0; k < parts.size(); ++k) {
            std::string text = row->second[k];
            text.erase(std::min(text.find(','), text.size()));
            const double written = base::parse_quantity(number_and_unit(text), parameters::unit_of(field));
            const double held = parameters::get_quantity(soft_part(parts[k]).base, field);
            EXPECT_NEAR(held, written, 1e-12 * written) << name_of(parts[k]) << ", " << words;
        }
    }
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const Study study = soft_part(parts[k]);
        for (const auto& [words, axis] : {std::pair{"x of its chart", study.x}, {"y of its chart", study.y}}) {
            std::istringstream section_and_name(table.at(words).at(k));
            std::string first, second;
            section_and_name >> first >> second;
            EXPECT_TRUE(axis.parameter.ends_with(second.empty() ? first : first + "_" + second))
                << axis.parameter << ", " << name_of(parts[k]);
        }
    }
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
    c.contact().preload = 80.0;
    c.contact().kinetic_friction = 0.21;
    constexpr std::array going{Direction::going};
    integration::Workspace workspace;
    const std::vector<hearing::HeardSound> sounds = hearing::hear(c, going, {}, {}, workspace);
    ASSERT_EQ(sounds.size(), 1u);
    EXPECT_EQ(sounds[0].cell.category, classification::Category::creak);
    EXPECT_EQ(sounds[0].heard, classification::Category::creak) << sounds[0].reason;
}

}  // namespace
}  // namespace stridor::sweep
