#pragma once

#include <string>

namespace stridor::console {

/// The programs that are looked for, in this order, as one would list them: "pw-play, paplay, ...".
std::string known_players();

/// The first player found on PATH; empty if there is none.
std::string find_player();

/// Plays a sound file and waits for its end. Throws `Error` (io) with what the player said where it fails.
void play(const std::string& player, const std::string& path);

}  // namespace stridor::console
