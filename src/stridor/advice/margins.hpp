#pragma once

#include "stridor/advice/design_runner.hpp"
#include "stridor/advice/design_space.hpp"
#include "stridor/base/error.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// How far each parameter of a design may move before its verdict changes.
///
/// Each parameter is followed alone through its range: on a grid of `scan_intervals` equal intervals of its share, and
/// closer around the present value, by shares of the range and of the value (`near_steps`). The nearest place at which
/// the verdict of any phase changes is then bisected to `scan_resolution`. An island of noise or of silence that is
/// narrower than an interval of the grid may be missed.
namespace stridor::advice {

/// Equal intervals of a parameter's range, at whose ends designs are judged.
inline constexpr int scan_intervals = 64;

/// Share of the range to which a change of verdict is located.
inline constexpr double scan_resolution = 1e-4;

/// A place at which the verdict changes. Both sides of it were run: they are at most `scan_resolution` of the range
/// apart.
struct VerdictChange {
    double share = 0.0;      // [1] of the range, of `value`
    double value = 0.0;      // in the field's unit: the other verdict
    double before = 0.0;     // in the field's unit: the last value without the change
    DesignVerdict beyond{};  // at `value`
};

/// Why a parameter is not followed further.
enum class ScanEnd {
    range,    // its range ends there
    invalid,  // the case's values contradict each other beyond
};

inline constexpr std::array<std::string_view, 2> scan_end_names{"range", "invalid"};

/// How far a parameter is followed to one side, and what is found there.
struct ScanSide {
    std::optional<VerdictChange> change{};  // the nearest change of verdict
    std::optional<VerdictChange> quiet{};   // the nearest design that slips quietly, unless the present one is quiet
    double last = 0.0;                      // in the field's unit: the scan ends there
    ScanEnd end = ScanEnd::range;
    std::string reason{};  // end = invalid: the contradiction
};

/// A design of a scan.
struct ScanPoint {
    double share = 0.0;  // [1] of the range
    double value = 0.0;  // in the field's unit
    DesignVerdict verdict{};
};

/// The verdicts along one parameter.
struct ParameterMargin {
    std::size_t parameter = 0;      // into DesignSpace::parameters
    double value = 0.0;             // in the field's unit, at present
    ScanSide below{};               // towards smaller values
    ScanSide above{};               // towards larger ones
    std::vector<ScanPoint> scan{};  // rising, the present value among them
};

/// The margins of all parameters, in their order, as far as the search came.
struct MarginSearch {
    std::vector<ParameterMargin> margins{};
    std::optional<Error> stopped{};  // why the search ended early; `std::nullopt`: it is complete
};

/// Searches the margins of all parameters; `present` is the verdict at the origin. Designs are judged nearest first, so
/// that a stopped search still has the nearest changes: `last` is then where it ended, and a change lies between two
/// designs of the scan instead of within `scan_resolution`.
MarginSearch find_margins(const DesignSpace& space, const DesignVerdict& present, DesignRunner& runner);

/// Returns the nearer of a parameter's two changes, by share, or null if there is none.
const VerdictChange* nearest_change(const DesignSpace& space, const ParameterMargin& margin);

/// Returns the nearer of a parameter's two quiet designs, by share, or null if there is none.
const VerdictChange* nearest_quiet(const DesignSpace& space, const ParameterMargin& margin);

/// A condition on the verdict of a design.
using DesignCondition = std::function<bool(const DesignVerdict&)>;

/// Two designs between which a condition begins to hold.
struct Bracket {
    Shares before{};          // it does not hold here
    Shares beyond{};          // it does here
    DesignVerdict verdict{};  // of `beyond`
};

/// Bisects brackets until their ends are at most `resolution` apart [1, distance of shares], each with its own
/// condition, shape [bracket], and returns them.
std::vector<Bracket> bisect(std::vector<Bracket> brackets, const std::vector<DesignCondition>& conditions,
                            double resolution, DesignRunner& runner);

/// Returns the Euclidean distance of the shares of two designs [1].
double distance(const Shares& a, const Shares& b);

}  // namespace stridor::advice
