#pragma once

#include "stridor/record/schedule.hpp"
#include "stridor/record/trace.hpp"
#include "stridor/signal/band_limit.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace stridor::sound {

/// Where and how a motion is listened to: at a degree of freedom, or at a point whose motion is a sum of several.
struct Pickup {
    signal::MotionQuantity quantity = signal::MotionQuantity::velocity;
    // [1] shape [dof]: the weight of each degree of freedom in the sum that is heard; empty: the first one alone
    std::vector<double> weights{};
};

/// A stretch of time to be heard.
struct Stretch {
    double from = 0.0;  // [s]
    double to = 0.0;    // [s]
};

/// Trace samples per sample of a sound.
inline constexpr int trace_density = 16;

/// How a motion becomes a sound.
struct AuralisationSettings {
    Pickup pickup{};
    double rate = 48000.0;             // [Hz] of the sound
    double high_pass = 20.0;           // [Hz] slower motion, as the drive's own, is left out; 0: nothing is
    double fade = 5e-3;                // [s] at both ends of each stretch, at most half of it
    std::vector<Stretch> stretches{};  // in order, heard one after the other; empty: everything, without fades
    int density = trace_density;       // [1] trace samples per sample of the sound, at least 4
};

/// Returns the gain at an instant [s] of a stretch that is faded in and out over `fade` [s], at most half of it; 0
/// outside.
double fade_gain(const Stretch& stretch, double fade, double time);

/// Returns the stretches of a run that belong to a direction: its going or its coming phases, whole or only their
/// judged parts. A constant drive has one phase only: then all that is judged or counted.
std::vector<Stretch> stretches_of(const record::Schedule& schedule, record::Phase phase, record::Use least);

/// Returns the time [s] until which a motion of `duration` [s] must be known: 0.1 s behind the last stretch, since
/// filters look ahead; without stretches its end.
double heard_until(const AuralisationSettings& settings, double duration);

/// Returns "m/s" or "m/s^2".
std::string unit_of(signal::MotionQuantity quantity);

/// Makes a sound of a run's trace, block by block: band-limited (`BandLimiter`), without motion that is too slow to be
/// heard, cut to the stretches asked for, each faded in and out.
///
/// The sound is the motion itself in m/s or m/s^2, never a sound pressure: that needs a model of radiation.
class Auralisation {
public:
    /// Takes the settings. The rate must be above zero and more than twice the high pass.
    explicit Auralisation(AuralisationSettings settings);

    /// Returns the request for the trace of a run that lasts `duration` [s], to `heard_until`. `taker` receives each
    /// block of the sound. Call `finish` after the run, and keep this object in its place until then.
    record::TraceRequest request(double duration, std::function<void(std::span<const double>)> taker);

    /// Takes the next block of the trace and returns the part of the sound [m/s or m/s^2] that it completes.
    std::vector<double> add(const record::Trace& trace);

    /// Returns the rest of the sound.
    std::vector<double> finish();

private:
    std::vector<double> heard(std::vector<double> motion);
    double gain_at(double time);

    AuralisationSettings settings_;
    std::optional<signal::BandLimiter> limiter_;
    double first_ = 0.0;       // [s] instant of the first sample
    std::uint64_t count_ = 0;  // samples so far, before the cuts
    std::size_t stretch_ = 0;
    bool has_begun_ = false;
    double memory_[2] = {};  // of the high pass
};

/// Returns the sound of a whole trace, sampled as `Auralisation::request` asks.
signal::Signal auralise(const record::Trace& trace, const AuralisationSettings& settings);

/// Returns the largest magnitude of samples.
double peak(std::span<const double> samples);

}  // namespace stridor::sound
