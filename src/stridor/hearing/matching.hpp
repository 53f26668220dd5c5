#pragma once

#include "stridor/classification/compared_sound.hpp"
#include "stridor/hearing/sound_comparison.hpp"
#include "stridor/hearing/sound_search.hpp"
#include "stridor/signal/band_limit.hpp"

#include <filesystem>
#include <vector>

/// What a search by sound (`search`) asks of a recording, and what it leaves out of a chart.
namespace stridor::hearing {

/// Throws `Error` (input) for a recording that is too short to be described, or silent.
void require_matchable(const classification::ComparedSound& recording);

/// Throws `Error` (input) unless the recording's level is one of the model's motion: a sound pressure would need a
/// model of radiation.
void require_comparable_level(const classification::ComparedSound& recording, signal::MotionQuantity quantity);

/// The rate at which cells are rendered beside a recording: its own, within 8 kHz to 192 kHz [Hz].
double matching_rate(const classification::ComparedSound& recording);

/// The cells that a store knows to be failed, or quiet where noise is heard, shape [cell].
///
/// Throws `Error` (io) where there is no store, and what opening it throws.
std::vector<bool> ruled_out(const sweep::Study& study, const std::filesystem::path& store,
                            classification::Category heard);

/// The cell of a match, as what was listened to.
SimulatedSound simulated_of(const sweep::Study& study, const SoundMatch& match);

}  // namespace stridor::hearing
