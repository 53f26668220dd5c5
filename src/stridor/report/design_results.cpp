#include "stridor/report/design_results.hpp"

#include "stridor/base/error.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/hearing/heard_motion.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/parameters/temperature_table.hpp"
#include "stridor/pictures/many_contacts.hpp"
#include "stridor/recordings/audio/wav.hpp"
#include "stridor/sweep/evaluate.hpp"
#include "stridor/sweep/run.hpp"
#include "stridor/sweep/store/keeper.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace stridor::report {

namespace {

using parameters::Case;
using parameters::Direction;

constexpr double trace_samples = 5e4;    // [1] of the picture's trace
constexpr double normal_peak = 0.89125;  // [1] of full scale, where the largest sample of a sound lies: -1 dB

std::vector<Direction> directions_of(const Case& c) {
    if (!parameters::has_one_phase(c.drive)) return {Direction::going, Direction::coming};
    return {parameters::steady_direction(c.drive)};
}

// the stretches up to the longest time that is heard
std::vector<sound::Stretch> first_of(std::vector<sound::Stretch> stretches, double longest) {
    double left = longest;
    for (sound::Stretch& stretch : stretches) {
        stretch.to = std::min(stretch.to, stretch.from + std::max(0.0, left));
        left -= stretch.to - stretch.from;
    }
    std::erase_if(stretches, [](const sound::Stretch& stretch) { return !(stretch.to > stretch.from); });
    return stretches;
}

std::optional<DesignSound> sound_of(const Case& c, const sound::Pickup& pickup, Direction direction,
                                    const std::stop_token& stop) {
    constexpr double shortest = 0.05;  // [s] what is shorter is a click
    sound::AuralisationSettings settings;
    settings.pickup = pickup;
    settings.stretches = first_of(hearing::heard_stretches(c, direction), longest_sound);
    if (settings.stretches.empty()) return std::nullopt;
    integration::Workspace workspace;
    const std::optional<hearing::RunSound> run = hearing::sound_of_run(c, settings, stop, workspace);
    if (!run || run->parts.empty()) return std::nullopt;
    const signal::Signal sound = hearing::joined(run->parts);
    if (signal::duration(sound) < shortest) return std::nullopt;
    DesignSound result{direction, hearing::judged(run->parts, {}).verdict, {}};
    double peak = 0.0;
    for (const double sample : sound.samples)
        peak = std::max(peak, std::abs(sample));
    if (peak > hearing::least_motion) result.wav = recordings::wav_bytes(sound, {peak / normal_peak, sound.unit});
    return result;
}

integration::Motion motion_of(const Case& design, const std::stop_token& stop) {
    record::Request request{record::KeepHistory::yes, {}};
    if (!pictures::shows_many_contacts(design)) {
        request.trace.to = design.run.duration;
        request.trace.interval = design.run.duration / trace_samples;
    }
    integration::Workspace workspace;
    std::optional<sweep::Attempt> run = sweep::attempt(design, request, stop, workspace);
    if (!run)
        throw Error(ErrorKind::interrupted, {"stopped while simulating", "a report keeps nothing", "Run it again."});
    if (run->status != sweep::Status::done)
        throw Error(ErrorKind::numerical, {run->message, "this design has no motion to report on", ""});
    return std::move(run->motion);
}

}  // namespace

namespace {

// over the friction, or over the temperature that it follows
analysis::ScanRange telling_range(const Case& design) {
    constexpr std::string_view friction = "contact.kinetic_friction";
    const std::vector<double>& at = design.temperature.at;
    if (parameters::temperature_column(design, friction) != nullptr)
        return {"temperature.value", at.front(), at.back()};
    return {std::string(friction), 0.0, design.contact.static_friction};
}

}  // namespace

DesignResults basic_results(const Case& design, const std::stop_token& stop) {
    DesignResults results;
    results.design = design;
    results.motion = motion_of(design, stop);
    results.verdicts = classification::classify_phases(results.motion.record.phases, design.verdict);
    try {
        const hearing::HeardMotion heard = hearing::heard_motion(design, {}, results.motion.record.phases);
        results.heard = hearing::motion_words(heard);
        for (const Direction direction : directions_of(design))
            if (std::optional<DesignSound> sound = sound_of(design, heard.pickup, direction, stop))
                results.sounds.push_back(std::move(*sound));
    } catch (const Error& error) {
        // steps too long to be heard are no reason to go without the rest
        if (error.kind() != ErrorKind::input) throw;
        results.without_sound = error.problem().what + " (" + error.problem().why + ").";
    }
    results.stability = analysis::scan_stability(design, telling_range(design));
    return results;
}

sweep::SweepResult chart_in_memory(const sweep::Study& study, int threads, const std::stop_token& stop) {
    const auto keeper = std::make_shared<sweep::MemoryKeeper>(study);
    sweep::RunOptions options;
    options.crew = crew::thread_crews(threads);
    options.stop = stop;
    sweep::run(study, *keeper, options);
    return sweep::load(study, keeper);  // throws where it was stopped
}

}  // namespace stridor::report
