#pragma once

#include "stridor/parameters/case.hpp"

#include <array>
#include <string_view>

/// Numbers of a case that others publish, each computed by the engine that the case names.
///
/// `about` says what the case does not: an instant, a phase, a range. Each throws `Error` (numerical) for a run without
/// a result.
namespace stridor::verification {

/// How a quantity is computed from a case.
using QuantityOfCase = double (*)(const parameters::Case& c, std::string_view about);

/// Returns half the range of the slip displacement of the first contact over the window [m].
double slip_amplitude(const parameters::Case& c, std::string_view about);

/// Returns the tangential position of the first contact at the instant `about` [m].
double position_at(const parameters::Case& c, std::string_view about);

/// Returns how far the first contact has slipped by the instant `about`, from where the surface was at t = 0 [m].
double slip_at(const parameters::Case& c, std::string_view about);

/// Returns the slip velocity of the first contact at the instant `about` [m/s].
double slip_velocity_at(const parameters::Case& c, std::string_view about);

/// Returns the largest friction force of the first contact over the window, and its largest slip velocity [N], [m/s].
double greatest_friction(const parameters::Case& c, std::string_view about);
double greatest_slip_velocity(const parameters::Case& c, std::string_view about);

/// Returns the mean time from one release of the first contact to the next [s].
double release_period(const parameters::Case& c, std::string_view about);

/// Returns the mean time from a release of the first contact to its next stick [s].
double slip_time(const parameters::Case& c, std::string_view about);

/// Returns the share of time between releases in which the first contact sticks [1].
double stick_share(const parameters::Case& c, std::string_view about);

/// Returns the mean of N |w| over the window [W]: the friction power over mu_d.
double wear_power(const parameters::Case& c, std::string_view about);

/// Returns the root mean square of the first output's velocity over the window [m/s].
double output_rms(const parameters::Case& c, std::string_view about);

/// Returns the number of the category of the phase `about` (`classification::category_names`); empty: the only one.
double category(const parameters::Case& c, std::string_view about);

/// Returns the share of time in which the first contact slips, judged part of the phase `about` [1].
double slip_share(const parameters::Case& c, std::string_view about);

/// Returns where steady sliding first becomes stable, or ceases to be, along the range `about`: going or, if not there,
/// coming.
double stability_limit(const parameters::Case& c, std::string_view about);

/// What a rig is seen to do under a steady drive.
inline constexpr std::array<std::string_view, 2> motion_names{"steady", "slips"};

/// Returns the number of the motion (`motion_names`) that the first contact takes: it slips by fits and starts once
/// steady sliding is unstable, going.
double motion_under_steady_drive(const parameters::Case& c, std::string_view about);

/// Returns the frequency of the mode that begins to grow there [Hz].
double stability_frequency(const parameters::Case& c, std::string_view about);

/// Returns the value of the range `about` at which the first contact begins to stick, or ceases to.
double stick_limit(const parameters::Case& c, std::string_view about);

/// Returns the bow force of the range `about` beyond which a string leaves Helmholtz's motion, one slip in each period
/// that is about as long as the bow's place says [N].
double greatest_helmholtz_force(const parameters::Case& c, std::string_view about);

}  // namespace stridor::verification
