#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/parameters/fields/field.hpp"
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
/// logarithmic one. The distance of two designs is the Euclidean distance of their shares: the size of the change,
/// measured by the ranges that designers use. docs/methods/advice.md says why.
namespace stridor::advice {

/// A quantity that may be changed, and the range of its values.
struct DesignParameter {
    std::string key;    // "contact.preload"
    double from = 0.0;  // in the field's unit, below `to`
    double to = 1.0;
    sweep::Scale scale = sweep::Scale::linear;  // logarithmic: both ends have the same sign
};

/// Returns the value at a share of the range, 0 <= share <= 1, with the same bits on every machine and exact ends.
double value_at(const DesignParameter& parameter, double share);

/// Returns the share of a value in the range.
double share_of(const DesignParameter& parameter, double value);

/// A point of the box, shape [parameter].
using Shares = std::vector<double>;

/// One of the motions by which a design is judged.
struct DesignRun {
    std::optional<parameters::Direction> direction{};  // of a constant drive; `std::nullopt`: any other drive
    parameters::Initial start = parameters::Initial::rest;
};

/// The motions by which a design is judged. A user moves it both ways, and does not know how it begins.
struct AskedRuns {
    std::vector<parameters::Direction> directions{};  // empty: both
    std::vector<parameters::Initial> starts{};        // empty: all that the case has, its own first
};

/// A case and the box of designs around it.
struct DesignSpace {
    parameters::Case base;
    std::vector<DesignParameter> parameters;
    Shares origin;                      // the base case, shape [parameter]
    std::vector<std::size_t> free;      // the parameters that advice may change; the others are only followed
    std::vector<record::Phase> phases;  // the judged phases: going and coming; `all` of a surface that stands still
    std::vector<DesignRun> runs;        // the motions, the case's own start first in each direction
};

/// A range that a user asks for by name; without ends it is the usual one around the case (`parameters::usual_range`).
struct AskedRange {
    std::string name;  // in any spelling of `quantity_key_called`
    std::optional<double> from{};
    std::optional<double> to{};
};

/// Returns the key that `parameters::quantity_key_called` finds. Throws `Error` (input) also if the quantity changes
/// nothing in this case, or belongs to a joint that the case does not have.
std::string quantity_key_called(const parameters::Case& c, std::string_view name);

/// Throws `Error` (input) for a key of all joints whose values differ: the design has no single value of it.
void expect_one_value(const parameters::Case& c, std::string_view key);

/// Returns the space of the ranges asked for, all of them free. Without any it is the space of all quantities that a
/// designer varies (`parameters::design_keys`). The drive is not free then: a product has to bear its motion, so the
/// margins of the drive are of interest, but not advice to move it otherwise. A range is widened to hold the case's own
/// value.
///
/// Throws `Error` (input) for an unknown name or one that comes twice, for ends outside the field's range or out of
/// order, for a quantity without a usual range and without ends, for directions and starts that this case does not
/// have, and for a case with `parameters::findings`.
DesignSpace design_space(const parameters::Case& c, std::span<const AskedRange> asked = {}, const AskedRuns& runs = {});

/// Returns the starts of a space's runs, each once.
std::vector<parameters::Initial> starts_of(const DesignSpace& space);

/// Returns the case of a run, with its direction and start.
parameters::Case case_of(const parameters::Case& design, const DesignRun& run);

/// A design, by its differences from the space's base case.
struct Design {
    struct Setting {
        std::string key;
        double value = 0.0;  // in the field's unit
    };
    std::vector<Setting> settings{};  // applied in this order
};

/// Returns the case of a design.
parameters::Case case_of(const DesignSpace& space, const Design& design);

/// Returns the design at a point of the box. Parameters that stay at the origin keep their bits.
Design design_at(const DesignSpace& space, const Shares& shares);

}  // namespace stridor::advice
