#include "stridor/sound/analysis.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/signal/side_by_side.hpp"
#include "stridor/signal/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace stridor::sound {

namespace {

constexpr double spectrum_time = 0.085;  // [s] of the spectra
constexpr std::size_t most_extents = 4096;
constexpr std::size_t block_frames = 1U << 16U;  // from which it is told what stands still
// Samples that are read at a time: the longer the pieces of work, the shorter a processor waits at the end for others.
constexpr std::size_t most_read = 16 * block_frames;
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
        while (!samples.empty()) {
            const std::size_t count = std::min(stride_ - filled_, samples.size());
            current_ = joined(current_, extent_of(samples.first(count)));
            samples = samples.subspan(count);
            filled_ += count;
            if (filled_ == stride_) keep();
        }
    }

    Waveform waveform() const { return {static_cast<double>(stride_) / rate_, extents_}; }

    // [unit] the greatest magnitude of all samples so far
    double peak() const {
        const SampleExtent all = std::accumulate(extents_.begin(), extents_.end(), current_, joined);
        return std::max({0.0, all.high, -all.low});
    }

private:
    static SampleExtent joined(const SampleExtent& a, const SampleExtent& b) {
        return {std::min(a.low, b.low), std::max(a.high, b.high)};
    }

    void keep() {
        extents_.push_back(current_);
        current_ = {};
        filled_ = 0;
        if (extents_.size() < most_extents) return;
        for (std::size_t k = 0; 2 * k < most_extents; ++k)
            extents_[k] = joined(extents_[2 * k], extents_[2 * k + 1]);
        extents_.resize(most_extents / 2);
        stride_ *= 2;
    }

    double rate_;
    std::size_t stride_;
    std::size_t filled_ = 0;
    SampleExtent current_{};
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
};

ChannelOverview::ChannelOverview(double rate, signal::Channel channel)
    : state_(std::make_unique<State>(rate, std::move(channel))) {}
ChannelOverview::~ChannelOverview() = default;
ChannelOverview::ChannelOverview(ChannelOverview&&) noexcept = default;
ChannelOverview& ChannelOverview::operator=(ChannelOverview&&) noexcept = default;

signal::LevelMeter& ChannelOverview::meter() {
    return state_->meter;
}

