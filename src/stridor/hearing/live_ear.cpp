#include "stridor/hearing/live_ear.hpp"

#include "stridor/base/decibels.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/signal/level.hpp"

#include <algorithm>
#include <cmath>

namespace stridor::hearing {

namespace {

using classification::Category;
using sound::SoundAnalysis;
using sound::SoundStretch;

constexpr double hop_time = 0.1;        // [s]
constexpr double lead_time = 2.0;       // [s] that a clip begins before its noise
constexpr double pause_time = 2.0;      // [s] of one noise
constexpr double tail_time = 0.5;       // [s] that a clip goes on behind its noise
constexpr double settling_time = 10.0;  // [s] after which a passage is told at the latest
constexpr double motion_window = 3.0;   // [s] of a motion, which has no passages
constexpr double watched = 60.0;        // [s]
constexpr double guessed = 3.0;         // [s] as long as most passages
constexpr double least_guessed = 0.5;   // [s]

bool is_noise(Category category) {
    return category == Category::squeal || category == Category::squeak || category == Category::creak;
}

double middle_of(const SoundStretch& stretch) {
    return stretch.features.from + 0.5 * stretch.features.duration;
}

double mean_square_of(std::span<const SoundStretch> stretches) {
    double energy = 0.0;
    double duration = 0.0;
    for (const SoundStretch& stretch : stretches) {
        energy += sound::energy(stretch.features);
        duration += stretch.features.duration;
    }
    return duration > 0.0 ? energy / duration : 0.0;
}

// those whose middle lies in a part of the take
std::vector<SoundStretch> between(std::span<const SoundStretch> stretches, double from, double to) {
    std::vector<SoundStretch> part;
    const auto first = std::partition_point(stretches.begin(), stretches.end(),
                                            [&](const SoundStretch& stretch) { return middle_of(stretch) < from; });
    for (auto each = first; each != stretches.end() && middle_of(*each) < to; ++each)
        part.push_back(*each);
    return part;
}

std::size_t frames_in(double seconds, double rate) {
    return std::max<std::size_t>(1, static_cast<std::size_t>(seconds * rate));
}

}  // namespace

Category LivePassage::category() const {
    return is_background ? Category::none : verdict.category;
}

LiveEar::LiveEar(signal::ChannelLayout layout, const LiveEarOptions& options, LiveListener listener)
    : layout_(std::move(layout)),
      options_(options),
      listener_(std::move(listener)),
      hop_(frames_in(hop_time, layout_.rate)),
      courses_(layout_.channels.size()),
      ring_(layout_.channels.size(), frames_in(options.longest_clip + lead_time + 2.0 * settling_time, layout_.rate)) {
    // what cannot be heard is told at once
    analysis_.emplace(layout_);
}

void LiveEar::push(std::span<const double> frames) {
    const std::size_t whole = hop_ * layout_.channels.size();
    while (!frames.empty()) {
        const std::size_t taken = std::min(frames.size(), whole - pending_.size());
        pending_.insert(pending_.end(), frames.begin(), frames.begin() + static_cast<std::ptrdiff_t>(taken));
        frames = frames.subspan(taken);
        if (pending_.size() < whole) return;
        const std::vector<double> hop = std::exchange(pending_, {});
        hear(hop);
    }
}

void LiveEar::hear(std::span<const double> frames) {
    const std::size_t width = layout_.channels.size();
    for (std::size_t k = 0; k < frames.size(); ++k)
        if (!signal::is_sample(frames[k]))
            throw Error(ErrorKind::input,
                        signal::sample_problem(frames[k], layout_.channels[k % width], heard_ + k / width + 1));
    if (!analysis_) analysis_.emplace(layout_);
    if (told_.empty()) told_.resize(width);
    analysis_->push(frames);
    ring_.push(frames);
    heard_ += frames.size() / width;
    watch(frames);
    tell_new_passages();
    const double now = seconds_of(heard_);
    if (noise_ && now >= noise_->to + settling_time) end_noise();
    if (seconds_of(heard_ - take_begin_) >= options_.longest_take) end_take(TakeEnd::full);
}

void LiveEar::watch(std::span<const double> frames) {
    const std::size_t width = layout_.channels.size();
    const double share = 1.0 - base::exponential(-1.0 / (signal::fast * layout_.rate));
    const auto second = static_cast<std::uint64_t>(seconds_of(heard_));
    const bool is_new = second != second_;
    second_ = second;
    for (std::size_t channel = 0; channel < width; ++channel) {
        LiveCourse& course = courses_[channel];
        if (is_new || course.seconds.empty()) {
            course.seconds.push_back(0.0);
            course.categories.push_back(Category::none);
            if (static_cast<double>(course.seconds.size()) > watched) {
                course.seconds.pop_front();
                course.categories.pop_front();
            }
        }
        for (std::size_t k = channel; k < frames.size(); k += width) {
            course.now += share * (frames[k] * frames[k] - course.now);
            course.seconds.back() = std::max(course.seconds.back(), course.now);
        }
    }
}

void LiveEar::tell_new_passages() {
    for (std::size_t channel = 0; channel < layout_.channels.size(); ++channel) {
        const std::span<const SoundStretch> stretches = analysis_->stretches(channel);
        if (sound::is_heard_through_air(layout_.channels[channel]))
            tell_passages(channel, analysis_->passages(channel), stretches);
        else
            tell_stretches(channel, stretches, false);
    }
}

void LiveEar::tell_rest(const SoundAnalysis& analysis, std::size_t channel) {
    if (sound::is_heard_through_air(layout_.channels[channel]))
        tell_passages(channel, analysis.passages, analysis.stretches);
    else
        tell_stretches(channel, analysis.stretches, true);
}

void LiveEar::tell_passages(std::size_t channel, std::span<const sound::Passage> passages,
                            std::span<const SoundStretch> stretches) {
    for (std::size_t& told = told_[channel].passages; told < passages.size();) {
        const sound::Passage& passage = passages[told++];
        SoundAnalysis part;
        const double to = passage.from + passage.duration;
        part.passages = {passage};
        part.stretches = between(stretches, passage.from, to);
        tell(channel, std::move(part), passage.from, to);
    }
}

void LiveEar::tell_stretches(std::size_t channel, std::span<const SoundStretch> stretches, bool is_over) {
    std::size_t& told = told_[channel].stretches;
    while (told < stretches.size()) {
        const double from = motion_window * std::floor(middle_of(stretches[told]) / motion_window);
        const double to = from + motion_window;
        if (!is_over && middle_of(stretches.back()) < to) return;
        SoundAnalysis part;
        part.stretches = between(stretches, from, to);
        told += part.stretches.size();
        const sound::SoundFeatures& last = part.stretches.back().features;
        tell(channel, std::move(part), from, std::min(to, last.from + last.duration));
    }
}

void LiveEar::tell(std::size_t channel, SoundAnalysis part, double from, double to) {
    part.name = layout_.channels[channel].name;
    part.unit = layout_.channels[channel].unit;
    part.rate = layout_.rate;
    part.duration = to - from;
    const double mean_square = mean_square_of(part.stretches);
    LivePassage passage;
    passage.channel = channel;
    passage.from = take_from() + from;
    passage.to = take_from() + to;
    passage.level = signal::level_of(mean_square, signal::reference_of(part.unit));
    passage.verdict = classification::verdict_on(part, options_.thresholds);
    if (const classification::SoundSegment* loudest = passage.verdict.loudest())
        passage.frequency = loudest->verdict.features.frequency;
    // what is loud now decides what is background now; the take's verdict looks at all of it
    const double power =
        passage.verdict.passages.empty() ? mean_square : passage.verdict.passages.front().energy / (to - from);
    std::deque<std::pair<double, double>>& loud = told_[channel].loud;
    while (!loud.empty() && loud.front().first < passage.from - watched)
        loud.pop_front();
    passage.is_background = is_background(channel, power);
    loud.emplace_back(passage.to, power);
    listener_.passage(passage);
    if (is_noise(passage.category())) take_noise(passage);
}

bool LiveEar::is_background(std::size_t channel, double power) const {
    const double depth = base::power_of_decibels(-options_.thresholds.quiet_depth);
    const auto& loud = told_[channel].loud;
    return std::any_of(loud.begin(), loud.end(), [&](const auto& each) { return !(power > depth * each.second); });
}

void LiveEar::guess() {
    for (LiveCourse& course : courses_)
        course.guess = {};
    const std::uint64_t from =
        std::max(take_begin_, heard_ - std::min<std::uint64_t>(heard_, frames_in(guessed, layout_.rate)));
    if (heard_ - from < frames_in(least_guessed, layout_.rate)) return;
    const std::unique_ptr<signal::Source> last = ring_.part(layout_, from, heard_);
    const std::vector<SoundAnalysis> channels = sound::analyse(*last);
    for (std::size_t channel = 0; channel < channels.size(); ++channel) {
        const classification::RecordingVerdict verdict =
            classification::verdict_on(channels[channel], options_.thresholds);
        double power = verdict.passages.empty() ? mean_square_of(channels[channel].stretches) : 0.0;
        for (const classification::HeardPassage& passage : verdict.passages)
            power = std::max(power, passage.energy / (passage.to - passage.from));
        if (!is_background(channel, power)) courses_[channel].guess = {verdict.category, verdict.probability};
    }
}

void LiveEar::take_noise(const LivePassage& passage) {
    LiveCourse& course = courses_[passage.channel];
    const double first = static_cast<double>(second_ + 1) - static_cast<double>(course.seconds.size());
    for (std::size_t k = 0; k < course.categories.size(); ++k) {
        const double second = first + static_cast<double>(k);
        if (second + 1.0 > passage.from && second < passage.to) course.categories[k] = passage.category();
    }
    if (noise_ && passage.from > noise_->to + pause_time) end_noise();
    const double clip_from = std::max({take_from(), passage.from - lead_time, cut_at_});
    if (!noise_) noise_ = LiveNoise{++noises_, passage.from, passage.to, false, passage, clip_from, 0.0};
    noise_->from = std::min(noise_->from, passage.from);
    noise_->clip_from = std::min(noise_->clip_from, clip_from);
    noise_->to = std::max(noise_->to, passage.to);
    const bool is_of_one_unit =
        layout_.channels[passage.channel].unit == layout_.channels[noise_->strongest.channel].unit;
    if (is_of_one_unit && passage.level > noise_->strongest.level) noise_->strongest = passage;
    if (noise_->to - noise_->from < options_.longest_clip) return;
    noise_->is_cut = true;
    cut_at_ = noise_->to;
    end_noise();
}

void LiveEar::end_noise() {
    LiveNoise noise = *std::exchange(noise_, std::nullopt);
    const auto frame_at = [&](double time) {
        return std::clamp(static_cast<std::uint64_t>(std::llround(std::max(0.0, time) * layout_.rate)), ring_.begin(),
                          ring_.end());
    };
    const std::uint64_t from = std::max(take_begin_, frame_at(noise.clip_from));
    const std::uint64_t to = std::max(from, frame_at(noise.is_cut ? noise.to : noise.to + tail_time));
    noise.clip_from = seconds_of(from);
    noise.clip_to = seconds_of(to);
    const std::unique_ptr<signal::Source> clip = ring_.part(layout_, from, to);
    listener_.noise(noise, *clip);
}

void LiveEar::end_take(TakeEnd why) {
    if (!pending_.empty()) {
        const std::vector<double> rest = std::exchange(pending_, {});
        hear(rest);
    }
    if (heard_ == take_begin_) return;  // nothing came since the last one
    LiveTake take;
    take.number = ++takes_;
    take.why = why;
    take.from = take_from();
    take.to = seconds_of(heard_);
    take.channels = analysis_->finish();
    for (std::size_t channel = 0; channel < take.channels.size(); ++channel) {
        tell_rest(take.channels[channel], channel);
        take.verdicts.push_back(classification::verdict_on(take.channels[channel], options_.thresholds));
    }
    if (noise_) end_noise();
    analysis_.reset();
    told_.clear();
    take_begin_ = heard_;
    listener_.take(take);
}

}  // namespace stridor::hearing
