#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

/// The imposed motion of the plate, or a force, and what the program asks of it. Which kind it is, only this file pair,
/// the field table and the check know.
namespace stridor::parameters {

/// How the plate's velocity V follows time.
enum class DriveKind { sinusoidal, constant, sampled, trapezoidal, force };

inline constexpr std::array<std::string_view, 5> drive_names{"sinusoidal", "constant", "sampled", "trapezoidal",
                                                             "force"};

/// Which way the plate moves under the joint: going is V > 0, coming V < 0.
enum class Direction { going, coming };

inline constexpr std::array<std::string_view, 2> direction_names{"going", "coming"};

/// The imposed tangential motion of the plate, x2(t), with V = dx2/dt > 0 called *going* and V < 0 *coming*.
struct Drive {
    DriveKind kind = DriveKind::sinusoidal;
    double amplitude = 4e-3;         // [m] A_exc, sinusoidal: x2 = A sin(2 pi f t)
    double frequency = 5.0;          // [Hz] f_exc, sinusoidal, trapezoidal and force
    double velocity = 0.1;           // [m/s] constant: V; trapezoidal: V on the way there, -V on the way back
    double ramp = 0.02;              // [s] trapezoidal: from standing still to full velocity, or back; force: to full
    double force = 1.0;              // [N] force: F of F cos(2 pi f t) while the surface stands still
    double phase = 0.0;              // [deg] sinusoidal, trapezoidal, force: 360 f t of the drive when the run begins
    std::string file;                // sampled: a CSV with the columns time and velocity
    std::vector<double> times;       // [s] sampled: instants, strictly increasing from 0, shape [sample]
    std::vector<double> velocities;  // [m/s] sampled: V at them, linear in between, shape [sample]
};

/// V(t) as engines, schedules and checks see it. It is one of three, whatever the kind of drive:
///
///     steady     V = velocity, for ever           no frequency, no corners
///     harmonic   V = velocity cos(2 pi (f t + turns))   f = frequency
///     cornered   V linear from corner to corner   `times` and `velocities`
struct VelocityProfile {
    double velocity = 0.0;           // [m/s] steady: V; harmonic: its peak
    double frequency = 0.0;          // [Hz] harmonic: f, else 0
    double amplitude = 0.0;          // [m] harmonic: of x2
    double turns = 0.0;              // [1] harmonic: of a period that have gone by at t = 0
    std::vector<double> times;       // [s] cornered: where the slope of V changes, rising from 0, shape [corner]
    std::vector<double> velocities;  // [m/s] V there, shape [corner]
};

/// Returns how much of a period has gone by when the run begins [1]; 0 of a drive without a period.
double turns_at_start(const Drive& drive);

/// Returns its kind, as a case names it.
std::string_view kind_name(const Drive& drive);

/// Returns V(t) from 0 to `until` [s] at least. A sampled drive ends with its samples.
VelocityProfile velocity_profile(const Drive& drive, double until = 0.0);

/// Says whether V is the same for ever, and nothing else moves the structure. Then a run may end once its future is
/// proven.
bool is_steady(const Drive& drive);

/// Says whether the surface never turns round. Then a run has one phase.
bool has_one_phase(const Drive& drive);

/// Says whether a force shakes the structure while the surface stands still.
bool is_by_force(const Drive& drive);

/// Returns how often the motion repeats itself, with one going and one coming phase [Hz]; 0 if it does not.
double repetition_rate(const Drive& drive);

/// Says whether it comes from a file. Then its numbers are no fields, and nobody knows them who has only the case's
/// text.
bool is_of_file(const Drive& drive);

/// Returns which way a steady drive moves the plate: the sign of its velocity.
Direction steady_direction(const Drive& drive);

/// Returns the directions in which its runs are judged: that of a drive with one phase; else going and coming.
std::vector<Direction> judged_directions(const Drive& drive);

/// Returns the largest |V| [m/s] that the fields of a drive say; not a number for one of a file.
double greatest_speed(const Drive& drive);

}  // namespace stridor::parameters
