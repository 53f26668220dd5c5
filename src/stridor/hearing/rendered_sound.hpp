#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/record/recorder.hpp"
#include "stridor/recordings/bytes.hpp"
#include "stridor/signal/source.hpp"
#include "stridor/sound/auralisation.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stop_token>

namespace stridor::hearing {

/// A sound of one channel that is made block by block and can be read again from its beginning. It lies in a nameless
/// temporary file, so that hours of it never stand in memory.
class RenderedSound final : public signal::Source {
public:
    /// Makes an empty sound of a rate [Hz]; `unit` is that of its samples.
    RenderedSound(double rate, std::string unit);

    /// Adds samples [unit] at the end. Throws `Error` (io) if the disk is full.
    void append(std::span<const double> samples);

    /// Lets the next read begin with the first sample.
    void rewind();

    double peak() const { return peak_; }  // [unit] largest magnitude
    double mean_square() const;            // [unit^2]
    /// Returns the number of samples so far [1].
    std::uint64_t frames() const { return *layout_.frames; }

    const signal::ChannelLayout& layout() const override { return layout_; }
    std::size_t read(std::span<double> frames) override;

private:
    signal::ChannelLayout layout_;
    recordings::Spool file_;
    std::uint64_t next_ = 0;  // [bytes] where the next read begins
    double peak_ = 0.0;
    double square_sum_ = 0.0;
};

/// Called with the rendered time of the run [s].
using RenderProgress = std::function<void(double)>;

/// A sound with the record of its run.
struct Rendering {
    std::unique_ptr<RenderedSound> sound;
    record::Record record;
};

/// Simulates a case and returns its sound [m/s or m/s^2].
///
/// Throws `Error` for a run that has no result or was stopped, and for a beta_2 step too long to be heard.
Rendering render(const parameters::Case& c, const sound::AuralisationSettings& settings, record::KeepHistory history,
                 const std::stop_token& stop, const RenderProgress& progress);

/// Simulates a case and returns its sound alone [m/s or m/s^2]. Throws `Error` for a run that has no result or was
/// stopped, and for a beta_2 step too long to be heard.
std::unique_ptr<RenderedSound> render(const parameters::Case& c, const sound::AuralisationSettings& settings,
                                      const std::stop_token& stop, const RenderProgress& progress);

}  // namespace stridor::hearing
