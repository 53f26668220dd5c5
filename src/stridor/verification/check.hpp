#pragma once

#include "stridor/integration/motion.hpp"
#include "stridor/model/built/mass_on_belt.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/record/recorder.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What this program must reproduce, with the code that computes it: closed forms, published numbers, stored digits.
/// `stridor verify` and the tests hold the engines against the same ones.
namespace stridor::verification {

/// One number held against a closed form or a published value.
struct Check {
    std::string name;
    double expected = 0.0;
    double computed = 0.0;
    double tolerance = 0.0;  // absolute
    /// Does computed lie within the tolerance of expected?
    bool passes() const;
};

/// Checks of one kind, and where the expected numbers come from.
struct CheckGroup {
    std::string_view title;
    std::string_view source;
    std::vector<Check> (*run)();
};

// Runs that closed forms are held against.

/// A drive of constant velocity [m/s].
parameters::Drive constant_drive(double velocity);

/// Records [from, to] [s] as one judged phase, and a trace on request.
record::Recorder whole_run(double from, double to, const record::TraceRequest& trace = {});

/// The mass on a belt, stuck at first under a constant drive, at rest under any other; beta_2 with 1e-6 s and 1/2.
integration::Motion run_belt(const model::Belt& belt, const parameters::Drive& drive, parameters::Engine engine,
                             record::Recorder recorder);

/// Everything that is verified, cheap groups first; about a second in all.
std::span<const CheckGroup> check_groups();

}  // namespace stridor::verification
