#pragma once

#include "stridor/analysis/modal_spectrum.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/record/tally.hpp"
#include "stridor/sound/auralisation.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>
#include <string>

/// Which motion of a case stands for its sound.
namespace stridor::hearing {

/// The motion that is asked for, by names that a user knows.
struct AskedMotion {
    // "joint": what rubs, of several contacts the strongest (`strongest_contact`), of an own structure with outputs the
    // first of them; "plate"; the name of one of several joints, of a contact, output or row of an own structure
    std::string of = "joint";
    std::string component{};  // "x" along the surface, "y" across it; empty: x of what rubs, y of the plate
    signal::MotionQuantity quantity = signal::MotionQuantity::velocity;
};

/// A motion of one case, and what it is called.
struct HeardMotion {
    sound::Pickup pickup{};
    std::string of{};
    std::string component{};               // "x", "y"; empty: of an output or row, which has one direction
    std::optional<std::size_t> contact{};  // whose it is, if a contact's
};

/// The contact whose point has the highest level in any phase, as `stridor simulate` prints it; of equals but for
/// rounding the first, and likewise of a run that left no phases.
std::size_t strongest_contact(std::span<const record::Tally> phases);

/// The motion of a case that is asked for, by what its run left. Throws `Error` (input) for a name that nothing of the
/// case has, and for the plate's motion along x, which is the drive.
HeardMotion heard_motion(const parameters::Case& c, const AskedMotion& asked, std::span<const record::Tally> phases);

/// The same of a case that was not run. Where the strongest of several contacts is asked for it takes a run; nothing if
/// that was stopped.
std::optional<HeardMotion> heard_motion(const parameters::Case& c, const AskedMotion& asked,
                                        const std::stop_token& stop, integration::Workspace& workspace);

/// The same for a caller that cannot go on without it: throws `Error` (interrupted) if it was stopped.
HeardMotion heard_motion(const parameters::Case& c, const AskedMotion& asked, const std::stop_token& stop = {});

/// "joint velocity along x"
std::string motion_words(const HeardMotion& motion);

/// The same of what is asked for, whichever contact it will be: "joint velocity along x", of several contacts "velocity
/// along x of the strongest contact".
std::string motion_words(const parameters::Case& c, const AskedMotion& asked);

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
