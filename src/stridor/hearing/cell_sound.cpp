#include "stridor/hearing/cell_sound.hpp"

#include "stridor/hearing/run_sound.hpp"

#include <array>

namespace stridor::hearing {

std::optional<CellSound> sound_of_cell(const sweep::Study& study, std::size_t index, const CellListening& listening,
                                       const std::stop_token& stop, integration::Workspace& workspace) {
    const sweep::CellPlace place = sweep::place_of(study, index);
    const parameters::Case c = sweep::case_at(study, place);
    const parameters::Direction direction = study.directions[place.direction];
    const std::optional<HeardMotion> motion = heard_motion(c, listening.motion, stop, workspace);
    if (!motion) return std::nullopt;
    sound::AuralisationSettings settings = listening.sound;
    settings.pickup = motion->pickup;
    settings.stretches = heard_stretches(c, direction);
    const std::optional<RunSound> run = sound_of_run(c, settings, stop, workspace);
    if (!run) return std::nullopt;
    const sweep::Cell cell = sweep::cell_of(c, direction, run->attempt);
    CellSound sound{index, cell.status, cell.message, cell.category, classification::Category::undecided, {}};
    if (cell.status != sweep::Status::done) return sound;
    if (settings.stretches.empty()) {
        sound.status = sweep::Status::invalid;
        sound.message = "the drive never moves that way in the window";
        return sound;
    }
    const std::array<signal::Signal, 1> whole{joined(run->parts)};
    const HeardVerdict heard = judged(whole, listening.thresholds);
    sound.heard = heard.verdict.category;
    sound.profile = classification::profile_of(heard.stretches, heard.verdict, listening.thresholds);
    return sound;
}

}  // namespace stridor::hearing
