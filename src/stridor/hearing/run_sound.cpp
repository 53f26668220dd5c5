#include "stridor/hearing/run_sound.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/classification/sound_rules.hpp"
#include "stridor/parameters/rules/check.hpp"
#include "stridor/parameters/rules/engines.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/sound/analysis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace stridor::hearing {

namespace {

using parameters::Case;
using parameters::Direction;
using record::Phase;
using signal::Signal;
using sound::AuralisationSettings;
using sound::Stretch;

constexpr double lead_in = 0.1;  // [s] before the sound begins, for the high pass at 20 Hz to forget its start

Phase phase_of(const Case& c, Direction direction) {
    if (parameters::has_one_phase(c.drive)) return Phase::all;
    return direction == Direction::going ? Phase::going : Phase::coming;
}

// the sound of a run from somewhat before its first stretch on
class SoundRecorder {
public:
    SoundRecorder(const Case& c, const AuralisationSettings& settings)
        : settings_(settings),
          auralisation_(whole(settings)),
          sound_{settings.rate, sound::unit_of(settings.pickup.quantity), {}} {
        request_.trace =
            auralisation_.request(c.run.duration, [this](std::span<const double> block) { append(block); });
        request_.trace.from = std::max(0.0, earliest(settings) - lead_in);
        request_.trace.to = sound::heard_until(settings, c.run.duration);
        request_.trace.taker = [this, taker = request_.trace.taker](const record::Trace& trace) {
            if (!has_begun_) begin_ = trace.time.front();
            has_begun_ = true;
            taker(trace);
        };
    }
    SoundRecorder(const SoundRecorder&) = delete;
    SoundRecorder& operator=(const SoundRecorder&) = delete;

    const record::Request& request() const { return request_; }

    /// After the run; shape [stretch].
    std::vector<Signal> parts() {
        append(auralisation_.finish());
        if (settings_.stretches.empty()) return {silenced(sound_)};
        std::vector<Signal> parts;
        for (const Stretch& stretch : settings_.stretches)
            parts.push_back(part(stretch));
        return parts;
    }

private:
    // the stretches are cut out afterwards: those of two directions may overlap
    static AuralisationSettings whole(AuralisationSettings settings) {
        settings.stretches.clear();
        return settings;
    }

    static double earliest(const AuralisationSettings& settings) {
        double from = settings.stretches.empty() ? 0.0 : settings.stretches.front().from;
        for (const Stretch& stretch : settings.stretches)
            from = std::min(from, stretch.from);
        return from;
    }

    static Signal silenced(Signal part) {
        if (sound::peak(part.samples) < least_motion) std::fill(part.samples.begin(), part.samples.end(), 0.0);
        return part;
    }

    void append(std::span<const double> block) {
        sound_.samples.insert(sound_.samples.end(), block.begin(), block.end());
    }

    double instant(std::size_t n) const { return begin_ + static_cast<double>(n) / sound_.rate; }

    // of the first sample that is not before this instant, as `sound::Auralisation` cuts
    std::size_t index(double time) const {
        std::size_t n = base::whole_below((time - begin_) * sound_.rate, sound_.samples.size());
        while (n > 0 && instant(n - 1) >= time)
            --n;
        while (n < sound_.samples.size() && instant(n) < time)
            ++n;
        return n;
    }

    Signal part(const Stretch& stretch) const {
        const std::size_t first = index(stretch.from);
        const auto at = [&](std::size_t n) { return sound_.samples.begin() + static_cast<std::ptrdiff_t>(n); };
        const std::size_t last = std::max(first, index(stretch.to));
        Signal part = silenced({sound_.rate, sound_.unit, {at(first), at(last)}});
        if (settings_.fade > 0.0)
            for (std::size_t n = 0; n < part.samples.size(); ++n)
                part.samples[n] *= sound::fade_gain(stretch, settings_.fade, instant(first + n));
        return part;
    }

    AuralisationSettings settings_;
    sound::Auralisation auralisation_;
    Signal sound_;
    record::Request request_;
    double begin_ = 0.0;  // [s] instant of the sound's first sample
    bool has_begun_ = false;
};

}  // namespace

std::vector<Stretch> heard_stretches(const Case& c, Direction direction) {
    if (!parameters::findings(c).empty()) return {};
    // of a constant drive what is judged: the start is no part of the verdict
    const record::Phase phase = phase_of(c, direction);
    const record::Use least = phase == record::Phase::all ? record::Use::judged : record::Use::counted;
    return sound::stretches_of(record::schedule(c), phase, least);
}

