#include "stridor/report/design_results.hpp"

#include "stridor/base/escapes.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/hearing/heard_motion.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/io/chart/range_text.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/tables/material_pair.hpp"
#include "stridor/parameters/tables/temperature_table.hpp"
#include "stridor/pictures/many_contacts.hpp"
#include "stridor/recordings/audio/wav.hpp"
#include "stridor/report/timed_parts.hpp"
#include "stridor/sweep/evaluate.hpp"
#include "stridor/sweep/ready_charts.hpp"
#include "stridor/sweep/store/keeper.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <utility>

namespace stridor::report {

namespace {

using parameters::Case;
using parameters::Direction;

constexpr double trace_samples = 5e4;    // [1] of the picture's trace
constexpr double normal_peak = 0.89125;  // [1] of full scale, where the largest sample of a sound lies: -1 dB

std::vector<Direction> directions_of(const DesignMotion& motion) {
    if (parameters::has_one_phase(motion.of.drive)) return {parameters::steady_direction(motion.of.drive)};
    std::vector<Direction> directions;
    for (const record::Phase phase : motion.phases)
        directions.push_back(phase == record::Phase::going ? Direction::going : Direction::coming);
    return directions;
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
    if (!run)
        throw Error(ErrorKind::interrupted, {"stopped while listening", "a report keeps nothing", "Run it again."});
    if (run->parts.empty()) return std::nullopt;
    const signal::Signal sound = hearing::joined(run->parts);
    if (signal::duration(sound) < shortest) return std::nullopt;
    DesignSound result{direction, hearing::judged(c, run->parts, {}).verdict, {}};
    double peak = 0.0;
    for (const double sample : sound.samples)
        peak = std::max(peak, std::abs(sample));
    if (peak > hearing::least_motion) result.wav = recordings::wav_bytes(sound, {peak / normal_peak, sound.unit});
    return result;
}

// the run of a design that a phase has its verdict from
advice::DesignRun run_of(const advice::DesignStanding& design, std::size_t phase) {
    advice::DesignRun run{{}, design.present.starts[phase]};
    if (design.space.base.drive.kind == parameters::DriveKind::constant)
        run.direction = design.space.phases[phase] == record::Phase::going ? Direction::going : Direction::coming;
    return run;
}

// the motions from which the phases of a design that have a result have their verdicts
std::vector<DesignMotion> motions_of(const advice::DesignStanding& design) {
    std::vector<DesignMotion> motions;
    std::vector<advice::DesignRun> runs;
    for (std::size_t k = 0; k < design.space.phases.size(); ++k) {
        if (design.present.phases[k].status != sweep::Status::done) continue;
        const advice::DesignRun run = run_of(design, k);
        const auto same = std::find_if(runs.begin(), runs.end(), [&](const advice::DesignRun& other) {
            return other.direction == run.direction && other.start == run.start;
        });
        if (same == runs.end()) {
            runs.push_back(run);
            motions.push_back({advice::case_of(design.space.base, run), {design.space.phases[k]}, {}});
        } else {
            motions[static_cast<std::size_t>(same - runs.begin())].phases.push_back(design.space.phases[k]);
        }
    }
    return motions;
}

// the verdict of a phase of the design, from its motion
classification::Verdict verdict_in(const DesignMotion& motion, record::Phase phase) {
    const auto& tallies = motion.motion.record.phases;
    const auto found = std::find_if(tallies.begin(), tallies.end(), [&](const record::Tally& tally) {
        return tally.phase == phase || tally.phase == record::Phase::all;
    });
    classification::Verdict verdict =
        found == tallies.end()
            ? classification::Verdict{}
            : classification::classify_phase(*found, motion.of.verdict, classification::contact_names(motion.of));
    verdict.evidence.phase = phase;
    return verdict;
}

// of each phase of the design; of one without a result, why
std::vector<classification::Verdict> verdicts_of(const DesignResults& results) {
    std::vector<classification::Verdict> verdicts;
    for (const record::Phase phase : results.standing.space.phases) {
        classification::Verdict verdict;
        verdict.evidence.phase = phase;
        verdict.reasons = {results.standing.present.message};
        for (const DesignMotion& motion : results.motions)
            if (std::find(motion.phases.begin(), motion.phases.end(), phase) != motion.phases.end())
                verdict = verdict_in(motion, phase);
        verdicts.push_back(std::move(verdict));
    }
    return verdicts;
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

bool has_chart_axes(const io::TomlSource& source) {
    const io::TomlDocument document = io::parse_toml(source);
    return document.find("chart.x.parameter") != nullptr && document.find("chart.y.parameter") != nullptr;
}

// what a file does not say
io::AxisTexts usual_axes(const parameters::Case& c, int points) {
    const auto [x, y] = sweep::usual_axes(c, points);
    return {io::write_axis_text(x), io::write_axis_text(y)};
}

// over the friction, or over the temperature that it follows; of a table, which is no number, over what a chart has
analysis::ScanRange telling_range(const Case& design) {
    constexpr std::string_view friction = "contact.kinetic_friction";
    const std::vector<double>& at = design.temperature.at;
    if (parameters::temperature_column(design, friction) != nullptr)
        return {"temperature.value", at.front(), at.back()};
    if (!parameters::belongs(design, friction) || parameters::follows_table(design, friction)) {
        const sweep::Axis x = sweep::usual_axes(design, 2).first;
        return {x.parameter, x.from, x.to};
    }
    return {std::string(friction), 0.0, design.contact().static_friction};
}

}  // namespace

DesignResults basic_results(const Case& design, const advice::AdviceOptions& options) {
    DesignResults results;
    results.design = design;
    results.standing = advice::standing_of(design, advice::Look::here, options);
    results.motions = motions_of(results.standing);
    if (results.motions.empty())
        throw Error(ErrorKind::numerical,
                    {results.standing.present.message, "this design has no motion to report on", ""});
    for (DesignMotion& motion : results.motions)
        motion.motion = motion_of(motion.of, options.stop);
    results.verdicts = verdicts_of(results);
    try {
        results.stability = analysis::scan_stability(design, telling_range(design));
    } catch (const Error& error) {
        results.without_stability = reason_of(error);
    }
    return results;
}

void add_sounds(DesignResults& results, const std::stop_token& asked, PartTime longest) {
    std::vector<DesignSound> sounds;
    const auto listen = [&](const std::stop_token& stop) {
        for (const DesignMotion& motion : results.motions) {
            const hearing::HeardMotion heard = hearing::heard_motion(motion.of, {}, motion.motion.record.phases);
            if (results.heard.empty()) results.heard = hearing::motion_words(heard);
            for (const Direction direction : directions_of(motion))
                if (std::optional<DesignSound> sound = sound_of(motion.of, heard.pickup, direction, stop))
                    sounds.push_back(std::move(*sound));
        }
    };
    try {
        if (!ends_within(longest, asked, listen))
            results.without_sound = fmt::format(
                "The sounds were not made within {:g} s and are left out; `stridor "
                "listen` takes its time.",
                longest.count());
        else
            results.sounds = std::move(sounds);
    } catch (const Error& error) {
        // steps too long to be heard are no reason to go without the rest
        results.without_sound = reason_of(error);
    }
}

std::string reason_of(const Error& error) {
    if (error.kind() != ErrorKind::input && error.kind() != ErrorKind::numerical) throw error;
    const auto& problem = error.problem();
    std::string words = problem.what + (problem.why.empty() ? "" : " (" + problem.why + ")") + ".";
    // the key of a field keeps its letters
    if (words.substr(0, words.find(' ')).find('.') == std::string::npos)
        words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
    return words;
}

std::string headline(const DesignResults& results) {
    return results.advice ? advice::headline(*results.advice) : advice::headline(results.standing);
}

sweep::SweepResult chart_in_memory(const sweep::Study& study, const sweep::RunOptions& options) {
    const auto keeper = std::make_shared<sweep::MemoryKeeper>(study);
    if (sweep::run(study, *keeper, options).ending == sweep::SweepEnding::stopped)
        throw Error(ErrorKind::interrupted, {"stopped while charting", "a report keeps nothing", "Run it again."});
    return sweep::load(study, keeper);
}

std::string report_date() {
    std::time_t now = std::time(nullptr);
    std::tm day{};
    if (const char* told = std::getenv("SOURCE_DATE_EPOCH"); told != nullptr) {
        const std::string_view text(told);
        const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), now);
        if (failure != std::errc() || end != text.data() + text.size() || ::gmtime_r(&now, &day) == nullptr)
            throw Error(ErrorKind::input, {"SOURCE_DATE_EPOCH = " + base::visible(text) + " is no time",
                                           "it is a number of seconds since 1970", "Unset it, or give one."});
    } else {
        ::localtime_r(&now, &day);
    }
    return fmt::format("{:04}-{:02}-{:02}", day.tm_year + 1900, day.tm_mon + 1, day.tm_mday);
}

sweep::Study chart_to_report(const io::TomlSource& source, const parameters::Case& c, io::AxisTexts axes, int points,
                             const advice::AskedRuns& runs) {
    if (axes.x.empty() && axes.y.empty() && !has_chart_axes(source)) axes = usual_axes(c, points);
    sweep::Study study = io::read_study(source, axes);
    if (sweep::has_one_axis(study))
        throw Error(ErrorKind::input, {"the chart of a report has two axes", "--x was given without --y",
                                       "Add --y, such as --y mu_d=0.2:0.8."});
    for (sweep::Axis* axis : {&study.x, &study.y})
        axis->points = std::min(axis->points, points);
    study.quantities = {"category"};
    study.refine = 0;
    judge_alike(study, advice::design_space(c, {}, runs));
    return study;
}

void judge_alike(sweep::Study& study, const advice::DesignSpace& space) {
    study.starts = advice::starts_of(space);
    if (!parameters::has_one_phase(space.base.drive) || space.runs.front().direction) {
        study.directions.clear();
        for (const record::Phase phase : space.phases)
            study.directions.push_back(phase == record::Phase::going ? parameters::Direction::going
                                                                     : parameters::Direction::coming);
    }
}

}  // namespace stridor::report
