#pragma once

#include "stridor/classification/likeness.hpp"
#include "stridor/hearing/heard_motion.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/sound_thresholds.hpp"
#include "stridor/sound/auralisation.hpp"
#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/study.hpp"

#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace stridor::hearing {

/// How the cells of a chart are made audible and judged by ear.
struct CellListening {
    AskedMotion motion{};
    sound::AuralisationSettings sound{};  // its pickup and stretches follow from each cell
    parameters::SoundThresholds thresholds{};
};

/// What one cell of a chart sounds like.
struct CellSound {
    std::size_t index = 0;                                                   // of the cell in its study
    sweep::Status status = sweep::Status::failed;                            // only a done cell has a sound
    std::string message{};                                                   // why it is not done
    classification::Category contact = classification::Category::undecided;  // by contact states
    classification::Category heard = classification::Category::undecided;    // by ear
    classification::SoundProfile profile{};
};

/// Simulates a cell, from the first of the study's starts if it has any, and listens to it as to a recording of its
/// phases put one after the other (`sound_of_run`); nothing if it was stopped.
///
/// What goes wrong with the physics or the numbers becomes the status, as in `evaluate_run`.
std::optional<CellSound> sound_of_cell(const sweep::Study& study, std::size_t index, const CellListening& listening,
                                       const std::stop_token& stop, integration::Workspace& workspace);

}  // namespace stridor::hearing
