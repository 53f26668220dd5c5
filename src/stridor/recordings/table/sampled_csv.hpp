#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stridor::recordings {

/// A measured or drawn imposed motion.
struct SampledMotion {
    std::vector<double> times;       // [s] strictly increasing, shape [sample]
    std::vector<double> velocities;  // [m/s] shape [sample]
};

/// Reads a table of velocity over time from CSV text; `name` is the file's, for messages.
///
/// Columns are separated by tab, semicolon or comma, whichever the first line holds in this order; with tab and
/// semicolon numbers may have a decimal comma. A byte order mark, any line ends, blank lines, `#` comments and quotes
/// are understood. Columns are found by name (time, t; velocity, v; any case); their units stand in the header ("time
/// [ms]"), in a row of their own below it, or are SI. Without a header there are two columns, time and velocity. Throws
/// `Error` (input) with line and column for a missing column, a short or long row, a word, an empty or non-finite
/// number, a unit of the wrong dimension, and times that do not increase.
SampledMotion read_sampled_csv(std::string_view text, const std::string& name);

/// Reads such a table from a file of at most 256 MiB that is neither a pipe nor a device. Throws `Error` (io) if it
/// cannot be read.
SampledMotion read_sampled_file(const std::string& path);

/// Friction as measured over the speed of slip.
struct SampledFriction {
    std::vector<double> speeds;        // [m/s] strictly increasing, shape [row]
    std::vector<double> coefficients;  // [1] shape [row]
};

/// Reads a table of friction over speed from CSV text, as `read_sampled_csv` does: the columns are speed (s) and
/// friction (f). Throws as that does.
SampledFriction read_friction_csv(std::string_view text, const std::string& name);

/// Reads such a table from a file, as `read_sampled_file` does.
SampledFriction read_friction_file(const std::string& path);

/// The force of a spring as measured over its deflection.
struct SampledForce {
    std::vector<double> deflections;  // [m] strictly increasing, shape [row]
    std::vector<double> forces;       // [N] shape [row]
};

/// Reads a table of force over deflection from a file, as `read_sampled_file` does: the columns are deflection (d) and
/// force (f). Throws as that does.
SampledForce read_force_file(const std::string& path);

}  // namespace stridor::recordings
