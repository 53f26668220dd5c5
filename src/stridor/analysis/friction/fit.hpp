#pragma once

#include "stridor/analysis/friction/points.hpp"
#include "stridor/analysis/friction/slips.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/parameters/fields/field.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::analysis {

/// The laws over the speed of slip that are fitted, in the order in which they are listed.
inline constexpr std::array fitted_kinds{parameters::FrictionKind::coulomb, parameters::FrictionKind::linear,
                                         parameters::FrictionKind::stribeck,
                                         parameters::FrictionKind::stribeck_rational, parameters::FrictionKind::table};
inline constexpr std::array<std::string_view, 5> fitted_names{"coulomb", "linear", "stribeck", "stribeck-rational",
                                                              "table"};

/// A number of a law with its interval of 95 % confidence. An end that the data leave open is infinite.
struct FittedNumber {
    double parameters::Contact::*member = nullptr;  // where a contact keeps it
    const parameters::Field* field = nullptr;       // of a case: its key, symbol and unit
    double value = 0.0;
    double from = 0.0;
    double to = 0.0;
};

/// A number of the rig that was fitted, with its interval of 95 % confidence.
struct RigNumber {
    std::string_view name;    // "stiffness"
    std::string_view symbol;  // "k"
    std::string_view unit;    // "N/m"
    double value = 0.0;
    double from = 0.0;
    double to = 0.0;
};

/// A law that was fitted.
struct FittedLaw {
    std::size_t kind = 0;               // place in `fitted_kinds`
    std::vector<FittedNumber> numbers;  // those of a table are its rows' and stand in it
    std::vector<RigNumber> rig;         // of the rig, where they were not known
    parameters::Contact contact;        // of this law, its numbers put in
    std::size_t free_numbers = 0;       // that were fitted
    double deviation = 0.0;             // [1] root mean square of what the law leaves of the points
    double criterion = 0.0;             // [1] Akaike's, corrected for few points (AICc)
    double difference = 0.0;            // [1] from the least criterion
    std::vector<double> residuals;      // [1] shape [point]
    std::vector<double> onsets;         // [s] of slips, from their first samples, shape [slip]
    std::vector<double> limits;         // [N] at which slips let go, shape [slip]
    MeasuringRig moved_by;              // in slips, with what was fitted of it
    std::vector<double> covariance;     // by slips, of mu_s, then mu_d, s_mu and ln v_s, shape [number][number]
};

/// A law that could not be fitted.
struct UnfittedLaw {
    std::size_t kind = 0;
    std::string why;
};

/// From which difference of Akaike's criterion on two laws are told apart: one is then 20 times as likely as the other,
/// exp(6/2). Smaller values tell laws apart that noise made different.
inline constexpr double telling_difference = 6.0;

/// Laws of friction fitted to points.
struct FrictionFit {
    FrictionPoints data;
    std::vector<FittedLaw> laws;  // in the order of `fitted_kinds`
    std::vector<UnfittedLaw> unfitted;
    std::size_t best = 0;             // place in `laws` of the law that the data bear
    std::vector<std::size_t> rivals;  // places of those that are not told from it, with no more numbers
    std::vector<std::size_t> richer;  // and of those with more numbers
    double independent = 0.0;         // [1] number of independent points
    std::size_t speeds = 0;           // [1] different ones
    std::size_t slips = 0;            // [1] that were fitted through the model of the rig
};

/// Fits each law to points of friction by least squares and says which the data bear;
/// docs/methods/friction-fit.md.
///
/// A law is mu_d + (mu_s - mu_d) g(w/v_s) + k_v w: linear in all numbers but v_s. So the least sum of squares over v_s
/// is found by a search along one line, with the others solved for, none below zero (variable projection: Golub and
/// Pereyra 1973). delta is 1 or 2, whichever fits better. The interval of a number holds all its values at which the
/// sum of squares, the others fitted anew, stays below s^2 t^2 above the least (profile likelihood), t being Student's
/// of 95 %. It needs no law to be nearly linear in its numbers. Runs that all have stick-slip are fitted through the
/// model of the rig (`fit_of_slips`); without a rig they have Coulomb's numbers. Runs of both kinds are fitted at once
/// (`fit_of_both`). An exponent that is given is the only delta. Throws `Error` (input) for too few points.
FrictionFit friction_fit(FrictionPoints data, const std::optional<MeasuringRig>& rig = {},
                         std::optional<double> exponent = {});

/// Says by the criteria of the laws which of them the data bear, and which they do not tell from it.
void choose_law(FrictionFit& fit);

/// Returns the place in `fit.laws` of a law by its name. Throws `Error` (input) if it was not fitted, with why.
std::size_t law_called(const FrictionFit& fit, std::string_view name);

/// Returns what the data say, in sentences: "The data do not tell stribeck from stribeck-rational."
std::string words_of(const FrictionFit& fit);

/// Returns friction over normal force [1] of a fitted law at a point.
double friction_at(const FittedLaw& law, const FrictionPoint& point);

}  // namespace stridor::analysis
