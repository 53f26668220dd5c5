#pragma once

// A MAT file read by libmatio, in a confined process. Private to this folder.

#include "stridor/base/confined_process.hpp"
#include "stridor/recordings/mat/matio_library.hpp"

namespace stridor::recordings {

/// Answers what is asked of the process' file (`mat_answers.hpp`) until nobody asks any more.
void answer_with_matio(const Matio& matio, const base::ConfinedProcess::Channel& channel);

}  // namespace stridor::recordings
