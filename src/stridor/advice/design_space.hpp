#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/parameters/field.hpp"
#include "stridor/record/schedule.hpp"
#include "stridor/sweep/study.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The designs around a case: which of its quantities may be changed, how far, and how each changed case is judged.
///
/// A design is a point of a box. Its coordinates are *shares*: 0 at one end of a parameter's range and 1 at the other,
/// on the scale of the range, so that equal steps are equal differences on a linear scale and equal ratios on a
/// logarithmic one. The distance of two designs is the Euclidean one of their shares: how far a designer has to go,
/// measured by how far designers go. docs/methods/advice.md says why.
namespace stridor::advice {

/// A quantity that may be changed, and between which values.
struct DesignParameter {
    std::string key;    // "contact.preload"
    double from = 0.0;  // in the field's unit, below `to`
    double to = 1.0;
    sweep::Scale scale = sweep::Scale::linear;  // logarithmic: both ends have the same sign
};

/// The value at a share of the range, 0 <= share <= 1; the same bits on every machine, ends exact.
double value_at(const DesignParameter& parameter, double share);

/// The share at which a value of the range stands.
double share_of(const DesignParameter& parameter, double value);

/// A point of the box, shape [parameter].
using Shares = std::vector<double>;

/// One of the motions that a design is judged by.
struct DesignRun {
    std::optional<parameters::Direction> direction{};  // of a constant drive; nothing: the drive turns round by itself
    parameters::Initial start = parameters::Initial::rest;
};

/// Which motions a design is judged by. Whoever uses it moves it both ways, and knows nothing of how it begins.
struct AskedRuns {
    std::vector<parameters::Direction> directions{};  // empty: both
    std::vector<parameters::Initial> starts{};        // empty: all with which the case can begin, its own first
};

/// A case and the box of designs around it.
struct DesignSpace {
    parameters::Case base;
    std::vector<DesignParameter> parameters;
    Shares origin;                      // where the base case stands, shape [parameter]
    std::vector<std::size_t> free;      // the parameters that a change may concern; the others are only followed
    std::vector<record::Phase> phases;  // what is judged: going and coming; `all` of a surface that stands still
    std::vector<DesignRun> runs;        // by which, the case's own start first in each direction
};

/// A range that a user asks for by name; without ends the usual one around the case (`parameters::usual_range`).
struct AskedRange {
    std::string name;  // in any spelling of `quantity_key_called`
    std::optional<double> from{};
    std::optional<double> to{};
};

/// `parameters::quantity_key_called`, which also throws `Error` (input) if the quantity changes nothing in this case,
/// or is of a joint that it does not have.
std::string quantity_key_called(const parameters::Case& c, std::string_view name);

/// Throws `Error` (input) for a key of all joints in which they differ: the design has no one value of it.
void expect_one_value(const parameters::Case& c, std::string_view key);

/// The space of the ranges asked for, all of them free, or, if there are none, of all that a designer varies
/// (`parameters::design_keys`). Of these the drive is not free: a product has to bear how it is moved, so its margins
/// are of interest, but advice to move it otherwise is not. A range is widened to hold the case's own value.
///
/// Throws `Error` (input) for a name that is none or comes twice, for ends out of the field's range or order, for a
/// quantity without a usual range whose ends are not given, for directions and starts that this case does not have, and
/// for a case with `parameters::findings`.
DesignSpace design_space(const parameters::Case& c, std::span<const AskedRange> asked = {}, const AskedRuns& runs = {});

/// The starts of a space's runs, each once.
std::vector<parameters::Initial> starts_of(const DesignSpace& space);

/// The case of a run: the direction and the start put in.
parameters::Case case_of(const parameters::Case& design, const DesignRun& run);

/// A design, by what of the space's base case is otherwise.
struct Design {
    struct Setting {
        std::string key;
        double value = 0.0;  // in the field's unit
    };
    std::vector<Setting> settings{};  // made in this order
};

/// The case of a design.
parameters::Case case_of(const DesignSpace& space, const Design& design);

/// The design at a point of the box. Parameters that stay at the origin keep their bits.
Design design_at(const DesignSpace& space, const Shares& shares);

}  // namespace stridor::advice
