// Where does steady sliding become unstable? The flutter onset of Table 1's parameters, without a simulation.
//
// A builder makes a structure with a contact out of a case; the analysis sees only the structure.

#include "stridor/analysis/stability_scan.hpp"
#include "stridor/model/built/rubbing_system.hpp"
#include "stridor/parameters/paper_cases.hpp"

#include <iostream>

using namespace stridor;

int main() {
    const parameters::Case base = parameters::paper_case(parameters::PaperCase::squeal);
    const auto going_at = [&](double kinetic_friction) {
        parameters::Case c = base;
        c.contact().kinetic_friction = kinetic_friction;
        return analysis::sliding_stability(model::rubbing_system(c), parameters::Direction::going);
    };

    const int points = 9;
    const analysis::StabilityPath path = analysis::stability_path(going_at, 0.0, 0.8, points);
    std::cout << "mu_d [1]  growth [1/s]  frequency [Hz]\n";
    for (const analysis::StabilityPoint& point : path.points)
        std::cout << point.value << "  " << point.stability.growth << "  " << point.stability.frequency << '\n';

    // the changes of kind between two points are bisected
    for (const analysis::StabilityBoundary& boundary : path.boundaries)
        std::cout << analysis::stability_names[static_cast<std::size_t>(boundary.above)]
                  << " from mu_d = " << boundary.value << ", " << boundary.frequency << " Hz\n";
    return path.boundaries.size() == 1 ? 0 : 1;
}
