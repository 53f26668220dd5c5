#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace stridor::base {

/// Exponents of the base quantities a unit is made of. Angles and temperatures are dimensions of their own, so that
/// "70 deg" can never be taken for a plain number.
struct Dimension {
    int mass = 0;
    int length = 0;
    int time = 0;
    int angle = 0;
    int current = 0;
    int temperature = 0;
    bool operator==(const Dimension&) const = default;
};

/// A unit: its dimension, and the size of one such unit in SI (angles: degrees; temperatures: degrees Celsius).
struct Unit {
    Dimension dimension;
    double factor = 1.0;
};

/// Returns "a force (N)", "a length (m)", "a plain number", or the exponents if the field has no word for them.
std::string describe(Dimension dimension);

/// Reads a unit such as "N", "kN/mm", "N*s/m", "N s/m", "Ns/m", "m/s^2", "rpm", "deg", "%" or "1".
///
/// Throws `Error` (input) that names the unknown symbol, and suggests the same unit in other letters ("n": N) or a unit
/// one letter away, if there is any.
Unit parse_unit(std::string_view text);

/// Reads a unit; returns `std::nullopt` if the text is not a unit.
std::optional<Unit> find_unit(std::string_view text);

/// Reads a number, with or without a unit, into the SI value of a quantity that is measured in `unit`.
///
/// "20" and "20 N" both read as 20 for unit "N"; "4 mm" as 0.004 for unit "m". Throws `Error` (input) that names both
/// dimensions when they differ, and for anything that is not one finite number with at most one unit. It suggests units
/// of the wanted dimension only.
double parse_quantity(std::string_view text, std::string_view unit);

}  // namespace stridor::base
