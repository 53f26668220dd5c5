#include "stridor/integration/step_twice.hpp"

#include "stridor/integration/massless/massless.hpp"
#include "stridor/integration/moreau/moreau.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace stridor::integration {

record::Recorder tallies_of(const record::Recorder& recorder, const model::Structure& structure) {
    return {recorder.schedule(),           {},
            model::dofs_of(structure),     static_cast<int>(structure.contacts.size()),
            model::channels_of(structure), model::interfaces_of(structure)};
}

Motion run_twice(const StepRun& run, double step, const model::Structure& structure, record::Recorder recorder) {
    const Motion coarse = run(2.0 * step, tallies_of(recorder, structure));
    if (!has_result(coarse.outcome)) {
        Motion motion{coarse.outcome, coarse.energy, recorder.finish(0.0)};
        motion.pressed = coarse.pressed;
        return motion;
    }
    Motion motion = run(step, std::move(recorder));
    for (std::size_t phase = 0; phase < motion.record.phases.size(); ++phase) {
        std::vector<record::ContactTally>& contacts = motion.record.phases[phase].contacts;
        for (std::size_t k = 0; k < contacts.size(); ++k) {
            const record::ContactTally& from = coarse.record.phases[phase].contacts[k];
            contacts[k].coarser = record::CoarserTally{from.time, from.judged_time, from.changes};
        }
    }
    return motion;
}

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
    Motion massless = twice(Formulation::massless, std::move(beside));
    motion.massless = MasslessTwin{massless.outcome, std::move(massless.record.phases)};
    return motion;
}

}  // namespace stridor::integration
