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

/// A sound of one channel that is made block by block and read again from its beginning, as often as wanted: in a
/// temporary file without a name, so that hours of it never stand in memory.
class RenderedSound final : public signal::Source {
public:
    /// An empty sound of a rate [Hz]; `unit` is that of its samples.
    RenderedSound(double rate, std::string unit);

    /// Adds samples [unit] at the end. Throws `Error` (io) where the disk is full.
    void append(std::span<const double> samples);

    /// The next read begins with the first sample.
    void rewind();

    double peak() const { return peak_; }  // [unit] largest magnitude
    double mean_square() const;            // [unit^2]
    /// Samples so far [1].
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

/// Is told how much of the run [s] is rendered.
using RenderProgress = std::function<void(double)>;

/// A sound with the rest of what its run left.
struct Rendering {
    std::unique_ptr<RenderedSound> sound;
    record::Record record;
};

/// Simulates a case and makes the sound of it [m/s or m/s^2].
///
/// Throws `Error` for a run that has no result or was stopped, and for a beta_2 step too long to be heard.
Rendering render(const parameters::Case& c, const sound::AuralisationSettings& settings, record::KeepHistory history,
                 const std::stop_token& stop, const RenderProgress& progress);

/// The sound alone.
std::unique_ptr<RenderedSound> render(const parameters::Case& c, const sound::AuralisationSettings& settings,
                                      const std::stop_token& stop, const RenderProgress& progress);

}  // namespace stridor::hearing
