#pragma once

#include "stridor/hearing/heard_motion.hpp"
#include "stridor/hearing/sound_comparison.hpp"

#include <stop_token>
#include <string>

namespace stridor::io {

/// Writes the heard stretches of a simulated motion as WAV of 24 bits, `rate` samples a second [Hz], the loudest at -1
/// dB of full scale; the file says what its full scale stands for.
///
/// Throws what `hearing::heard_motion` and `hearing::render` throw, and `Error` (io).
void write_simulated_wav(const std::string& file, const hearing::SimulatedSound& simulated, double rate,
                         const hearing::AskedMotion& motion, const std::stop_token& stop);

}  // namespace stridor::io
