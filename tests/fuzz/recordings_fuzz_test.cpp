// Recordings whose samples are any double: refused with the place of the first that is no sample, or analysed, heard
// and compared, and then every figure is a number. Under sanitizers nothing that is computed leads outside the memory.

#include "stridor/analysis/friction/trace.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/classification/likeness.hpp"
#include "stridor/classification/recording_verdict.hpp"
#include "stridor/recordings/open_signal.hpp"
#include "stridor/signal/source.hpp"
#include "stridor/sound/analysis.hpp"
#include "stridor/sound/feature_table.hpp"
#include "stridor/sound/tracks.hpp"
#include "support/counter_random.hpp"
#include "support/effort.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace stridor {
namespace {

using signal::Signal;
using support::CounterRandom;

constexpr std::uint64_t usual_runs = support::effort<std::uint64_t>(1500, 300);
constexpr std::array<const char*, 6> units{"Pa", "FS", "m/s^2", "m/s", "N", "V"};

// --- samples

double any_double(CounterRandom& random) {
    return std::bit_cast<double>(random.next());
}

// of any size that a sample may have, mostly far from 1
double any_sample(CounterRandom& random) {
    const double size = std::exp2(random.between(-1080.0, 99.0));
    return random.one_in(2) ? -size : size;
}

double edge(CounterRandom& random) {
    constexpr double largest = signal::largest_sample;
    constexpr std::array values{0.0,   -0.0,   largest, -largest, 5e-324, 2.3e-308, 1e-162,
                                1e-81, -1e-81, 1.0,     -1.0,     1e15,   1e-30,    -1e29};
    return values[random.below(values.size())];
}

// what the samples of a stretch are drawn from
enum class Kind : std::uint8_t { sizes, edges, noise, tone, impulses, constant, steps, count };

void fill(std::vector<double>& samples, std::size_t from, std::size_t to, CounterRandom& random) {
    const auto kind = static_cast<Kind>(random.below(static_cast<std::size_t>(Kind::count)));
    const double size = random.one_in(3) ? 1.0 : std::abs(any_sample(random));
    const double cycle = random.between(2.0, 40.0);
    const std::size_t apart = 1 + random.below(400);
    double held = edge(random);
    for (std::size_t k = from; k < to; ++k) {
        const auto place = static_cast<double>(k);
        if (kind == Kind::steps && random.one_in(50)) held = any_sample(random);
        samples[k] = kind == Kind::sizes      ? any_sample(random)
                     : kind == Kind::edges    ? edge(random)
                     : kind == Kind::noise    ? size * random.between(-1.0, 1.0)
                     : kind == Kind::tone     ? size * std::sin(6.283185307179586 * place / cycle)
                     : kind == Kind::impulses ? (k % apart == 0 ? size : 0.0)
                     : kind == Kind::constant ? size
                                              : held;
    }
}

std::vector<double> samples_of(std::size_t count, CounterRandom& random) {
    std::vector<double> samples(count);
    for (std::size_t from = 0; from < count;) {
        const std::size_t to = random.one_in(2) ? count : std::min(count, from + 1 + random.below(count));
        fill(samples, from, to, random);
        from = to;
    }
    for (std::size_t k = random.below(4); k > 0 && count > 0; --k)
        samples[random.below(count)] = random.one_in(2) ? any_sample(random) : edge(random);
    return samples;
}

std::vector<Signal> any_recording(CounterRandom& random) {
    const double rate = std::floor(random.one_in(8) ? random.decades(1000.0, 2e5) : random.decades(1000.0, 8000.0));
    const auto count = static_cast<std::size_t>(random.decades(1.0, random.one_in(20) ? 20000.0 : 3000.0));
    std::vector<Signal> channels(random.one_in(4) ? 2 : 1);
    for (Signal& channel : channels)
        channel = {rate, units[random.below(units.size())], samples_of(count, random)};
    // one that is any double is most often none of a recording
    if (random.one_in(3))
        for (std::size_t k = 1 + random.below(4); k > 0; --k)
            channels[random.below(channels.size())].samples[random.below(count)] = any_double(random);
    if (random.one_in(50))
        for (double& x : channels.front().samples)
            x = any_double(random);
    return channels;
}

// --- files of them

std::string little_endian(std::uint64_t value, std::size_t bytes) {
    std::string text;
    for (std::size_t k = 0; k < bytes; ++k)
        text += static_cast<char>(value >> (8 * k) & 0xFFU);
    return text;
}

// 64 bit floating point
std::string wav_of(const std::vector<Signal>& channels) {
    const std::size_t width = channels.size();
    const auto rate = static_cast<std::uint64_t>(channels.front().rate);
    std::string data;
    for (std::size_t k = 0; k < channels.front().samples.size(); ++k)
        for (const Signal& channel : channels)
            data += little_endian(std::bit_cast<std::uint64_t>(channel.samples[k]), 8);
    const std::string format = little_endian(3, 2) + little_endian(width, 2) + little_endian(rate, 4) +
                               little_endian(rate * width * 8, 4) + little_endian(width * 8, 2) + little_endian(64, 2);
    const std::string body =
        "WAVEfmt " + little_endian(format.size(), 4) + format + "data" + little_endian(data.size(), 4) + data;
    return "RIFF" + little_endian(body.size(), 4) + body;
}

std::string csv_of(const std::vector<Signal>& channels) {
    std::string text = "# rate: " + base::shortest(channels.front().rate) + "\n";
    for (std::size_t c = 0; c < channels.size(); ++c)
        text += (c > 0 ? ",c" : "c") + std::to_string(c + 1) + " [" + channels[c].unit + "]";
    text += "\n";
    for (std::size_t k = 0; k < channels.front().samples.size(); ++k) {
        for (std::size_t c = 0; c < channels.size(); ++c)
            text += (c > 0 ? "," : "") + base::shortest(channels[c].samples[k]);
        text += "\n";
    }
    return text;
}

std::unique_ptr<signal::Source> opened(const std::vector<Signal>& channels, CounterRandom& random) {
    if (random.one_in(2)) return signal::source_of(channels);
    if (random.one_in(8)) return recordings::open_signal({recordings::bytes_of(csv_of(channels)), "f", {}});
    recordings::OpenOptions options;
    for (const Signal& channel : channels)
        options.full_scales.push_back({1.0, channel.unit});
    return recordings::open_signal({recordings::bytes_of(wav_of(channels)), "f", {}}, options);
}

// --- what must hold

// is this sample none in any channel? `number` counts from 1
bool is_none(const std::vector<Signal>& channels, std::size_t number) {
    return std::any_of(channels.begin(), channels.end(), [&](const Signal& channel) {
        return number >= 1 && number <= channel.samples.size() && !signal::is_sample(channel.samples[number - 1]);
    });
}

bool has_none(const std::vector<Signal>& channels) {
    for (std::size_t number = 1; number <= channels.front().samples.size(); ++number)
        if (is_none(channels, number)) return true;
    return false;
}

// what a table takes for marks of no value, whatever it would be as a sample (docs/formats/signals.md)
bool refuses_marks(const Error& error, const std::vector<Signal>& channels) {
    constexpr double least_mark = 1e15;
    const auto is_mark = [](double value) { return std::abs(value) >= least_mark; };
    const bool has_marks = std::any_of(channels.begin(), channels.end(), [&](const Signal& channel) {
        return std::any_of(channel.samples.begin(), channel.samples.end(), is_mark);
    });
    const std::string& why = error.problem().why;
    return has_marks && error.place() && why.find(" for no value, in ") != std::string::npos;
}

// a refusal names a sample that is none: "sample 29 is ...", or in a table its line
bool names_its_place(const Error& error, const std::vector<Signal>& channels) {
    const std::string& what = error.problem().what;
    std::size_t number = 0;
    constexpr std::string_view opening = "sample ";
    if (what.starts_with(opening))
        std::from_chars(what.data() + opening.size(), what.data() + what.size(), number);
    else if (error.place() && error.place()->line > 2)
        number = static_cast<std::size_t>(error.place()->line) - 2;  // behind the rate and the names
    return is_none(channels, number);
}

bool is_share(double value) {
    return value >= 0.0 && value <= 1.0 + 1e-9;
}

std::string complaint_of(const sound::SoundFeatures& f) {
    for (const sound::SoundFeature& feature : sound::feature_table) {
        const double value = f.*feature.member;
        const bool is_endless = std::isinf(value) && feature.name != "clearness";
        if (std::isnan(value) || is_endless) return std::string(feature.name) + " is " + base::shortest(value);
    }
    return std::isfinite(f.mean_square) && std::isfinite(f.peak) ? "" : "the stretch has no level";
}

std::string complaint_of(const sound::Passage& passage) {
    const sound::Onsets& o = passage.onsets;
    const sound::Tones& t = passage.tones;
    for (const double value :
         {o.rate, o.skewness, o.train, o.longest_train, o.joint_skewness, o.joint_train, o.beat, o.kurtosis,
          o.level_spread, o.sounding, t.mean_square, t.presence, t.length, t.wander, t.spacing, t.centre, t.spread})
        if (!std::isfinite(value)) return "a figure of a passage is " + base::shortest(value);
    return "";
}

std::string complaint_of(const sound::SoundQuality& q) {
    for (const double value : {q.loudness, q.greatest_loudness, q.loudness_5, q.loudness_10, q.sharpness})
        if (!std::isfinite(value)) return "the sound quality is " + base::shortest(value);
    return "";
}

std::string complaint_of(const sound::SoundAnalysis& channel) {
    if (!std::isfinite(channel.mean_square) || std::isnan(channel.level.greatest)) return "a channel has no level";
    for (const double value : channel.spectrum.density)
        if (!std::isfinite(value)) return "the spectrum is " + base::shortest(value);
    std::string text;
    for (const sound::SoundStretch& stretch : channel.stretches)
        if (text.empty()) text = complaint_of(stretch.features);
    for (const sound::Passage& passage : channel.passages)
        if (text.empty()) text = complaint_of(passage);
    if (text.empty() && channel.quality) text = complaint_of(*channel.quality);
    return text;
}

std::string complaint_of(const classification::RecordingVerdict& verdict) {
    if (!is_share(verdict.probability)) return "the probability is " + base::shortest(verdict.probability);
    for (const double share : verdict.shares)
        if (!is_share(share)) return "a share is " + base::shortest(share);
    for (const classification::SoundSegment& segment : verdict.segments)
        if (!std::isfinite(segment.mean_square) || !(segment.to >= segment.from)) return "a segment has no level";
    return "";
}

std::string complaint_of_hearing(const std::vector<sound::SoundAnalysis>& channels) {
    const parameters::SoundThresholds thresholds;
    if (sound::loudest(channels) >= channels.size()) return "no channel is the loudest";
    std::vector<classification::SoundProfile> profiles;
    for (const sound::SoundAnalysis& channel : channels) {
        const classification::RecordingVerdict verdict = classification::verdict_on(channel, thresholds);
        if (std::string text = complaint_of(verdict); !text.empty()) return text;
        profiles.push_back(classification::profile_of(channel.stretches, verdict, thresholds));
        (void)sound::pitch_track(channel, 3);
        (void)sound::onset_track(channel, 3);
    }
    const classification::Likeness likeness = classification::likeness(profiles.front(), profiles.back());
    return std::isfinite(likeness.distance) ? "" : "the distance is " + base::shortest(likeness.distance);
}

// the same samples as a friction force: figures, or a refusal
std::string complaint_of_friction(const std::vector<Signal>& channels) {
    try {
        const analysis::FrictionTrace trace = analysis::friction_trace(
            {channels.front().rate, channels.front().samples, {}, channels.back().samples, 20.0});
        return trace.all.moving_time >= 0.0 ? "" : "the moving time is none";
    } catch (const Error&) {
        return "";
    }
}

std::string complaint_of_run(CounterRandom& random) {
    const std::vector<Signal> channels = any_recording(random);
    const bool is_refused = has_none(channels);
    const auto field = random.one_in(2) ? sound::SoundField::free : sound::SoundField::diffuse;
    try {
        const auto source = opened(channels, random);
        const std::vector<sound::SoundAnalysis> found = sound::analyse(*source, {}, sound::one_after_the_other, field);
        // a table leaves out a channel that has one, beside another that has none
        const bool is_left_out =
            source->layout().channels.size() < channels.size() &&
            std::any_of(channels.begin(), channels.end(), [](const Signal& channel) { return !has_none({channel}); });
        if (is_refused && !is_left_out) return "a sample that is none is taken";
        for (const sound::SoundAnalysis& channel : found)
            if (std::string text = complaint_of(channel); !text.empty()) return text;
        if (std::string text = complaint_of_hearing(found); !text.empty()) return text;
    } catch (const Error& error) {
        const bool is_right = (is_refused && names_its_place(error, channels)) || refuses_marks(error, channels);
        return is_right ? "" : error.what();
    }
    return complaint_of_friction(channels);
}

TEST(RecordingsFuzz, OfAnyDoubleAreHeardOrRefusedWithTheirPlace) {
    const support::Runs runs = support::runs(usual_runs);
    for (std::uint64_t run = runs.first; run < runs.first + runs.count; ++run) {
        CounterRandom random(run);
        ASSERT_EQ(complaint_of_run(random), "") << "run " << run;
    }
}

}  // namespace
}  // namespace stridor
