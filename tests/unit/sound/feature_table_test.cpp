#include "stridor/sound/feature_table.hpp"

#include <gtest/gtest.h>

#include <set>

namespace stridor::sound {
namespace {

TEST(FeatureTable, HoldsEachFeatureOnce) {
    const SoundFeatures features;
    std::set<std::string_view> names;
    std::set<const double*> members;
    for (const SoundFeature& feature : feature_table) {
        names.insert(feature.name);
        members.insert(&(features.*feature.member));
        EXPECT_FALSE(feature.unit.empty()) << feature.name;
    }
    EXPECT_EQ(names.size(), feature_table.size());
    EXPECT_EQ(members.size(), feature_table.size());
}

TEST(FeatureTable, LeavesOutWhatIsToldInWordsOfItsOwn) {
    const SoundFeatures features;
    for (const SoundFeature& feature : feature_table)
        for (const double* other : {&features.from, &features.duration, &features.mean_square, &features.peak})
            EXPECT_NE(&(features.*feature.member), other) << feature.name;
}

TEST(FeatureTable, FindsTheRowOfAMember) {
    EXPECT_EQ(feature_of(&SoundFeatures::tonality).name, "tonality");
    EXPECT_EQ(feature_of(&SoundFeatures::trend).unit, "dB/s");
}

}  // namespace
}  // namespace stridor::sound
