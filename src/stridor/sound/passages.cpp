#include "stridor/sound/passages.hpp"

#include "stridor/signal/spectrum.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace stridor::sound {

namespace {

constexpr double longest_rest = 1.0;     // [s] that the last passage takes in
constexpr double least_duration = 0.02;  // [s]
constexpr double impulse_frame = 0.005;  // [s] longer ones smear impulses, shorter ones lose the pitch of their ringing
constexpr double impulse_band = 12e3;    // [Hz]
constexpr double clearly_louder = 1.12;  // [1] 0.5 dB: of a steady sound not every passage is drawn anew

// of a passage that begins at `from` [s]
signal::Spectrogram impulse_graph(std::span<const double> samples, double rate, double from) {
    const std::size_t size = signal::power_of_two_near(impulse_frame, rate);
    const double spacing = rate / static_cast<double>(size);
    const std::size_t lines = std::min(static_cast<std::size_t>(impulse_band / spacing), size / 2) + 1;
    signal::Spectrograph graph(spacing, 0.5 / spacing, lines, {128, 2048});
    signal::Welch frames(rate, {size, signal::Window::hann},
                         [&](std::span<const double> density) { graph.push(density); });
    frames.push(samples);
    signal::Spectrogram result = graph.spectrogram();
    result.from += from;
    return result;
}

}  // namespace

struct PassageFinder::State {
    explicit State(double the_rate) : rate(the_rate), finder(the_rate) {}

    void describe(std::span<const double> samples) {
        Passage passage;
        passage.from = static_cast<double>(described) / rate;
        passage.duration = static_cast<double>(samples.size()) / rate;
        described += samples.size();
        if (passage.duration < least_duration) return;
        passage.tones = finder.find(samples);
        passage.onsets = onsets_of(samples, rate);
        for (TonePoint& point : passage.tones.pitch)
            point.time += passage.from;
        for (double& instant : passage.onsets.instants)
            instant += passage.from;
        if (passage.tones.mean_square > clearly_louder * loudest) {
            loudest = passage.tones.mean_square;
            impulses = impulse_graph(samples, rate, passage.from);
        }
        passages.push_back(std::move(passage));
    }

    double rate;
    ToneFinder finder;
    std::vector<double> pending{};
    std::uint64_t described = 0;
    std::vector<Passage> passages{};
    double loudest = 0.0;  // [unit²] A-weighted
    signal::Spectrogram impulses{};
};

PassageFinder::PassageFinder(double rate) : state_(std::make_unique<State>(rate)) {}
PassageFinder::~PassageFinder() = default;
PassageFinder::PassageFinder(PassageFinder&&) noexcept = default;
PassageFinder& PassageFinder::operator=(PassageFinder&&) noexcept = default;

void PassageFinder::push(std::span<const double> samples) {
    State& s = *state_;
    s.pending.insert(s.pending.end(), samples.begin(), samples.end());
    const auto length = static_cast<std::size_t>(passage_time * s.rate);
    const auto rest = static_cast<std::size_t>(longest_rest * s.rate);
    std::size_t first = 0;
    while (s.pending.size() - first > length + rest) {
        s.describe(std::span(s.pending).subspan(first, length));
        first += length;
    }
    s.pending.erase(s.pending.begin(), s.pending.begin() + static_cast<std::ptrdiff_t>(first));
}

std::vector<Passage> PassageFinder::finish() {
    state_->describe(state_->pending);
    state_->pending.clear();
    return std::move(state_->passages);
}

const signal::Spectrogram& PassageFinder::impulses() const {
    return state_->impulses;
}

}  // namespace stridor::sound
