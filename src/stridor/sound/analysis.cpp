#include "stridor/sound/analysis.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/signal/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace stridor::sound {

namespace {

constexpr double spectrum_time = 0.085;  // [s] of the spectra
constexpr std::size_t most_extents = 4096;
constexpr std::size_t block_frames = 1U << 16U;
// [unit] less is silence: the fourth powers of what is smaller leave double precision, and 0/0 is no figure
constexpr double smallest_sample = 1e-60;
constexpr double lowest_heard = 40.0;  // [Hz] below lies the motion of the drive

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
    SampleExtent current_{infinity, -infinity};
    std::vector<SampleExtent> extents_{};
};

}  // namespace

struct ChannelOverview::State {
    State(double the_rate, signal::Channel the_channel)
        : channel(std::move(the_channel)),
          rate(the_rate),
          size(signal::power_of_two_near(spectrum_time, the_rate)),
          meter(the_rate, signal::reference_of(channel.unit)),
          outline(the_rate),
          graph(the_rate / static_cast<double>(size), 0.5 * static_cast<double>(size) / the_rate, size / 2 + 1),
          average(the_rate, {size, signal::Window::hann}, [this](std::span<const double> density) { take(density); }) {
        for (std::size_t k = 0; k <= size / 2; ++k)
            weights.push_back(signal::a_weighting(static_cast<double>(k) * average.spacing()) * average.spacing());
    }

    void take(std::span<const double> density) {
        graph.push(density);
        double weighted = 0.0;
        for (std::size_t k = 0; k < density.size(); ++k)
            weighted += weights[k] * density[k];
        greatest_weighted = std::max(greatest_weighted, weighted);
    }

    signal::Channel channel;
    double rate;
    std::size_t size;
    signal::LevelMeter meter;
    Outline outline;
    signal::Spectrograph graph;
    std::vector<double> weights{};
    double greatest_weighted = 0.0;
    signal::Welch average;
    std::uint64_t count = 0;
    double squares = 0.0;
    double peak = 0.0;
};

ChannelOverview::ChannelOverview(double rate, signal::Channel channel)
    : state_(std::make_unique<State>(rate, std::move(channel))) {}
ChannelOverview::~ChannelOverview() = default;
ChannelOverview::ChannelOverview(ChannelOverview&&) noexcept = default;
ChannelOverview& ChannelOverview::operator=(ChannelOverview&&) noexcept = default;

void ChannelOverview::push(std::span<const double> samples) {
    State& s = *state_;
    for (const double x : samples) {
        s.squares += x * x;
        s.peak = std::max(s.peak, std::abs(x));
    }
    s.count += samples.size();
    s.meter.push(samples);
    s.outline.push(samples);
    s.average.push(samples);
}

SoundAnalysis ChannelOverview::finish() {
    State& s = *state_;
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
    return result;
}

