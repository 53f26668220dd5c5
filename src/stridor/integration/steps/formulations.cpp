#include "stridor/integration/steps/formulations.hpp"

#include "stridor/integration/run/end_state.hpp"
#include "stridor/integration/run/step_loop.hpp"
#include "stridor/integration/steps/massless.hpp"
#include "stridor/integration/steps/moreau.hpp"

#include <utility>

namespace stridor::integration {

Motion integrate_twice(const model::Structure& structure, const parameters::Drive& drive, const InitialState& start,
                       const TimeSteps& settings, record::Recorder recorder, const std::stop_token& stop) {
    using parameters::Formulation;
    const auto run = [&](Formulation formulation, double step, record::Recorder taker) {
        if (formulation == Formulation::massless)
            return integrate_massless(structure, drive, start, {step, settings.massless_above}, std::move(taker), stop);
        return integrate_moreau(structure, drive, start, {step}, std::move(taker), stop);
    };
    // what cannot do without inertia is refused before the other formulation is run
    if (settings.formulation == Formulation::both) massless_structure(structure, settings.massless_above);
    const auto twice = [&](Formulation formulation, record::Recorder taker) {
        const StepRun at_step = [&](double step, record::Recorder t) { return run(formulation, step, std::move(t)); };
        return run_twice(at_step, settings.step, structure, std::move(taker));
    };
    if (settings.formulation != Formulation::both) return twice(settings.formulation, std::move(recorder));
    record::Recorder beside = tallies_of(recorder, structure);
    Motion motion = twice(Formulation::standard, std::move(recorder));
    if (!has_result(motion.outcome)) return motion;
    const EndState standard = start.handover == nullptr ? EndState() : start.handover->to;
    Motion massless = twice(Formulation::massless, std::move(beside));
    if (start.handover != nullptr) {
        // the motion is the standard one
        start.handover->to.displacement = standard.displacement;
        start.handover->to.velocity = standard.velocity;
        start.handover->to.contacts = standard.contacts;
    }
    motion.massless = MasslessTwin{massless.outcome, std::move(massless.record.phases)};
    return motion;
}

}  // namespace stridor::integration
