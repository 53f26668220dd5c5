#pragma once

#include "stridor/analysis/friction/trace.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/signal/source.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

/// Friction coefficients out of a rig's recording, and into a case.
namespace stridor::io {

/// What a friction trace was measured with, as far as it is known.
struct FrictionTest {
    std::string file;
    std::string channel;           // of the friction force
    std::string velocity_channel;  // empty: none
    std::string normal_channel;    // empty: none
    double rate = 0.0;             // [Hz]
    double duration = 0.0;         // [s]
    double preload = 0.0;          // [N]
    double velocity = 0.0;         // [m/s] nominal or the 95th percentile of the measured one; NaN where unknown
    std::string condition;         // of a standard test, in words; may be empty
};

/// Returns "stridor.friction/1": coefficients and drops of a friction trace.
std::string friction_json(const FrictionTest& test, const analysis::FrictionTrace& trace);

/// A recording and what is known of it, as a command line says it; quantities carry their units.
struct FrictionTexts {
    std::string file{};
    std::string preload{};
    std::string velocity{};  // nominal; empty: the usual speed that was measured
    std::string channel{};   // names or numbers; empty: as the channels say themselves
    std::string velocity_channel{};
    std::string normal_channel{};
    std::string full_scale{};
    double least_drop = analysis::FrictionTraceOptions{}.least_drop;  // [1]
    std::string longest_drop = "250 ms";
};

/// A recording of a rig.
struct RecordedFriction {
    FrictionTest test{};
    std::vector<signal::Signal> channels{};
    analysis::FrictionMeasurement measurement{};  // of these channels
};

/// Reads a recording, an hour of four channels at 10 kHz at most; `note` is told what is noteworthy. Throws `Error`
/// (input) where a text or the channels are not clear, and what reading throws.
RecordedFriction recorded_friction(const FrictionTexts& texts, const std::function<void(const std::string&)>& note);

/// Returns the definitions of a command line.
analysis::FrictionTraceOptions trace_options(const FrictionTexts& texts);

/// The friction of a recording, and what it was measured with.
struct MeasuredFriction {
    FrictionTest test{};
    analysis::FrictionTrace trace{};
};

/// Reads a recording and measures its friction; `note` is told what is
/// noteworthy.
///
/// Throws `Error` (input) where a text or the channels are not clear, and what reading and measuring throw.
MeasuredFriction measured_friction(const FrictionTexts& texts, const std::function<void(const std::string&)>& note);

/// What a row of a table of pairs says beside the coefficients; empty: nothing.
struct PairConditions {
    std::string name{};
    std::string temperature{};  // "23 degC"
    std::string humidity{};     // "50 %"
};

/// Returns how a row [[pair]] begins: name, source, conditions and load. Throws `Error` (input) for a text that is no
/// quantity.
std::string pair_row_opening(const PairConditions& conditions, const std::string& source, double preload);

/// Returns the measured coefficients, to four digits, as a row [[pair]] of a file pairs.toml. Throws `Error` (input) as
/// `case_with_friction` does.
std::string pair_row(const MeasuredFriction& measured, const PairConditions& conditions);

/// Returns the text of a case with the measured coefficients, to four digits, of all its joints or contacts; the static
/// one is the kinetic one where none was to be seen. Throws `Error` (input) where nothing slides or they come out the
/// wrong way round.
std::string case_with_friction(parameters::Case c, const MeasuredFriction& measured);

}  // namespace stridor::io