namespace {

void check(const signal::ChannelLayout& layout) {
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

using Channels = std::vector<std::vector<double>>;  // [unit] shape [channel][frame]

// The part of a signal that stands still where it outweighs what moves: gravity, a bias, an offset. Else 0: filters
// then take away what there is, and the samples keep their bits.
double standing_part(std::span<const double> samples) {
    const auto count = static_cast<double>(samples.size());
    const double mean = std::accumulate(samples.begin(), samples.end(), 0.0) / count;
    double moving = 0.0;
    for (const double x : samples)
        moving += (x - mean) * (x - mean);
    return mean * mean * count > moving ? mean : 0.0;
}

// A recording block by block, channel by channel, of samples to compute with only. What stands still in the first block
// is taken away from all: its beginning would be heard as a blow, and its level as loudness.
class BlockReader {
public:
    explicit BlockReader(signal::Source& source)
        : source_(source),
          width_(source.layout().channels.size()),
          block_(block_frames * width_) {}

    // how many frames there were: 0 at the end
    std::size_t read(Channels& channels) {
        const std::size_t count = source_.read(block_);
        channels.resize(width_);
        for (std::size_t channel = 0; channel < width_; ++channel) {
            channels[channel].resize(count);
            for (std::size_t frame = 0; frame < count; ++frame) {
                const double x = block_[frame * width_ + channel];
                if (!signal::is_sample(x)) refuse(x, channel, done_ + frame + 1);
                channels[channel][frame] = std::abs(x) < smallest_sample ? 0.0 : x;
            }
        }
        if (count > 0) take_standing_parts(channels);
        done_ += count;
        return count;
    }

private:
    void take_standing_parts(Channels& channels) {
        for (std::size_t channel = 0; channel < width_; ++channel) {
            if (done_ == 0) standing_.push_back(standing_part(channels[channel]));
            if (standing_[channel] == 0.0) continue;
            for (double& x : channels[channel])
                x -= standing_[channel];
        }
    }

    [[noreturn]] void refuse(double x, std::size_t channel, std::uint64_t number) const {
        throw Error(ErrorKind::input, signal::sample_problem(x, source_.layout().channels[channel], number));
    }

    signal::Source& source_;
    std::size_t width_;
    std::vector<double> block_;
    std::vector<double> standing_{};  // [unit] shape [channel]
    std::uint64_t done_ = 0;
};

}  // namespace

bool is_heard_through_air(const signal::Channel& channel) {
    return channel.unit == "Pa" || channel.unit == signal::full_scale;
}

void one_after_the_other(std::size_t count, const std::function<void(std::size_t)>& work) {
    for (std::size_t k = 0; k < count; ++k)
        work(k);
}

std::vector<SoundAnalysis> analyse(signal::Source& source, const AnalysisProgress& progress, const Runner& run,
                                   std::optional<SoundField> field) {
    const signal::ChannelLayout layout = source.layout();
    check(layout);
    const std::size_t width = layout.channels.size();
    std::vector<StretchFinder> finders;
    std::vector<ChannelOverview> overviews;
    for (const signal::Channel& channel : layout.channels) {
        finders.emplace_back(layout.rate);
        overviews.emplace_back(layout.rate, channel);
    }
    std::vector<PassageFinder> passages;
    std::vector<std::size_t> heard;  // their channels
    std::vector<SoundQualityMeter> meters;
    std::vector<std::size_t> metered;  // likewise
    for (std::size_t channel = 0; channel < width; ++channel) {
        if (is_heard_through_air(layout.channels[channel])) {
            passages.emplace_back(layout.rate);
            heard.push_back(channel);
        }
        if (field && layout.channels[channel].unit == "Pa") {
            meters.emplace_back(layout.rate, *field);
            metered.push_back(channel);
        }
    }
    const std::size_t described = 2 * width;
    const std::size_t passed = described + passages.size();
    const std::size_t listened = passed + meters.size();
    BlockReader reader(source);
    Channels here;
    Channels next;
    std::uint64_t done = 0;
    if (reader.read(here) == 0)
        throw Error(ErrorKind::input, {"the recording holds no samples", "there is nothing to analyse", ""});
    while (!here.front().empty()) {
        // the dearest pieces first, and the next block is read beside them
        run(listened + 1, [&](std::size_t piece) {
            if (piece < width)
                finders[piece].push(here[piece]);
            else if (piece < described)
                overviews[piece - width].push(here[piece - width]);
            else if (piece < passed)
                passages[piece - described].push(here[heard[piece - described]]);
            else if (piece < listened)
                meters[piece - passed].push(here[metered[piece - passed]]);
            else
                reader.read(next);
        });
        done += here.front().size();
        if (progress) progress(done);
        std::swap(here, next);
    }
    std::vector<SoundAnalysis> results;
    for (std::size_t channel = 0; channel < width; ++channel) {
        results.push_back(overviews[channel].finish());
        results.back().stretches = finders[channel].finish();
    }
    for (std::size_t k = 0; k < passages.size(); ++k) {
        SoundAnalysis& result = results[heard[k]];
        result.passages = passages[k].finish();
        result.impulses = passages[k].impulses();
        result.impulses.unit = result.unit;
    }
    for (std::size_t k = 0; k < meters.size(); ++k)
        results[metered[k]].quality = meters[k].finish();
    return results;
}

std::size_t loudest(std::span<const SoundAnalysis> channels) {
    const auto square = [](const SoundAnalysis& channel) {
        const double reference = signal::reference_of(channel.unit);
        return signal::mean_square_between(channel.spectrum, lowest_heard, channel.rate) / (reference * reference);
    };
    const auto found = std::max_element(channels.begin(), channels.end(),
                                        [&](const auto& a, const auto& b) { return square(a) < square(b); });
    return static_cast<std::size_t>(found - channels.begin());
}

}  // namespace stridor::sound
