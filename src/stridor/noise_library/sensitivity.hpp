#pragma once

#include "stridor/noise_library/library.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// How a noise changes over a quantity across the records of a library: the question of a test rig.
///
/// The rank correlation (Spearman 1904) is Pearson's coefficient of the ranks, equal values sharing the mean of their
/// ranks. It is 1 if one quantity never falls while the other rises, -1 if it never rises. It depends on order alone,
/// so a bent but steady relation counts in full. Its p-value is the share of all pairings of the values that correlate
/// at least as strongly in either direction: counted one by one up to 8 records, beyond that estimated by 9999 pairings
/// drawn from a fixed seed. A small p-value means that chance alone seldom does it; it does not mean that the quantity
/// is the cause, for quantities that were varied together cannot be distinguished.
namespace stridor::noise_library {

/// The source of the category: Stridor's verdict or the engineer's word.
enum class Judge { stridor, engineer };

/// One record.
struct Observation {
    std::int64_t id = 0;
    double quantity = 0.0;       // [unit of the quantity]
    std::string category;        // empty: nobody said
    double level = unknown;      // [unit of the level]
    double frequency = unknown;  // [Hz]
};

/// Spearman's coefficient over the records that have both values.
struct RankCorrelation {
    std::size_t records = 0;
    double coefficient = unknown;  // [1] -1 to 1; unknown below 3 records or where all values are equal
    double p_value = unknown;      // [1]
};

/// Records of one category.
struct CategoryCount {
    std::string category;
    std::size_t records = 0;
};

/// Records whose quantity lies from `from` to `to`, both included.
struct Bin {
    double from = 0.0;
    double to = 0.0;
    std::size_t records = 0;
    std::vector<CategoryCount> categories;  // those that occur, in the order of `Sensitivity::categories`
    double level = unknown;                 // median
    double frequency = unknown;             // [Hz] median
};

/// The range of the quantity in which a category occurs.
struct CategoryRange {
    std::string category;
    std::size_t records = 0;
    double lowest = unknown;
    double median = unknown;
    double highest = unknown;
};

/// The change of category, level and frequency of records over a quantity.
struct Sensitivity {
    std::string quantity;
    std::string unit;
    std::string level_unit;                 // of the records' figure; "mixed" if they differ
    std::vector<Observation> records;       // by quantity, then id
    std::size_t left_out = 0;               // records in which the quantity is unknown
    std::vector<CategoryRange> categories;  // Stridor's five in their order, then the engineer's own words
    std::vector<Bin> bins;
    RankCorrelation level;
    RankCorrelation frequency;
};

/// Which quantity, in which unit, in how many bins, and by whose verdict.
struct SensitivityOptions {
    std::string quantity = "preload";  // a quantity of the field table or a figure
    std::string unit = "N";
    std::size_t bins = 0;  // 0: one per value up to 10 values, else 6
    Judge judge = Judge::stridor;
};

/// Returns the sensitivity over entries that were read with their figures.
Sensitivity sensitivity(std::span<const Entry> entries, const SensitivityOptions& options);

/// Returns the unit of a field or figure that is a number, over which records can be plotted; throws `Error` (input)
/// for any other name.
std::string unit_over(Library& library, const std::string& name);

/// Returns the sensitivity over the entries of a library that meet a query, in the quantity's own unit. Throws `Error`
/// (input) if the name is not a quantity, and if no record has it.
Sensitivity sensitivity_in(Library& library, Query query, SensitivityOptions options);

/// Returns Spearman's coefficient of pairs, with its p-value; a pair with an unknown value is left out. Equal shapes.
RankCorrelation rank_correlation(std::span<const double> x, std::span<const double> y);

}  // namespace stridor::noise_library
