#include "stridor/sound/passages.hpp"

#include "stridor/signal/median.hpp"
#include "stridor/signal/side_by_side.hpp"
#include "stridor/signal/spectrum.hpp"
#include "stridor/sound/sections.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace stridor::sound {

namespace {

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

constexpr double level_part = 0.005;    // [s]
constexpr std::size_t sustained = 12;   // parts of a sustained level
constexpr double level_jump = 3.98107;  // [1] of the power, 6 dB
constexpr double drive_corner = 40.0;   // [Hz] below lies the motion of the drive

// The number of parts after which the sustained level jumps first: where the jump is largest of its surroundings. All
// of the `longest` parts if it does not jump; levels 60 dB below the loudest part are all the same.
std::size_t cut_after(std::span<const double> squares, std::size_t longest) {
    const double least = 1e-6 * *std::max_element(squares.begin(), squares.end());
    std::vector<double> levels;  // sustained, from each part on
    const auto add_level = [&] {
        levels.push_back(std::max(least, signal::median_of(squares.subspan(levels.size(), sustained))));
    };
    double best = 1.0;
    std::size_t place = 0;
    for (std::size_t k = sustained; k + sustained <= squares.size() && k <= longest; ++k) {
        while (levels.size() <= k)
            add_level();
        const double before = levels[k - sustained];
        const double after = levels[k];
        const double jump = std::max(after / before, before / after);
        if (jump > best) {
            best = jump;
            place = k;
        }
        const bool is_past = best > level_jump && k >= place + sustained;
        if (is_past) break;
    }
    return best > level_jump ? place : std::min(longest, squares.size());
}

}  // namespace

struct PassageFinder::State {
    explicit State(double the_rate) : rate(the_rate), finder(the_rate), sections(the_rate) {}

    void describe(const std::vector<SoundSection>& found) {
        for (const SoundSection& section : found)
            describe(section);
        // what no section can hold any more
        const std::uint64_t needed = std::min<std::uint64_t>(sections.needed(), forgotten + pending.size());
        // half of them at a time: the others have to move
        if (2 * (needed - std::min(needed, forgotten)) <= pending.size()) return;
        pending.erase(pending.begin(), pending.begin() + static_cast<std::ptrdiff_t>(needed - forgotten));
        forgotten = needed;
    }

    void describe(const SoundSection& section) {
        const std::span<const double> samples =
            std::span(pending).subspan(section.from - forgotten, section.to - section.from);
        Passage passage;
        passage.from = static_cast<double>(section.from) / rate;
        passage.duration = static_cast<double>(samples.size()) / rate;
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
    SectionFinder sections;
    std::vector<double> pending{};
    std::uint64_t forgotten = 0;  // samples before them
    std::vector<Passage> passages{};
    double loudest = 0.0;  // [unit²] A-weighted
    signal::Spectrogram impulses{};
};

PassageFinder::PassageFinder(double rate) : state_(std::make_unique<State>(rate)) {}
PassageFinder::~PassageFinder() = default;
PassageFinder::PassageFinder(PassageFinder&&) noexcept = default;
PassageFinder& PassageFinder::operator=(PassageFinder&&) noexcept = default;

void PassageFinder::push(std::span<const double> samples) {
    signal::push_side_by_side(samples, parts());
    push_parted(samples);
}

PartSquares& PassageFinder::parts() {
    return state_->sections.parts();
}

void PassageFinder::push_parted(std::span<const double> samples) {
    State& s = *state_;
    s.pending.insert(s.pending.end(), samples.begin(), samples.end());
    s.describe(s.sections.push(samples.size()));
}

std::span<const Passage> PassageFinder::found() const {
    return state_->passages;
}

std::vector<Passage> PassageFinder::finish() {
    State& s = *state_;
    const std::vector<SoundSection> last = s.sections.finish();
    for (const SoundSection& section : last)
        s.describe(section);
    // all is silent: there is one passage to say so
    if (s.passages.empty() && last.empty()) s.describe(SoundSection{s.forgotten, s.forgotten + s.pending.size()});
    s.pending.clear();
    return std::move(s.passages);
}

const signal::Spectrogram& PassageFinder::impulses() const {
    return state_->impulses;
}

struct StretchFinder::State {
    explicit State(double the_rate) : rate(the_rate), finder(the_rate), parts(the_rate, drive_corner, level_part) {}

    // describes all stretches that can be cut off; `end`: what is left is cut too
    enum class End { open, reached };
    void describe(End end) {
        const auto longest = static_cast<std::size_t>(longest_stretch / level_part);
        const std::size_t ahead = end == End::reached ? 1 : longest + sustained;
        std::size_t first = 0;
        std::size_t first_part = 0;
        while (parts.squares.size() - first_part >= ahead) {
            // what lies further ahead has come already or not, by the size of what is pushed, and does not count
            const std::size_t seen = std::min(longest + sustained, parts.squares.size() - first_part);
            const std::size_t cut = cut_after(std::span(parts.squares).subspan(first_part, seen), longest);
            std::size_t length = cut * parts.length();
            if (end == End::reached && first_part + cut == parts.squares.size()) length = pending.size() - first;
            describe(std::span(pending).subspan(first, length));
            first += length;
            first_part += cut;
        }
        pending.erase(pending.begin(), pending.begin() + static_cast<std::ptrdiff_t>(first));
        parts.squares.erase(parts.squares.begin(), parts.squares.begin() + static_cast<std::ptrdiff_t>(first_part));
    }

    void describe(std::span<const double> samples) {
        const double from = static_cast<double>(described) / rate;
        described += samples.size();
        if (static_cast<double>(samples.size()) < FeatureFinder::least_duration * rate) return;
        SoundStretch stretch = finder.find(samples);
        stretch.features.from = from;
        stretches.push_back(std::move(stretch));
    }

    double rate;
    FeatureFinder finder;
    PartSquares parts;
    std::vector<double> pending{};  // samples not yet described
    std::uint64_t described = 0;
    std::vector<SoundStretch> stretches{};
};

StretchFinder::StretchFinder(double rate) : state_(std::make_unique<State>(rate)) {}
StretchFinder::~StretchFinder() = default;
StretchFinder::StretchFinder(StretchFinder&&) noexcept = default;
StretchFinder& StretchFinder::operator=(StretchFinder&&) noexcept = default;

void StretchFinder::push(std::span<const double> samples) {
    signal::push_side_by_side(samples, parts());
    push_parted(samples);
}

PartSquares& StretchFinder::parts() {
    return state_->parts;
}

void StretchFinder::push_parted(std::span<const double> samples) {
    State& s = *state_;
    s.pending.insert(s.pending.end(), samples.begin(), samples.end());
    s.describe(State::End::open);
}

std::span<const SoundStretch> StretchFinder::found() const {
    return state_->stretches;
}

std::vector<SoundStretch> StretchFinder::finish() {
    state_->describe(State::End::reached);
    return std::move(state_->stretches);
}

}  // namespace stridor::sound
