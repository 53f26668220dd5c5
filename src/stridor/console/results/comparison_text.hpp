#pragma once

#include "stridor/classification/compared_sound.hpp"
#include "stridor/hearing/sound_search.hpp"
#include "stridor/io/sound/json_compare.hpp"

#include <span>
#include <string>

namespace stridor::console {

/// Returns a row per figure, a column per sound, and the distances of all from the first.
std::string comparison_text(std::span<const classification::ComparedSound> sounds);

/// Returns "x=20.74 N,y=0.5949,direction=going": the cell as it can be asked for.
std::string match_name(const sweep::Study& study, const hearing::SoundMatch& match);

/// Returns the recording, how much of the chart was listened to, and the nearest cells with what differs.
std::string match_text(const io::MatchReport& report);

}  // namespace stridor::console
