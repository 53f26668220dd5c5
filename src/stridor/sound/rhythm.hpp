#pragma once

#include <span>

namespace stridor::sound {

/// Returns how much one pace stands out of a sound [dB]: of the spectrum of its amplitude between 4 and 200 Hz, in
/// twelfths of an octave, the greatest power over the geometric mean of all. Music and machines keep a pace, the
/// intervals of a creak glide. 0: silence, or less than 16 ms.
///
/// `squares` [unit²] are the mean squares of equal parts of `part` [s].
double rhythm_of(std::span<const double> squares, double part);

}  // namespace stridor::sound
