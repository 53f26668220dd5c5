#pragma once

#include <string>

namespace stridor::console {

/// Returns the programs that are tried, in this order, as a list: "pw-play, paplay, ...".
std::string known_players();

/// Returns the first player found on PATH; empty if there is none.
std::string find_player();

/// Plays a sound file and waits for its end. Throws `Error` (io) with the player's message if it fails.
void play(const std::string& player, const std::string& path);

}  // namespace stridor::console
