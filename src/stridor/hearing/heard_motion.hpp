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

/// Which motion of a case is heard as its sound.
namespace stridor::hearing {

/// The requested motion, by names that a user knows.
struct AskedMotion {
    // "joint": the rubbing part, with several contacts the strongest (`strongest_contact`), of an own structure with
    // outputs the first output; "plate"; the name of one of several joints, of a contact, output or row of an own
    // structure
    std::string of = "joint";
    std::string component{};  // "x" along the surface, "y" across it; empty: x of the rubbing part, y of the plate
    signal::MotionQuantity quantity = signal::MotionQuantity::velocity;
};

/// A motion of one case, and its name.
struct HeardMotion {
    sound::Pickup pickup{};
    std::string of{};
    std::string component{};               // "x", "y"; empty: of an output or row, which has one direction
    std::optional<std::size_t> contact{};  // the contact, if it is a contact's motion
};

/// Returns the contact whose point has the highest level in any phase, as `stridor simulate` prints it. If levels are
/// equal but for rounding, or if the run left no phases, returns the first.
std::size_t strongest_contact(std::span<const record::Tally> phases);

/// Returns the requested motion of a case, by the tallies of its run. Throws `Error` (input) for a name that the case
/// does not have, and for the plate's motion along x, which is the drive.
HeardMotion heard_motion(const parameters::Case& c, const AskedMotion& asked, std::span<const record::Tally> phases);

/// Returns the requested motion of a case that was not run. If the strongest of several contacts is requested, this
/// runs the case; `std::nullopt` if that was stopped. Throws `Error` (input) for a name that is not in it.
std::optional<HeardMotion> heard_motion(const parameters::Case& c, const AskedMotion& asked,
                                        const std::stop_token& stop, integration::Workspace& workspace);

/// Returns the requested motion of a case for a caller that needs it: throws `Error` (interrupted) if the run was
/// stopped.
HeardMotion heard_motion(const parameters::Case& c, const AskedMotion& asked, const std::stop_token& stop = {});

/// Returns a motion in words: "joint velocity along x"
std::string motion_words(const HeardMotion& motion);

/// Returns the requested motion in words before its contact is known: "joint velocity along x", of several contacts
/// "velocity along x of the strongest contact".
std::string motion_words(const parameters::Case& c, const AskedMotion& asked);

/// The spectrum of a motion of a case, and the share of each free mode.
struct HeardModes {
    std::string of{};  // "bow velocity along x"
    analysis::OpenModes modes{};
    analysis::ModalSpectrum spectrum{};
    double from = 0.0;  // [s] the stretch of the run that was analysed
    double to = 0.0;
};

/// Runs a case, and splits the requested velocity into its free modes (`analysis::modal_spectrum`).
///
/// The stretch is the part of the run that is judged, or as much of its end as memory holds. It is sampled at forty
/// times the highest free frequency, at 1 MHz at most, in four frames, half overlapped. The mean is left out, and a
/// motion about it that nowhere exceeds `least_motion` is silence. Throws `Error` (input) for a motion that the case
/// does not have and for a quantity other than velocity, (numerical) for a run without a result, (interrupted) if it
/// was stopped.
HeardModes heard_modes(const parameters::Case& c, const AskedMotion& asked, const std::stop_token& stop = {});

}  // namespace stridor::hearing
