#include "stridor/signal/sound_analysis.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/signal/bands.hpp"
#include "stridor/signal/filter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stridor::signal {

namespace {

constexpr double part_time = 0.005;    // [s]
constexpr std::size_t sustained = 12;  // parts of a sustained level
constexpr double level_jump = 6.0;     // [dB]
constexpr double drive_corner = 40.0;  // [Hz] below lies the motion of the drive
constexpr double frame_time = 0.085;   // [s] of the spectra
constexpr std::size_t most_extents = 4096;
constexpr std::size_t block_frames = 1U << 16U;

// the waveform's extremes; when they become too many, neighbours are joined
class Outline {
public:
    explicit Outline(double rate)
        : rate_(rate),
          stride_(std::max<std::size_t>(1, static_cast<std::size_t>(rate / 500.0))) {}

    void push(std::span<const double> samples) {
        for (const double x : samples) {
            current_ = {std::min(current_.low, x), std::max(current_.high, x)};
            if (++filled_ == stride_) keep();
        }
    }

    Waveform waveform() const { return {static_cast<double>(stride_) / rate_, extents_}; }

private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    void keep() {
        extents_.push_back(current_);
        current_ = {infinity, -infinity};
        filled_ = 0;
        if (extents_.size() < most_extents) return;
        for (std::size_t k = 0; 2 * k < most_extents; ++k)
            extents_[k] = {std::min(extents_[2 * k].low, extents_[2 * k + 1].low),
                           std::max(extents_[2 * k].high, extents_[2 * k + 1].high)};
        extents_.resize(most_extents / 2);
        stride_ *= 2;
    }

    double rate_;
    std::size_t stride_;
    std::size_t filled_ = 0;
    Extent current_{infinity, -infinity};
    std::vector<Extent> extents_{};
};

// mean squares of 5 ms parts, the drive's motion taken away
class Parts {
public:
    explicit Parts(double rate)
        : section_(high_pass(drive_corner, rate, 2).front()),
          length_(std::max<std::size_t>(1, static_cast<std::size_t>(part_time * rate))) {}

    std::size_t length() const { return length_; }

    void push(std::span<const double> samples) {
        for (const double x : samples) {
            const double y = section_.b0 * x + first_;
            first_ = section_.b1 * x - section_.a1 * y + second_;
            second_ = section_.b2 * x - section_.a2 * y;
            sum_ += y * y;
            if (++filled_ < length_) continue;
            squares.push_back(sum_ / static_cast<double>(length_));
            sum_ = 0.0;
            filled_ = 0;
        }
    }