void check_audible(const Case& c, const AuralisationSettings& settings) {
    if (parameters::engine_of(c) == parameters::Engine::exact) return;
    // engines sample at their own steps
    const double wanted = 1.0 / (settings.rate * settings.density * c.run.step);
    const double interval = std::max(1.0, std::round(wanted)) * c.run.step;
    if (4.0 * interval * settings.rate <= 1.0) return;
    const double longest = std::floor(0.25e9 / settings.rate) / 1e9;  // whole nanoseconds
    throw Error(ErrorKind::input, {"run.step = " + base::shortest(c.run.step) + " s is too long for a sound of " +
                                       base::shortest(settings.rate) + " Hz",
                                   "at least four steps must fall on each of its samples",
                                   "Use at most " + base::shortest(longest) + " s, or run.engine = \"exact\"."});
}

std::optional<RunSound> sound_of_run(const Case& c, const AuralisationSettings& settings, const std::stop_token& stop,
                                     integration::Workspace& workspace) {
    if (parameters::findings(c).empty()) check_audible(c, settings);
    SoundRecorder recorder(c, settings);
    std::optional<sweep::Attempt> run = sweep::attempt(c, recorder.request(), stop, workspace);
    if (!run) return std::nullopt;
    RunSound sound{std::move(*run), {}};
    if (sound.attempt.status == sweep::Status::done) sound.parts = recorder.parts();
    return sound;
}

Signal sound_of_case(const Case& c, const AuralisationSettings& settings, const std::stop_token& stop) {
    integration::Workspace workspace;
    const std::optional<RunSound> sound = sound_of_run(c, settings, stop, workspace);
    if (!sound) throw Error(ErrorKind::interrupted, {"stopped", "half a sound is not kept", ""});
    if (sound->attempt.status != sweep::Status::done)
        throw Error(sound->attempt.status == sweep::Status::invalid ? ErrorKind::input : ErrorKind::numerical,
                    {"the motion cannot be heard", sound->attempt.message, ""});
    return joined(sound->parts);
}

Signal joined(std::span<const Signal> parts) {
    STRIDOR_EXPECT(!parts.empty());
    Signal whole = parts.front();
    for (const Signal& part : parts.subspan(1))
        whole.samples.insert(whole.samples.end(), part.samples.begin(), part.samples.end());
    return whole;
}

bool bears_verdict(const Case& c) {
    if (c.verdict.creeping == parameters::Creeping::judged) return true;
    for (std::size_t k = 0; k < parameters::contact_count(c); ++k)
        if (parameters::is_regularised(parameters::contact_of(c, k).friction)) return false;
    return true;
}

classification::RecordingVerdict borne(const Case& c, classification::RecordingVerdict verdict) {
    if (bears_verdict(c)) return verdict;
    classification::RecordingVerdict held;
    held.reasons = {
        "its friction is regularised: it creeps where it should stick, so its motion is none of a rubbing contact; "
        "verdict.creeping = \"judged\" judges it all the same"};
    return held;
}

HeardVerdict judged(const Case& c, std::span<const Signal> parts, const parameters::SoundThresholds& thresholds) {
    HeardVerdict heard;
    double from = 0.0;  // [s] one part after the other
    for (const Signal& part : parts) {
        sound::StretchFinder finder(part.rate);
        finder.push(part.samples);
        for (sound::SoundStretch& stretch : finder.finish()) {
            stretch.features.from += from;
            heard.stretches.push_back(std::move(stretch));
        }
        from += signal::duration(part);
    }
    heard.verdict = borne(c, classification::classify_recording(heard.stretches, thresholds));
    return heard;
}

std::optional<CellSound> sound_of_cell(const sweep::Study& study, std::size_t index, const CellListening& listening,
                                       const std::stop_token& stop, integration::Workspace& workspace) {
    const sweep::CellPlace place = sweep::place_of(study, index);
    const parameters::Case c = sweep::case_at(study, place);
    const parameters::Direction direction = study.directions[place.direction];
    const std::optional<HeardMotion> motion = heard_motion(c, listening.motion, stop, workspace);
    if (!motion) return std::nullopt;
    sound::AuralisationSettings settings = listening.sound;
    settings.pickup = motion->pickup;
    settings.stretches = heard_stretches(c, direction);
    const std::optional<RunSound> run = sound_of_run(c, settings, stop, workspace);
    if (!run) return std::nullopt;
    const sweep::Cell cell = sweep::cell_of(c, direction, run->attempt);
    CellSound sound{index, cell.status, cell.message, cell.category, classification::Category::undecided, {}};
    if (cell.status != sweep::Status::done) return sound;
    if (settings.stretches.empty()) {
        sound.status = sweep::Status::invalid;
        sound.message = "the drive never moves that way in the window";
        return sound;
    }
    const std::array<signal::Signal, 1> whole{joined(run->parts)};
    const HeardVerdict heard = judged(c, whole, listening.thresholds);
    sound.heard = heard.verdict.category;
    sound.profile = classification::profile_of(heard.stretches, heard.verdict, listening.thresholds);
    return sound;
}

}  // namespace stridor::hearing
