#pragma once

#include "stridor/advice/design_runner.hpp"
#include "stridor/advice/design_space.hpp"
#include "stridor/advice/margins.hpp"
#include "stridor/advice/nearest_design.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

/// The smallest change of a design that makes every phase quiet, and lets the contact slip: a contact that sticks
/// throughout is quiet, too, but does no longer rub. Only where nothing else helps is such a change told.
///
/// A change goes at least `safety` beyond the place where the design begins to be quiet, to a number with few
/// digits, and is *verified*: the changed design is quiet in all of its runs, and so is each one around it, with every
/// changed value `verified_around` less and more in all combinations. What cannot be verified is not told.
namespace stridor::advice {

/// A change goes so far beyond the boundary, at least [1, share of the range].
inline constexpr double safety = 0.02;

/// The changed design is also quiet with so much less and more of each changed value [1, share of the value].
inline constexpr double verified_around = 0.01;

/// A change concerns so many parameters at most.
inline constexpr std::size_t most_changed = 3;

/// A change of one parameter more has to be smaller by this factor to be preferred.
inline constexpr double worth_another = 0.9;

/// A new value of one parameter.
struct ParameterChange {
    std::size_t parameter = 0;  // into DesignSpace::parameters
    double from = 0.0;          // in the field's unit
    double to = 0.0;
};

/// A change of a design, verified to be quiet.
struct DesignChange {
    std::vector<ParameterChange> set{};  // by parameter
    double distance = 0.0;               // [1] from the present design
    DesignVerdict verdict{};             // of the changed design
    std::size_t designs = 0;             // [1] it and those around it: all quiet
    std::size_t runs = 0;                // [1] of all of these, both ways and from every start
};

/// May the contact stick throughout?
enum class Sticking { refused, accepted };

/// The changes of a single free parameter that make the design quiet, one for each that can, smallest first.
std::vector<DesignChange> single_changes(const DesignSpace& space, std::span<const ParameterMargin> margins,
                                         Sticking sticking, DesignRunner& runner);

/// The smallest changes of two and of three free parameters that let it slip quietly, if there are any; `nearest` is
/// the nearest such design.
std::vector<DesignChange> joint_changes(const DesignSpace& space, std::span<const ParameterMargin> margins,
                                        const std::optional<NearestDesign>& nearest, DesignRunner& runner);

/// The change to recommend: the smallest, and of those not much larger (`worth_another`) the one of fewest parameters.
const DesignChange* recommended(std::span<const DesignChange> changes);

/// What is looked for from a design that is the opposite.
enum class Wanted {
    quiet,      // it slips quietly
    not_quiet,  // anything else, but values that contradict each other
};

/// The nearest design of that kind, all free parameters changed at once. The margins are where the search begins.
std::optional<NearestDesign> nearest_design(const DesignSpace& space, std::span<const ParameterMargin> margins,
                                            Wanted wanted, DesignRunner& runner);

/// The number with the fewest decimal digits between two others, of those the nearest to `near`.
double roundest(double near, double far);

}  // namespace stridor::advice
