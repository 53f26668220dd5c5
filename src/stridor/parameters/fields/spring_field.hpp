#pragma once

#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/own_spring.hpp"

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// What a spring of an own structure has: each thing stands here once. The keys of [[structure.spring]], their checks,
/// the schema, packed cases, documents and Python are made from it.
namespace stridor::parameters {

/// Where a spring keeps one thing: text, a number, a direction over the rows, a table, how that is read.
using SpringMember = std::variant<std::string OwnSpring::*, double OwnSpring::*, std::vector<double> OwnSpring::*,
                                  ForceTable OwnSpring::*, Interpolation OwnSpring::*>;

/// One thing that a spring has. What it is without its key stands in `OwnSpring`.
struct SpringField {
    std::string_view key;       // "cubic"
    std::string_view unit;      // SI, "1" when dimensionless, empty for text
    std::string_view sentence;  // what it is, one line
    SpringMember member;
    Range range{};  // of a number
};

/// Returns all of them, in the order files list them.
std::span<const SpringField> spring_fields();

/// Returns the one with this key; it must be there.
const SpringField& spring_field(std::string_view key);

/// Says whether a value is what a spring has that does not name it.
bool is_usual(const OwnSpring& spring, const SpringField& field);

/// What a spring has of it: text, a number, or several.
using SpringValue = std::variant<std::string, double, std::vector<double>>;
SpringValue value_of(const OwnSpring& spring, const SpringField& field);

}  // namespace stridor::parameters
