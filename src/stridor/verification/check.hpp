#pragma once

#include "stridor/integration/run/motion.hpp"
#include "stridor/model/built/mass_on_belt.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/record/recorder.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The results that this program must reproduce, with the code that computes them: closed forms, published numbers,
/// stored digits. `stridor verify` and the tests check the engines against the same ones.
namespace stridor::verification {

/// One number compared with a closed form or a published value.
struct Check {
    std::string name;
    double expected = 0.0;
    double computed = 0.0;
    double tolerance = 0.0;  // absolute
    /// Says whether computed lies within the tolerance of expected.
    bool passes() const;
};

/// Checks of one kind, and the source of the expected numbers.
struct CheckGroup {
    std::string_view title;
    std::string_view source;
    std::vector<Check> (*run)();
};

// Runs for comparison with closed forms.

/// Returns a drive of constant velocity [m/s].
parameters::Drive constant_drive(double velocity);

/// Returns a recorder of [from, to] [s] as one judged phase, with a trace on request.
record::Recorder whole_run(double from, double to, const record::TraceRequest& trace = {});

/// Runs the mass on a belt, stuck at first under a constant drive, at rest under any other; beta_2 with 1e-6 s and 1/2.
integration::Motion run_belt(const model::Belt& belt, const parameters::Drive& drive, parameters::Engine engine,
                             record::Recorder recorder);

/// Returns all checks, cheap groups first; they take about a second.
std::span<const CheckGroup> check_groups();

}  // namespace stridor::verification
