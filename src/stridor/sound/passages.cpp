#include "stridor/sound/passages.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>

namespace stridor::sound {

namespace {

constexpr double longest_rest = 1.0;     // [s] that the last passage takes in
constexpr double least_duration = 0.02;  // [s]

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
        passages.push_back(std::move(passage));
    }

    double rate;
    ToneFinder finder;
    std::vector<double> pending{};
    std::uint64_t described = 0;
    std::vector<Passage> passages{};
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

}  // namespace stridor::sound
