#include "stridor/noise_library/sensitivity.hpp"

#include "stridor/noise_library/field.hpp"
#include "support/property.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stridor::noise_library {
namespace {

std::vector<double> some_values(int count, int levels) {
    std::vector<double> values;
    for (int k = 0; k < count; ++k)
        values.push_back(*support::whole_between(0, levels));
    return values;
}

// Spearman, 1904, in his own form without ties: 1 - 6 sum d^2 / (n^3 - n)
TEST(RankCorrelation, IsSpearmansFormWhereNoValuesAreEqual) {
    const std::vector<double> x{106, 86, 100, 101, 99, 103, 97, 113, 112, 110};
    const std::vector<double> y{7, 0, 27, 50, 28, 29, 20, 12, 6, 17};
    const RankCorrelation correlation = rank_correlation(x, y);
    EXPECT_EQ(correlation.records, 10U);
    EXPECT_NEAR(correlation.coefficient, 1.0 - 6.0 * 194.0 / 990.0, 1e-14);
    // Student's approximation with 8 degrees of freedom gives 0.627; 9999 draws scatter by 0.005
    EXPECT_NEAR(correlation.p_value, 0.63, 0.02);
}

// by hand: ranks 1, 2.5, 2.5, 4, 5 and 2, 1, 3.5, 3.5, 5; their products sum to 7.25, their squares to 9.5 each
TEST(RankCorrelation, GivesEqualValuesTheMeanOfTheirRanks) {
    const RankCorrelation correlation =
        rank_correlation(std::vector<double>{1, 2, 2, 3, 5}, std::vector<double>{2, 1, 3, 3, 9});
    EXPECT_NEAR(correlation.coefficient, 7.25 / 9.5, 1e-14);
}

// of the 24 ways to pair 4 values, one rises and one falls throughout
TEST(RankCorrelation, CountsThePairingsOfFewRecords) {
    const RankCorrelation correlation =
        rank_correlation(std::vector<double>{1, 2, 3, 4}, std::vector<double>{1, 8, 9, 70});
    EXPECT_EQ(correlation.coefficient, 1.0);
    EXPECT_NEAR(correlation.p_value, 2.0 / 24.0, 1e-15);
}

TEST(RankCorrelation, SaysNothingOnTwoRecordsOrOneValue) {
    EXPECT_TRUE(std::isnan(rank_correlation(std::vector<double>{1, 2}, std::vector<double>{1, 2}).coefficient));
    EXPECT_TRUE(std::isnan(rank_correlation(std::vector<double>{1, 2, 3}, std::vector<double>{5, 5, 5}).coefficient));
    const std::vector<double> gaps{1, unknown, 3, 4};
    EXPECT_EQ(rank_correlation(gaps, std::vector<double>{1, 2, unknown, 3}).records, 2U);
}

RC_GTEST_PROP(RankCorrelation, LooksAtOrderAlone, ()) {
    const int count = *support::whole_between(3, 30);
    const std::vector<double> x = some_values(count, 20);
    const std::vector<double> y = some_values(count, 20);
    std::vector<double> bent = y;
    std::vector<double> falling = y;
    for (double& value : bent)
        value = value * value * value;
    for (double& value : falling)
        value = -value;
    const double rho = rank_correlation(x, y).coefficient;
    if (std::isnan(rho)) return;
    RC_ASSERT(rho >= -1.0 && rho <= 1.0);
    RC_ASSERT(rank_correlation(x, bent).coefficient == rho);
    RC_ASSERT(std::abs(rank_correlation(x, falling).coefficient + rho) < 1e-12);
    RC_ASSERT(std::abs(rank_correlation(y, x).coefficient - rho) < 1e-12);
}

std::vector<Entry> records(std::span<const double> preloads) {
    std::vector<Entry> entries;
    for (const double preload : preloads) {
        Entry entry;
        entry.id = static_cast<std::int64_t>(entries.size()) + 1;
        entry.preload = preload;
        entry.category = preload < 20.0 ? "squeal" : "creak";
        set_figure(entry, {level_figure, "dB", 40.0 + preload});
        set_figure(entry, {frequency_figure, "Hz", 1000.0 - preload});
        entries.push_back(entry);
    }
    return entries;
}

TEST(Sensitivity, TellsHowCategoryLevelAndFrequencyMove) {
    std::vector<Entry> entries = records(std::vector<double>{40, 10, 10, 5, 40, unknown});
    entries[2].category = "";
    entries[2].figures.clear();
    const Sensitivity result = sensitivity(entries, {});
    EXPECT_EQ(result.left_out, 1U);
    ASSERT_EQ(result.bins.size(), 3U);
    EXPECT_EQ(result.bins[1].from, 10.0);
    EXPECT_EQ(result.bins[1].records, 2U);
    EXPECT_EQ(result.bins[1].level, 50.0);
    EXPECT_EQ(result.bins[2].frequency, 960.0);
    ASSERT_EQ(result.categories.size(), 3U);
    EXPECT_EQ(result.categories[0].category, "squeal");
    EXPECT_EQ(result.categories[0].highest, 10.0);
    EXPECT_EQ(result.categories[1].category, "creak");
    EXPECT_EQ(result.categories[1].records, 2U);
    EXPECT_EQ(result.categories[2].category, "");
    EXPECT_EQ(result.level.records, 4U);
    EXPECT_NEAR(result.level.coefficient, 1.0, 1e-14);
    EXPECT_NEAR(result.frequency.coefficient, -1.0, 1e-14);
    EXPECT_EQ(result.level_unit, "dB");
}

TEST(Sensitivity, TakesTheEngineersWordsWhereAsked) {
    std::vector<Entry> entries = records(std::vector<double>{1, 2, 3});
    entries[0].denomination = "groan";
    SensitivityOptions options;
    options.judge = Judge::engineer;
    const Sensitivity result = sensitivity(entries, options);
    ASSERT_EQ(result.categories.size(), 2U);
    EXPECT_EQ(result.categories[0].category, "groan");
}

TEST(Sensitivity, SaysWhereLevelsHaveDifferentUnits) {
    std::vector<Entry> entries = records(std::vector<double>{1, 2, 3});
    set_figure(entries[0], {level_figure, "dB(A)", 60.0});
    EXPECT_EQ(sensitivity(entries, {}).level_unit, "mixed");
}

RC_GTEST_PROP(Sensitivity, BinsHoldEachRecordOnceAndKeepEqualValuesTogether, ()) {
    const std::vector<double> values = some_values(*support::whole_between(0, 60), *support::whole_between(1, 100));
    SensitivityOptions options;
    options.bins = static_cast<std::size_t>(*support::whole_between(0, 12));
    const Sensitivity result = sensitivity(records(values), options);
    std::size_t total = 0;
    for (std::size_t k = 0; k < result.bins.size(); ++k) {
        const Bin& bin = result.bins[k];
        total += bin.records;
        RC_ASSERT(bin.records > 0U && bin.from <= bin.to);
        if (k > 0) RC_ASSERT(result.bins[k - 1].to < bin.from);
        std::size_t counted = 0;
        for (const CategoryCount& count : bin.categories)
            counted += count.records;
        RC_ASSERT(counted == bin.records);
    }
    RC_ASSERT(total == values.size());
    if (options.bins > 0U) RC_ASSERT(result.bins.size() <= options.bins);
}

}  // namespace
}  // namespace stridor::noise_library
