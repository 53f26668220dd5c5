#pragma once

#include "stridor/analysis/modal_spectrum.hpp"
#include "stridor/hearing/heard_motion.hpp"
#include "stridor/parameters/case.hpp"

#include <stop_token>
#include <string>

namespace stridor::hearing {

/// The spectrum of a motion of a case, and what each free mode has of it.
struct HeardModes {
    std::string of{};  // "bow velocity along x"
    analysis::OpenModes modes{};
    analysis::ModalSpectrum spectrum{};
    double from = 0.0;  // [s] the stretch of the run that it is of
    double to = 0.0;
};

/// Runs a case, and takes the velocity that is asked for apart into its free modes (`analysis::modal_spectrum`).
///
/// The stretch is the part of the run that is judged, or as much of its end as memory holds. It is sampled at forty
/// times the highest free frequency, at 1 MHz at most, in four frames, half overlapped. The mean is left out, and a
/// motion about it that nowhere exceeds `least_motion` is silence. Throws `Error` (input) for what is not in the case
/// and for a quantity that is no velocity, (numerical) for a run without a result, (interrupted) if it was stopped.
HeardModes heard_modes(const parameters::Case& c, const AskedMotion& asked, const std::stop_token& stop = {});

}  // namespace stridor::hearing