void ChannelOverview::push(std::span<const double> samples) {
    State& s = *state_;
    s.count += samples.size();
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
    result.mean_square = s.count == 0 ? 0.0 : s.meter.squares() / static_cast<double>(s.count);
    result.peak = s.outline.peak();
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

// their memory stays for the next frames
void drop_frames(Channels& channels) {
    for (std::vector<double>& samples : channels)
        samples.clear();
}

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

// Parts frames into channels, of samples to compute with only. What stands still in the first block is taken away from
// all: its beginning would be heard as a blow, and its level as loudness.
class ChannelParter {
public:
    explicit ChannelParter(std::vector<signal::Channel> channels) : channels_(std::move(channels)) {}

    // adds them to those that a channel has
    void part(std::span<const double> frames, Channels& channels) {
        const std::size_t width = channels_.size();
        const std::size_t count = frames.size() / width;
        channels.resize(width);
        for (std::size_t channel = 0; channel < width; ++channel) {
            std::vector<double>& samples = channels[channel];
            const std::size_t before = samples.size();
            samples.resize(before + count);
            const auto here = std::span(samples).subspan(before);
            for (std::size_t frame = 0; frame < count; ++frame) {
                const double x = frames[frame * width + channel];
                if (!signal::is_sample(x)) refuse(x, channel, done_ + frame + 1);
                here[frame] = std::abs(x) < smallest_sample ? 0.0 : x;
            }
            if (count > 0) take_standing_part(here, channel);
        }
        done_ += count;
    }

    std::uint64_t done() const { return done_; }

private:
    void take_standing_part(std::span<double> samples, std::size_t channel) {
        if (done_ == 0) standing_.push_back(standing_part(samples));
        if (standing_[channel] == 0.0) return;
        for (double& x : samples)
            x -= standing_[channel];
    }

    [[noreturn]] void refuse(double x, std::size_t channel, std::uint64_t number) const {
        throw Error(ErrorKind::input, signal::sample_problem(x, channels_[channel], number));
    }

    std::vector<signal::Channel> channels_;
    std::vector<double> standing_{};  // [unit] shape [channel]
    std::uint64_t done_ = 0;
};

// a recording, some blocks at a time
class BlockReader {
public:
    explicit BlockReader(signal::Source& source)
        : source_(source),
          width_(source.layout().channels.size()),
          parter_(source.layout().channels),
          block_(block_frames * width_) {}

    // leaves no frame at the end
    void read(Channels& channels) {
        channels.resize(width_);
        drop_frames(channels);
        for (std::size_t read = 0; read < std::max(most_read, block_.size()) && !has_ended_; read += block_.size()) {
            const std::size_t count = source_.read(block_);
            has_ended_ = count == 0;
            parter_.part(std::span(block_).first(count * width_), channels);
        }
    }

private:
    signal::Source& source_;
    std::size_t width_;
    ChannelParter parter_;
    std::vector<double> block_;
    bool has_ended_ = false;
};

// all that is found in the channels of a recording; its pieces of work are independent, the dearest come first
class ChannelFindings {
public:
    ChannelFindings(const signal::ChannelLayout& layout, std::optional<SoundField> field)
        : width_(layout.channels.size()) {
        check(layout);
        for (const signal::Channel& channel : layout.channels) {
            finders_.emplace_back(layout.rate);
            overviews_.emplace_back(layout.rate, channel);
        }
        for (std::size_t channel = 0; channel < width_; ++channel) {
            if (is_heard_through_air(layout.channels[channel])) {
                passages_.emplace_back(layout.rate);
                heard_.push_back(channel);
            }
            if (field && layout.channels[channel].unit == "Pa") {
                meters_.emplace_back(layout.rate, *field);
                metered_.push_back(channel);
            }
        }
    }

    std::size_t pieces() const { return 2 * width_ + passages_.size() + meters_.size(); }

    // What waits for itself, of each channel: it comes before `push`.
    void part(std::size_t channel, std::span<const double> samples) {
        PartSquares& stretches = finders_[channel].parts();
        signal::LevelMeter& meter = overviews_[channel].meter();
        if (const std::size_t place = place_of(channel); place < passages_.size())
            signal::push_side_by_side(samples, stretches, meter, passages_[place].parts());
        else
            signal::push_side_by_side(samples, stretches, meter);
    }

    void push(std::size_t piece, const Channels& channels) {
        const std::size_t metered = passages_.size() + meters_.size();
        if (piece < passages_.size())
            passages_[piece].push_parted(channels[heard_[piece]]);
        else if (piece < metered)
            meters_[piece - passages_.size()].push(channels[metered_[piece - passages_.size()]]);
        else if (piece < metered + width_)
            finders_[piece - metered].push_parted(channels[piece - metered]);
        else
            overviews_[piece - metered - width_].push(channels[piece - metered - width_]);
    }

    std::span<const Passage> passages(std::size_t channel) const {
        const std::size_t place = place_of(channel);
        if (place == passages_.size()) return {};
        return passages_[place].found();
    }

    std::span<const SoundStretch> stretches(std::size_t channel) const { return finders_[channel].found(); }

    std::vector<SoundAnalysis> finish() {
        std::vector<SoundAnalysis> results;
        for (std::size_t channel = 0; channel < width_; ++channel) {
            results.push_back(overviews_[channel].finish());
            results.back().stretches = finders_[channel].finish();
        }
        for (std::size_t k = 0; k < passages_.size(); ++k) {
            SoundAnalysis& result = results[heard_[k]];
            result.passages = passages_[k].finish();
            result.impulses = passages_[k].impulses();
            result.impulses.unit = result.unit;
        }
        for (std::size_t k = 0; k < meters_.size(); ++k)
            results[metered_[k]].quality = meters_[k].finish();
        return results;
    }

private:
    // among those heard through air; their number if it is none of them
    std::size_t place_of(std::size_t channel) const {
        return static_cast<std::size_t>(std::find(heard_.begin(), heard_.end(), channel) - heard_.begin());
    }

    std::size_t width_;
    std::vector<StretchFinder> finders_{};
    std::vector<ChannelOverview> overviews_{};
    std::vector<PassageFinder> passages_{};
    std::vector<std::size_t> heard_{};  // their channels
    std::vector<SoundQualityMeter> meters_{};
    std::vector<std::size_t> metered_{};  // likewise
};

Error no_samples() {
    return {ErrorKind::input, {"the recording holds no samples", "there is nothing to analyse", ""}};
}

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
    ChannelFindings findings(source.layout(), field);
    BlockReader reader(source);
    Channels here;
    Channels next;
    std::uint64_t done = 0;
    reader.read(here);
    if (here.front().empty()) throw no_samples();
    while (!here.front().empty()) {
        // the next ones are read beside the work
        const std::size_t pieces = findings.pieces();
        run(here.size(), [&](std::size_t channel) { findings.part(channel, here[channel]); });
        run(pieces + 1, [&](std::size_t piece) {
            if (piece < pieces)
                findings.push(piece, here);
            else
                reader.read(next);
        });
        done += here.front().size();
        if (progress) progress(done);
        std::swap(here, next);
    }
    return findings.finish();
}

struct SoundListener::State {
    explicit State(const signal::ChannelLayout& layout)
        : width(layout.channels.size()),
          findings(layout, {}),
          parter(layout.channels) {}

    void hear(std::span<const double> frames) {
        drop_frames(channels);
        parter.part(frames, channels);
        for (std::size_t channel = 0; channel < width; ++channel)
            findings.part(channel, channels[channel]);
        for (std::size_t piece = 0; piece < findings.pieces(); ++piece)
            findings.push(piece, channels);
    }

    // the first block, as `analyse` reads it
    void hear_first() {
        const std::vector<double> frames = std::exchange(first, {});
        hear(frames);
    }

    std::size_t width;
    ChannelFindings findings;
    ChannelParter parter;
    std::vector<double> first{};  // shape [frame][channel]
    Channels channels{};
};

SoundListener::SoundListener(const signal::ChannelLayout& layout) : state_(std::make_unique<State>(layout)) {}
SoundListener::~SoundListener() = default;
SoundListener::SoundListener(SoundListener&&) noexcept = default;
SoundListener& SoundListener::operator=(SoundListener&&) noexcept = default;

void SoundListener::push(std::span<const double> frames) {
    State& s = *state_;
    if (s.parter.done() == 0) {
        const std::size_t taken = std::min(frames.size(), block_frames * s.width - s.first.size());
        s.first.insert(s.first.end(), frames.begin(), frames.begin() + static_cast<std::ptrdiff_t>(taken));
        frames = frames.subspan(taken);
        if (s.first.size() < block_frames * s.width) return;
        s.hear_first();
    }
    if (!frames.empty()) s.hear(frames);
}

std::span<const Passage> SoundListener::passages(std::size_t channel) const {
    return state_->findings.passages(channel);
}

std::span<const SoundStretch> SoundListener::stretches(std::size_t channel) const {
    return state_->findings.stretches(channel);
}

std::vector<SoundAnalysis> SoundListener::finish() {
    State& s = *state_;
    if (!s.first.empty()) s.hear_first();
    if (s.parter.done() == 0) throw no_samples();
    return s.findings.finish();
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