    std::vector<double> squares{};  // of the parts not yet cut off

private:
    Biquad section_;
    std::size_t length_;
    std::size_t filled_ = 0;
    double sum_ = 0.0;
    double first_ = 0.0;
    double second_ = 0.0;
};

double median_of(std::span<const double> values) {
    std::vector<double> sorted(values.begin(), values.end());
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return *middle;
}

// The number of parts after which the sustained level jumps first: where the jump is largest of its surroundings. All of
// the `longest` parts if it does not jump; levels 60 dB below the loudest part are all the same.
std::size_t cut_after(std::span<const double> squares, std::size_t longest) {
    const double least = 1e-6 * *std::max_element(squares.begin(), squares.end());
    double best = 0.0;
    std::size_t place = 0;
    for (std::size_t k = sustained; k + sustained <= squares.size() && k <= longest; ++k) {
        const double before = std::max(least, median_of(squares.subspan(k - sustained, sustained)));
        const double after = std::max(least, median_of(squares.subspan(k, sustained)));
        const double jump = std::abs(10.0 * std::log10(after / before));
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

struct ChannelAnalyser::State {
    State(double the_rate, Channel the_channel)
        : channel(std::move(the_channel)),
          rate(the_rate),
          size(power_of_two_near(frame_time, the_rate)),
          finder(the_rate),
          parts(the_rate),
          meter(the_rate, reference_of(channel.unit)),
          outline(the_rate),
          graph(the_rate / static_cast<double>(size), 0.5 * static_cast<double>(size) / the_rate, size / 2 + 1),
          average(the_rate, {size, Window::hann}, [this](std::span<const double> density) { take(density); }) {
        for (std::size_t k = 0; k <= size / 2; ++k)
            weights.push_back(a_weighting(static_cast<double>(k) * average.spacing()) * average.spacing());
    }

    void take(std::span<const double> density) {
        graph.push(density);
        double weighted = 0.0;
        for (std::size_t k = 0; k < density.size(); ++k)
            weighted += weights[k] * density[k];
        greatest_weighted = std::max(greatest_weighted, weighted);
    }

    // describes all stretches that can be cut off; `end`: what is left is cut too
    enum class End { open, reached };
    void describe(End end) {
        const auto longest = static_cast<std::size_t>(longest_stretch / part_time);
        const std::size_t ahead = end == End::reached ? 1 : longest + sustained;
        std::size_t first = 0;
        std::size_t first_part = 0;
        while (parts.squares.size() - first_part >= ahead) {
            const std::size_t cut = cut_after(std::span(parts.squares).subspan(first_part), longest);
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

    Channel channel;
    double rate;
    std::size_t size;
    FeatureFinder finder;
    Parts parts;
    LevelMeter meter;
    Outline outline;
    Spectrograph graph;
    std::vector<double> weights{};
    double greatest_weighted = 0.0;
    Welch average;
    std::vector<double> pending{};
    std::uint64_t described = 0;
    std::uint64_t count = 0;
    double squares = 0.0;
    double peak = 0.0;
    std::vector<SoundStretch> stretches{};
};

ChannelAnalyser::ChannelAnalyser(double rate, Channel channel)
    : state_(std::make_unique<State>(rate, std::move(channel))) {}
ChannelAnalyser::~ChannelAnalyser() = default;
ChannelAnalyser::ChannelAnalyser(ChannelAnalyser&&) noexcept = default;
ChannelAnalyser& ChannelAnalyser::operator=(ChannelAnalyser&&) noexcept = default;

void ChannelAnalyser::push(std::span<const double> samples) {
    State& s = *state_;
    for (const double x : samples) {
        s.squares += x * x;
        s.peak = std::max(s.peak, std::abs(x));
    }
    s.count += samples.size();
    s.meter.push(samples);
    s.outline.push(samples);
    s.average.push(samples);
    s.parts.push(samples);
    s.pending.insert(s.pending.end(), samples.begin(), samples.end());
    s.describe(State::End::open);
}

SoundAnalysis ChannelAnalyser::finish() {
    State& s = *state_;
    s.describe(State::End::reached);
    SoundAnalysis result;
    result.name = s.channel.name;
    result.unit = s.channel.unit;
    result.rate = s.rate;
    result.duration = static_cast<double>(s.count) / s.rate;
    result.mean_square = s.count == 0 ? 0.0 : s.squares / static_cast<double>(s.count);
    result.peak = s.peak;
    result.level = s.meter.history();
    result.spectrum = s.average.spectrum();
    result.spectrum.unit = s.channel.unit;
    result.spectrogram = s.graph.spectrogram();
    result.spectrogram.unit = s.channel.unit;
    result.greatest_weighted = s.greatest_weighted;
    result.waveform = s.outline.waveform();
    result.stretches = std::move(s.stretches);
    return result;
}

namespace {

void check(const Layout& layout) {
    constexpr double lowest = 1000.0;  // [Hz] below there is no sound to hear
    constexpr double highest = 1e7;    // [Hz] above there is no such recorder
    constexpr std::size_t most = 64;   // channels, a few megabytes each
    if (!(layout.rate >= lowest && layout.rate <= highest))
        throw Error(ErrorKind::input, {"a rate of " + base::shortest(layout.rate) + " Hz is none of a sound",
                                       "it must lie between 1000 Hz and 10 MHz", "Is it given in Hz?"});
    if (layout.channels.empty() || layout.channels.size() > most)
        throw Error(ErrorKind::input, {"the recording has " + std::to_string(layout.channels.size()) + " channels",
                                       "from 1 to 64 can be analysed at a time", "Choose one of them."});
}

}  // namespace

void one_after_the_other(std::size_t count, const std::function<void(std::size_t)>& work) {
    for (std::size_t k = 0; k < count; ++k)
        work(k);
}

std::vector<SoundAnalysis> analyse(Source& source, const Progress& progress, const Runner& run) {
    const Layout layout = source.layout();
    check(layout);
    const std::size_t width = layout.channels.size();
    std::vector<ChannelAnalyser> analysers;
    for (const Channel& channel : layout.channels)
        analysers.emplace_back(layout.rate, channel);
    std::vector<double> block(block_frames * width);
    std::vector<std::vector<double>> channels(width);
    std::uint64_t done = 0;
    while (const std::size_t count = source.read(block)) {
        for (std::size_t channel = 0; channel < width; ++channel) {
            channels[channel].resize(count);
            for (std::size_t frame = 0; frame < count; ++frame) {
                const double x = block[frame * width + channel];
                if (!std::isfinite(x))
                    throw Error(
                        ErrorKind::input,
                        {"sample " + std::to_string(done + frame + 1) + " is " + base::shortest(x),
                         "a sound has finite samples only", "Was it written by another program with an error?"});
                channels[channel][frame] = x;
            }
        }
        run(width, [&](std::size_t channel) { analysers[channel].push(channels[channel]); });
        done += count;
        if (progress) progress(done);
    }
    if (done == 0) throw Error(ErrorKind::input, {"the recording holds no samples", "there is nothing to analyse", ""});
    std::vector<SoundAnalysis> results;
    for (ChannelAnalyser& analyser : analysers)
        results.push_back(analyser.finish());
    return results;
}

std::size_t loudest(std::span<const SoundAnalysis> channels) {
    const auto square = [](const SoundAnalysis& channel) {
        const double reference = reference_of(channel.unit);
        return channel.mean_square / (reference * reference);
    };
    const auto found = std::max_element(channels.begin(), channels.end(),
                                        [&](const auto& a, const auto& b) { return square(a) < square(b); });
    return static_cast<std::size_t>(found - channels.begin());
}

}  // namespace stridor::signal
