#include "stridor/verification/constant_drive.hpp"

#include "stridor/analysis/evidence.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/verification/runs.hpp"

#include <fmt/format.h>

namespace stridor::verification {

// over the window from 1 to 2 s, its ends wherever they fall in a period
std::vector<Check> constant_drive_checks() {
    std::vector<Check> checks;
    for (const StickSlip& known : stick_slips) {
        parameters::Case c = parameters::paper_case(parameters::PaperCase::squeak);
        c.contact.preload = known.preload;
        c.drive = constant_drive(-0.1257);
        c.run.initial = parameters::Initial::stuck;
        c.run.duration = 2.0;
        const analysis::Evidence evidence = analysis::evidence(integration::simulate(c).record.phases.at(0), 0);
        checks.push_back({fmt::format("stick share, V = -0.1257, F = {:g} N", known.preload), known.stick_fraction,
                          evidence.rates.stick, 2e-6});
        checks.push_back({"its period [s]", known.period, evidence.alternation.period, 1e-7 * known.period});
    }
    return checks;
}

}  // namespace stridor::verification
