#pragma once

#include "stridor/advice/design_runner.hpp"
#include "stridor/advice/design_space.hpp"
#include "stridor/advice/margins.hpp"
#include "stridor/advice/nearest_design.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

/// The smallest change of a design that makes every phase quiet and lets the contact slip. A contact that sticks
/// throughout is quiet, too, but no longer rubs. Such a change is reported only if nothing else helps.
///
/// A change goes at least `safety` beyond the place where the design begins to be quiet, to a number with few digits,
/// and is *verified*: the changed design is quiet in all of its runs, and so is each design around it, with every
/// changed value `verified_around` less and more in all combinations. A change that cannot be verified is not reported.
namespace stridor::advice {

/// How far a change goes beyond the boundary, at least [1, share of the range].
inline constexpr double safety = 0.02;

/// The changed design is also quiet with this much less and more of each changed value [1, share of the value].
inline constexpr double verified_around = 0.01;

/// Most parameters of a change.
inline constexpr std::size_t most_changed = 3;

/// A change of one more parameter must be smaller by this factor to be preferred.
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
    std::size_t designs = 0;             // [1] the changed design and those around it: all quiet
    std::size_t runs = 0;                // [1] of these designs, both ways and from every start
};

/// Whether the contact may stick throughout.
enum class Sticking { refused, accepted };

/// Returns the changes of a single free parameter that make the design quiet, one for each that can, smallest first.
std::vector<DesignChange> single_changes(const DesignSpace& space, std::span<const ParameterMargin> margins,
                                         Sticking sticking, DesignRunner& runner);

/// Returns the smallest changes of two and of three free parameters that let the design slip quietly, if there are any;
/// `nearest` is the nearest such design.
std::vector<DesignChange> joint_changes(const DesignSpace& space, std::span<const ParameterMargin> margins,
                                        const std::optional<NearestDesign>& nearest, DesignRunner& runner);

/// Returns the recommended change: the smallest or, among those not much larger (`worth_another`), the one of fewest
/// parameters; null if there is none.
const DesignChange* recommended(std::span<const DesignChange> changes);

/// The opposite of the present design that is searched.
enum class Wanted {
    quiet,      // it slips quietly
    not_quiet,  // any other verdict, except values that contradict each other
};

/// Returns the nearest design of that kind, all free parameters changed at once, or `std::nullopt` if none was found.
/// The search begins at the margins.
std::optional<NearestDesign> nearest_design(const DesignSpace& space, std::span<const ParameterMargin> margins,
                                            Wanted wanted, DesignRunner& runner);

/// Returns the number with the fewest decimal digits between two others; of several, the nearest to `near`.
double roundest(double near, double far);

}  // namespace stridor::advice
