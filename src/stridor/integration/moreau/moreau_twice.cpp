#include "stridor/integration/moreau/moreau_twice.hpp"

#include "stridor/integration/massless/massless.hpp"
#include "stridor/integration/moreau/moreau.hpp"

#include <utility>

namespace stridor::integration {

namespace {

using parameters::Formulation;

// a recorder of the same run that keeps tallies alone
record::Recorder tallies_of(const record::Recorder& recorder, const model::Structure& structure) {
    return {recorder.schedule(),           {},
            model::dofs_of(structure),     static_cast<int>(structure.contacts.size()),
            model::channels_of(structure), model::interfaces_of(structure)};
}

}  // namespace

Motion integrate_twice(const model::Structure& structure, const parameters::Drive& drive, const InitialState& start,
                       const TimeSteps& settings, record::Recorder recorder, const std::stop_token& stop) {
    const auto run = [&](Formulation formulation, double step, record::Recorder taker) {
        if (formulation == Formulation::massless)
            return integrate_massless(structure, drive, start, {step, settings.massless_above}, std::move(taker), stop);
        return integrate_moreau(structure, drive, start, {step}, std::move(taker), stop);
    };
    const Formulation first = settings.formulation == Formulation::both ? Formulation::standard : settings.formulation;
    const Motion coarse = run(first, 2.0 * settings.step, tallies_of(recorder, structure));
    if (!has_result(coarse.outcome)) {
        Motion motion{coarse.outcome, coarse.energy, recorder.finish(0.0)};
        motion.pressed = coarse.pressed;
        return motion;
    }
    record::Recorder beside = tallies_of(recorder, structure);
    Motion motion = run(first, settings.step, std::move(recorder));
    for (std::size_t phase = 0; phase < motion.record.phases.size(); ++phase)
        for (std::size_t k = 0; k < structure.contacts.size(); ++k) {
            const record::ContactTally& from = coarse.record.phases[phase].contacts[k];
            motion.record.phases[phase].contacts[k].coarser = {from.time, from.judged_time};
        }
    if (settings.formulation != Formulation::both || !has_result(motion.outcome)) return motion;
    Motion massless = run(Formulation::massless, settings.step, std::move(beside));
    motion.massless = MasslessTwin{massless.outcome, std::move(massless.record.phases)};
    return motion;
}

}  // namespace stridor::integration
