#include "stridor/sweep/cell_sound.hpp"

#include "stridor/sweep/run_sound.hpp"

#include <array>

namespace stridor::sweep {

std::optional<CellSound> sound_of_cell(const Study& study, std::size_t index, const CellListening& listening,
                                       const std::stop_token& stop, integration::Workspace& workspace) {
    const CellPlace place = place_of(study, index);
    const parameters::Case c = case_at(study, place);
    const parameters::Direction direction = study.directions[place.direction];
    signal::AuralisationSettings settings = listening.sound;
    settings.stretches = heard_stretches(c, direction);
    const std::optional<RunSound> run = sound_of_run(c, settings, stop, workspace);
    if (!run) return std::nullopt;
    const Cell cell = cell_of(c, direction, run->attempt);
    CellSound sound{index, cell.status, cell.message, cell.category, classification::Category::undecided, {}};
    if (cell.status != Status::done) return sound;
    if (settings.stretches.empty()) {
        sound.status = Status::invalid;
        sound.message = "the drive never moves that way in the window";
        return sound;
    }
    const std::array<signal::Signal, 1> whole{joined(run->parts)};
    const HeardVerdict heard = judged(whole, listening.thresholds);
    sound.heard = heard.verdict.category;
    sound.profile = classification::profile_of(heard.stretches, heard.verdict, listening.thresholds);
    return sound;
}

}  // namespace stridor::sweep
