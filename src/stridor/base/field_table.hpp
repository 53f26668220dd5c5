#pragma once

#include "stridor/base/error.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <string_view>

/// Functions for tables of named rows of any kind: find a row, write a value, refuse a wrong one.
namespace stridor::base {

/// Returns the row with this name, or null if there is none.
template <typename Rows>
auto find_named(const Rows& rows, std::string_view name) -> decltype(&*std::begin(rows)) {
    const auto found =
        std::find_if(std::begin(rows), std::end(rows), [&](const auto& row) { return row.name == name; });
    return found == std::end(rows) ? nullptr : &*found;
}

/// Returns "Did you mean \"preload\"?" for a misspelt name if one of `names` is near, else `otherwise`.
std::string did_you_mean(std::string_view name, std::span<const std::string_view> names, std::string otherwise = {});

/// Returns that question, or `otherwise`, for names that are made while the program runs.
std::string did_you_mean(std::string_view name, std::span<const std::string> names, std::string otherwise = {});

/// Returns the place of a choice among its names.
///
/// Throws `Error` (input) if it is not among them: run.engine = "exakt" is not one of its choices (choices: "exact",
/// "beta_2", "moreau"). Did you mean "exact"?
std::size_t place_of_choice(std::string_view key, std::string_view choice, std::span<const std::string_view> names,
                            std::optional<Place> place = std::nullopt);

/// Returns a number with its unit as a user would write it: "20 N", "0.6". The number is the shortest that reads back
/// the same.
std::string quantity_text(double value, std::string_view unit);

/// Says whether the lower end of a range belongs to it. The upper end always does.
enum class LowEnd { closed, open };

/// Returns what a quantity must be: "above 0 kg", "at least 0 N", "between 0 and 100 %", "finite".
std::string limits_text(double low, double high, std::string_view unit, LowEnd low_end = LowEnd::closed);

}  // namespace stridor::base
