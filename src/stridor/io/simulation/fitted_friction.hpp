#pragma once

#include "stridor/analysis/friction/fit.hpp"
#include "stridor/analysis/friction/over_conditions.hpp"
#include "stridor/io/simulation/friction_test.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Laws of friction fitted to a rig's recordings, and into a case.
namespace stridor::io {

/// Recordings and what is known of them, as a command line says it; quantities carry their units.
struct FrictionFitTexts {
    std::vector<std::string> files{};
    FrictionTexts shared{};  // its preload and velocity: one for all files, or as many as files, between commas
    std::string mass{};      // of the rig, "fit" where it is to be fitted; empty: not known
    std::string stiffness{};
    std::string damping{};
    std::string temperature{};  // of the parts, one for all files or as many as files; empty: not known
};

/// Laws fitted to recordings, and what these were measured with.
struct FittedFriction {
    std::vector<FrictionTest> tests{};
    analysis::FrictionFit fit{};
    std::optional<analysis::FrictionOverConditions> over{};  // of runs at several temperatures; `fit` is its whole
};

/// Returns the texts of each file, with its own preload and velocity. Throws `Error` (input) for lists of another
/// length.
std::vector<FrictionTexts> texts_of_files(const FrictionFitTexts& texts);

/// Returns the rig that measured; nothing where neither mass nor stiffness is said. Throws `Error` (input) where one of
/// them is missing or not above zero.
std::optional<analysis::MeasuringRig> measuring_rig(const FrictionFitTexts& texts);

/// Reads recordings and fits each law of friction, over the temperature where they say several; `note` is told what is
/// noteworthy. Throws `Error` (input), with the
/// file as its place, for what reading and fitting refuse.
FittedFriction fitted_friction(const FrictionFitTexts& texts, const std::function<void(const std::string&)>& note);

/// Returns a row [[pair]] for each condition that the runs were made at: their temperature, humidity and load. Those of
/// `conditions` are one for all files, or as many as files, between commas. A row of one run has what it shows; one of
/// several has Coulomb's numbers fitted to them. Throws `Error` (input) as `pair_row` and `fitted_friction` do.
std::string pair_rows(const FrictionFitTexts& texts, const PairConditions& conditions,
                      const std::function<void(const std::string&)>& note);

/// Returns such rows with the numbers of a law, "best" or by its name, fitted to the runs of each condition: its kind
/// and delta are common. `note` is told what the data say. Throws `Error` (input) for the law "table", for whose rows a
/// pair has no place, and what `friction_over_conditions` throws.
std::string pair_rows_of_law(const FrictionFitTexts& texts, const PairConditions& conditions, const std::string& law,
                             const std::function<void(const std::string&)>& note);

/// Returns "stridor.friction-fit/1": runs, laws with their numbers and intervals, what the data bear, the points; `law`
/// is the place of the law that was asked for.
std::string friction_fit_json(const FittedFriction& fitted, std::size_t law);

/// Returns the text of a case with a fitted law, to four digits, of all its joints or contacts. A law over the
/// temperature has its numbers in [temperature]; throws `Error` (input) where such a table stands there already, and
/// for rows over the speed.
std::string case_with_law(parameters::Case c, const FittedFriction& fitted, std::size_t law);

}  // namespace stridor::io
