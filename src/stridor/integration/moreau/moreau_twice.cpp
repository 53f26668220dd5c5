#include "stridor/integration/moreau/moreau_twice.hpp"

#include "stridor/integration/massless/massless.hpp"
#include "stridor/integration/massless/massless_structure.hpp"
#include "stridor/integration/moreau/moreau.hpp"
#include "stridor/integration/step_twice.hpp"

#include <utility>

namespace stridor::integration {

namespace {

using parameters::Formulation;

}  // namespace

Motion integrate_twice(const model::Structure& structure, const parameters::Drive& drive, const InitialState& start,
                       const TimeSteps& settings, record::Recorder recorder, const std::stop_token& stop) {
    const auto run = [&](Formulation formulation, double step, record::Recorder taker) {
        if (formulation == Formulation::massless)
            return integrate_massless(structure, drive, start, {step, settings.massless_above}, std::move(taker), stop);
        return integrate_moreau(structure, drive, start, {step}, std::move(taker), stop);
    };
    // what cannot do without inertia is refused before the other formulation is run
    if (settings.formulation == Formulation::both) massless_structure(structure, settings.massless_above);
    const Formulation first = settings.formulation == Formulation::both ? Formulation::standard : settings.formulation;
    record::Recorder beside = tallies_of(recorder, structure);
    const StepRun at_step = [&](double step, record::Recorder taker) { return run(first, step, std::move(taker)); };
    Motion motion = run_twice(at_step, settings.step, structure, std::move(recorder));
    if (settings.formulation != Formulation::both || !has_result(motion.outcome)) return motion;
    Motion massless = run(Formulation::massless, settings.step, std::move(beside));
    motion.massless = MasslessTwin{massless.outcome, std::move(massless.record.phases)};
    return motion;
}

}  // namespace stridor::integration
