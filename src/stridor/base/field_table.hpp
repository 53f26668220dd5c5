#pragma once

#include "stridor/base/error.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <string_view>

/// What tables of named rows have in common, whatever the rows are about: how one is found, how a value is written and
/// how a wrong one is refused.
namespace stridor::base {

/// The row with this name; null if there is none.
template <typename Rows>
auto find_named(const Rows& rows, std::string_view name) -> decltype(&*std::begin(rows)) {
    const auto found =
        std::find_if(std::begin(rows), std::end(rows), [&](const auto& row) { return row.name == name; });
    return found == std::end(rows) ? nullptr : &*found;
}

/// "Did you mean \"preload\"?" for a misspelt name, if one of the names is near; else `otherwise`.
std::string did_you_mean(std::string_view name, std::span<const std::string_view> names, std::string otherwise = {});

/// The same for names that are made while the program runs.
std::string did_you_mean(std::string_view name, std::span<const std::string> names, std::string otherwise = {});

/// The place of a choice among its names.
///
/// Throws `Error` (input) for any other: run.engine = "exakt" is not one of its choices (choices: "exact", "beta_2",
/// "moreau").
/// Did you mean "exact"?
std::size_t place_of_choice(std::string_view key, std::string_view choice, std::span<const std::string_view> names,
                            std::optional<Place> place = std::nullopt);

/// A number with its unit as a user would write it: "20 N", "0.6"; shortest round-trip numbers.
std::string quantity_text(double value, std::string_view unit);

/// Does the lower end of a range belong to it? The upper one does.
enum class LowEnd { closed, open };

/// What a quantity must be: "above 0 kg", "at least 0 N", "between 0 and 100 %", "finite".
std::string limits_text(double low, double high, std::string_view unit, LowEnd low_end = LowEnd::closed);

}  // namespace stridor::base
