#include "stridor/sound/sections.hpp"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <numeric>
#include <optional>
#include <utility>

// All times are counted in parts of 10 ms. Whether something sounds in a part is known 4 s later. A section begins and
// ends at a sample, so that a pause before a sound leaves its figures as they are.
namespace stridor::sound {

namespace {

constexpr double section_part = 0.01;         // [s]
constexpr double section_corner = 100.0;      // [Hz] below lies what nobody hears
constexpr std::size_t around = 400;           // parts before and after that a level is held against
constexpr double sounding_share = 1e-3;       // [1] 30 dB: what lies lower is a pause
constexpr std::size_t longest_pause = 60;     // parts within a sound
constexpr std::size_t shortest_section = 10;  // parts: a click needs what follows it
constexpr std::size_t earliest_cut = 200;     // parts of a section that is too long
constexpr std::size_t latest_cut = 350;       // parts
constexpr std::size_t cut_width = 10;         // parts whose mean is the smallest there
constexpr auto most_parts = static_cast<std::size_t>(longest_section / section_part);

}  // namespace

struct SectionFinder::State {
    explicit State(double rate)
        : course(rate, signal::corner_within(section_corner, rate), section_part, PartSquares::Samples::kept),
          length(course.length()) {}

    enum class End { open, reached };

    // places count from the first part that is kept
    std::span<const double> squares_of(std::size_t place) const {
        return std::span(course.sample_squares).subspan(length * place, length);
    }

    // [unit²] what a level must exceed to sound in the part that is decided next. Of the parts around it only those
    // are held of which no later one is as loud: the first of them is the loudest.
    double least_level() {
        const std::size_t to = std::min(levels.size(), decided + around + 1);
        for (; met < to; ++met) {
            while (!loudest.empty() && levels[loudest.back()] <= levels[met])
                loudest.pop_back();
            loudest.push_back(met);
        }
        while (loudest.front() + around < decided)
            loudest.pop_front();
        return sounding_share * levels[loudest.front()];
    }

    std::uint64_t sample_of(std::size_t part, std::size_t within) const { return length * (dropped + part) + within; }

    // where a section that is too long is quietest
    std::size_t cut_of(std::size_t from) const {
        const auto level = [&](std::size_t place) {
            const auto here = std::span(levels).subspan(place - cut_width / 2, cut_width);
            return std::accumulate(here.begin(), here.end(), 0.0);
        };
        std::size_t best = from + earliest_cut;
        double least = level(best);
        for (std::size_t k = best + 1; k < from + latest_cut; ++k)
            if (const double here = level(k); here < least) {
                least = here;
                best = k;
            }
        return best;
    }

    void begin(double least) {
        const auto part = squares_of(decided);
        const auto first = std::find_if(part.begin(), part.end(), [&](double level) { return level > least; });
        begun = decided;
        first_sample = sample_of(decided, static_cast<std::size_t>(first - part.begin()));
    }

    void go_on_sounding(double least) {
        const auto part = squares_of(decided);
        const auto end = std::find_if(part.rbegin(), part.rend(), [&](double level) { return level > least; }).base();
        last = decided;
        end_sample = sample_of(decided, static_cast<std::size_t>(end - part.begin()));
    }

    void close() {
        const std::size_t shortest = std::min(levels.size(), *begun + shortest_section);
        sections.push_back({first_sample, std::max(end_sample, sample_of(shortest, 0))});
        begun.reset();
    }

    void go_on(End end) {
        const std::size_t known = levels.size();
        const std::size_t ready = end == End::reached ? known : known - std::min(known, around);
        for (; decided < ready; ++decided) {
            if (begun && decided - last > longest_pause) close();
            const double least = least_level();
            if (!(levels[decided] > least)) continue;
            if (!begun) begin(least);
            go_on_sounding(least);
            if (last + 1 - *begun <= most_parts) continue;
            begun = cut_of(*begun);
            sections.push_back({first_sample, sample_of(*begun, 0)});
            first_sample = sections.back().to;
        }
        if (end == End::reached && begun) close();
        forget();
    }

    // what nothing refers to any more
    void forget() {
        const std::size_t oldest = std::min(begun.value_or(decided), decided);
        const std::size_t old = std::min(decided - std::min(decided, around), oldest);
        // half of them at a time: the others have to move
        if (2 * old < levels.size()) return;
        const auto samples = static_cast<std::ptrdiff_t>(length * old);
        course.sample_squares.erase(course.sample_squares.begin(), course.sample_squares.begin() + samples);
        levels.erase(levels.begin(), levels.begin() + static_cast<std::ptrdiff_t>(old));
        dropped += old;
        decided -= old;
        met -= old;
        while (!loudest.empty() && loudest.front() < old)
            loudest.pop_front();
        for (std::size_t& place : loudest)
            place -= old;
        if (!begun) return;
        *begun -= old;
        last -= old;
    }

    PartSquares course;
    std::size_t length;                            // samples of a part
    std::vector<double>& levels = course.squares;  // [unit²] shape [part kept]
    std::uint64_t dropped = 0;                     // parts no longer kept
    std::size_t decided = 0;                       // the first part of which it is not known whether it sounds
    std::deque<std::size_t> loudest{};             // parts around it, ever softer ones
    std::size_t met = 0;                           // parts that were ever among them
    std::optional<std::size_t> begun{};            // first part of the open section
    std::size_t last = 0;                          // its last part that sounds
    std::uint64_t first_sample = 0;                // of it
    std::uint64_t end_sample = 0;                  // the first one after what sounds in it
    std::vector<SoundSection> sections{};
    std::uint64_t count = 0;  // samples
};

SectionFinder::SectionFinder(double rate) : state_(std::make_unique<State>(rate)) {}
SectionFinder::~SectionFinder() = default;
SectionFinder::SectionFinder(SectionFinder&&) noexcept = default;
SectionFinder& SectionFinder::operator=(SectionFinder&&) noexcept = default;

PartSquares& SectionFinder::parts() {
    return state_->course;
}

std::vector<SoundSection> SectionFinder::push(std::size_t samples) {
    state_->count += samples;
    state_->go_on(State::End::open);
    return std::exchange(state_->sections, {});
}

std::vector<SoundSection> SectionFinder::finish() {
    State& s = *state_;
    s.go_on(State::End::reached);
    const std::uint64_t whole = s.sample_of(s.levels.size(), 0);
    for (SoundSection& section : s.sections)
        // the rest after the last whole part belongs to what sounds there
        if (section.to >= whole) section.to = s.count;
    return std::exchange(s.sections, {});
}

std::uint64_t SectionFinder::needed() const {
    const State& s = *state_;
    return s.sample_of(s.begun.value_or(s.decided), 0);
}

}  // namespace stridor::sound
