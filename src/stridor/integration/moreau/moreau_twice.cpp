#include "stridor/integration/moreau/moreau_twice.hpp"

#include <utility>

namespace stridor::integration {

Motion integrate_moreau_twice(const model::Structure& structure, const parameters::Drive& drive,
                              const InitialState& start, const Moreau& settings, record::Recorder recorder,
                              const std::stop_token& stop) {
    record::Recorder tallies(recorder.schedule(), {}, model::dofs_of(structure),
                             static_cast<int>(structure.contacts.size()), model::channels_of(structure));
    const Motion coarse = integrate_moreau(structure, drive, start, {2.0 * settings.step}, std::move(tallies), stop);
    if (!has_result(coarse.outcome)) return {coarse.outcome, coarse.energy, recorder.finish(0.0)};
    Motion motion = integrate_moreau(structure, drive, start, settings, std::move(recorder), stop);
    for (std::size_t phase = 0; phase < motion.record.phases.size(); ++phase)
        for (std::size_t k = 0; k < structure.contacts.size(); ++k) {
            const record::ContactTally& from = coarse.record.phases[phase].contacts[k];
            motion.record.phases[phase].contacts[k].coarser = {from.time, from.judged_time};
        }
    return motion;
}

}  // namespace stridor::integration
