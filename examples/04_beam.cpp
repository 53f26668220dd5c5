// A structure of any size: a beam that rubs with its tip, by 1, 8 and 40 bending modes.
//
// `model::cantilever` fills M, C, K and one contact point by formula; a structure of your own would come from measured
// modes or a finite-element model. The beta_2 engine takes any number of degrees of freedom. Its energy balance closes
// to rounding, whatever the number of modes.

#include "stridor/analysis/rates.hpp"
#include "stridor/integration/beta_2/beta_2.hpp"
#include "stridor/model/built/cantilever.hpp"
#include "stridor/record/recorder.hpp"

#include <cmath>
#include <iomanip>
#include <iostream>

using namespace stridor;

int main() {
    const model::Cantilever beam;
    parameters::Drive surface;
    surface.kind = parameters::DriveKind::constant;
    surface.velocity = 0.05;  // [m/s]

    record::Schedule schedule;
    schedule.spans = {{0.0, 0.1, record::Phase::all, record::Use::unused},
                      {0.1, 0.2, record::Phase::all, record::Use::judged}};
    schedule.phases = {record::Phase::all};

    bool closes = true;
    std::cout << "modes   slip  stick  separation   energy unexplained\n" << std::fixed << std::setprecision(3);
    for (const int modes : {1, 8, 40}) {
        const integration::Motion motion =
            integration::integrate_beta_2(model::cantilever(beam, modes), surface, {parameters::Initial::stuck, 0.0},
                                          {1e-6, 0.5}, record::Recorder(schedule, {}, modes + 1));
        const auto rates = analysis::rates(motion.record.phases.front().contacts.front().time);
        const double unexplained = std::abs(motion.energy.relative_residual());
        std::cout << std::setw(5) << modes << "  " << rates.slip << "  " << rates.stick << "       " << rates.separation
                  << (unexplained < 1e-9 ? "   less than 1e-9" : "   more than 1e-9") << '\n';
        closes = closes && unexplained < 1e-9;
    }
    return closes ? 0 : 1;
}
