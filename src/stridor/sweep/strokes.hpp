#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/sweep/cell.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

/// A contact over a history of strokes: each heats it and wears it a little, and the next one rubs on what is left.
/// Temperature and worn depth are slow: within a stroke they stand still.
namespace stridor::sweep {

/// How friction heats the parts, as one mass that cools.
///
///     tau theta' = R P - (theta - theta_a)
///
/// P is the mean friction power of a stroke, 0 in a pause; theta_a is the case's own temperature.
struct Heating {
    double resistance = 0.0;  // [degC/W] R, the rise for each watt that lasts
    double time = 0.0;        // [s] tau, after which 63 % of it are reached
};

/// How friction wears the contacts down: the worn volume grows with the work of friction (Fouvry and others 2003,
/// "Quantification of fretting damage", Wear 255), which is Archard's law with k = alpha mu.
///
///     A h' = alpha P,   N = N_0 (1 - h/d)
struct Wear {
    double rate = 0.0;          // [m^3/J] alpha, worn volume for each joule
    double area = 0.0;          // [m^2] A, that rubs, of all contacts
    double interference = 0.0;  // [m] d, how far the parts are pressed together; worn off, nothing presses
};

/// Strokes, and what they do.
struct StrokePlan {
    std::int64_t strokes = 0;
    double duration = 0.0;  // [s] of sliding in each
    double pause = 0.0;     // [s] after each
    std::optional<Heating> heating{};
    std::optional<Wear> wear{};
};

/// One stroke that was computed.
struct ComputedStroke {
    std::int64_t number = 1;
    double temperature = 0.0;     // [degC] with which it begins
    double worn_depth = 0.0;      // [m] likewise
    double preload_share = 1.0;   // [1] of the case's own preload
    double friction_power = 0.0;  // [W] mean over its run, of all contacts; NaN without a result
    std::vector<Cell> cells;      // shape [direction]
};

/// The strokes that were computed: the first, the last, and as many as the slow changes between them ask for.
struct StrokeHistory {
    parameters::Case base;
    StrokePlan plan;
    std::vector<parameters::Direction> directions;  // that of a constant drive; else going and coming
    std::vector<ComputedStroke> strokes;            // by rising number
    std::string ended;                              // why no later stroke has a result; empty: all were reached
};

/// How a history is computed.
struct StrokeOptions {
    double heating_step = 1.0;  // [degC] most between two computed strokes
    double wear_step = 0.01;    // [1] most of the preload between two
    std::stop_token stop{};
    std::function<void(std::int64_t stroke, std::int64_t all)> progress{};
};

/// Returns the case that a stroke runs: with this temperature, and with this share of the preload.
parameters::Case case_of_stroke(const parameters::Case& base, double temperature, double preload_share);

/// Runs a case stroke by stroke, and skips strokes between which temperature and preload hardly change.
///
/// Each stroke is a run of the case from its own start. Powers between computed strokes are extended in a straight
/// line. Where two neighbours have other verdicts the first stroke of the new one is found by halving: two changes
/// between them are missed. The history ends before its last stroke where a run has no result, the temperature leaves
/// the case's tables, or the interference is worn off. Throws `Error`: input for a plan without heating and wear, for
/// numbers that are not positive, for heating of a case that does not follow the temperature, and for wear of one whose
/// structure is pressed by something else than contact.preload; interrupted after a stop request.
StrokeHistory run_strokes(const parameters::Case& base, const StrokePlan& plan, const StrokeOptions& options = {});

/// A stretch of neighbouring strokes with one verdict in one direction.
struct StrokeStretch {
    std::size_t first = 0;  // into `StrokeHistory::strokes`
    std::size_t last = 0;
};

/// Returns the stretches of a direction, in their order.
std::vector<StrokeStretch> stretches_of(const StrokeHistory& history, std::size_t direction);

}  // namespace stridor::sweep
