#include "stridor/integration/run/step_loop.hpp"

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

}  // namespace stridor::integration
