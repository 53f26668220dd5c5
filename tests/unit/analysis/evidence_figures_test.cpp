#include "stridor/analysis/evidence_figures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace stridor::analysis {
namespace {

const EvidenceFigure& figure(std::string_view name) {
    const auto figures = evidence_figures();
    return *std::find_if(figures.begin(), figures.end(), [&](const EvidenceFigure& each) { return each.name == name; });
}

TEST(EvidenceFigures, HaveNamesAndKeysOfTheirOwn) {
    std::set<std::string_view> names;
    std::set<std::string_view> keys;
    for (const EvidenceFigure& each : evidence_figures()) {
        EXPECT_TRUE(names.insert(each.name).second) << each.name;
        EXPECT_TRUE(keys.insert(each.key).second) << each.key;
        EXPECT_FALSE(each.unit.empty()) << each.name;
        EXPECT_FALSE(each.sentence.empty()) << each.name;
    }
}

TEST(EvidenceFigures, AreReadFromTheEvidence) {
    Evidence evidence;
    evidence.rates = {0.5, 0.25, 0.125};
    evidence.judged_rates = {0.75, 0.0625, 0.03125};
    evidence.alternation.intervals = 7;
    evidence.alternation.lag = 3;
    evidence.releases = 9;
    evidence.levels.plate.peak_decibels = 120.0;
    const std::map<std::string_view, double> expected{{"slip", 0.5},
                                                      {"stick", 0.25},
                                                      {"separation", 0.125},
                                                      {"judged_slip", 0.75},
                                                      {"judged_stick", 0.0625},
                                                      {"judged_separation", 0.03125},
                                                      {"intervals", 7.0},
                                                      {"lag", 3.0},
                                                      {"releases", 9.0},
                                                      {"plate_peak_level", 120.0}};
    for (const auto& [name, value] : expected)
        EXPECT_EQ(figure(name).value(evidence), value) << name;
}

TEST(EvidenceFigures, ShareTheUnitOfTheirObject) {
    EXPECT_EQ(unit_key(figure("judged_stick")), "judged_rates");
    EXPECT_EQ(unit_key(figure("regularity")), "regularity");
    EXPECT_EQ(unit_key(figure("joint_rms")), "levels.rms");
    EXPECT_EQ(unit_key(figure("plate_peak_level")), "levels.peak_level");
    EXPECT_EQ(unit_key(figure("releases")), "");
}

// one unit for all that share a key of it
TEST(EvidenceFigures, OfOneUnitKeyHaveOneUnit) {
    std::map<std::string, std::string_view> units;
    for (const EvidenceFigure& each : evidence_figures()) {
        const std::string key = unit_key(each);
        if (key.empty()) continue;
        EXPECT_EQ(units.emplace(key, each.unit).first->second, each.unit) << each.name;
    }
}

}  // namespace
}  // namespace stridor::analysis
