#include "stridor/io/sound/live_events.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/json.hpp"
#include "stridor/base/version.hpp"
#include "stridor/io/sound/verdict_object.hpp"
#include "stridor/signal/level.hpp"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <utility>

namespace stridor::io {

namespace {

using base::Json;

constexpr std::array<std::string_view, 3> take_ends{"gap", "full", "end"};

std::string event_line(const Json& event) {
    return event.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json live_opening(std::string_view event, double time, double begin) {
    return {{"event", event}, {"time", stamp_text(begin + time)}};
}

// one event stands in one line, whatever a document looks like by itself
Json classified_object(const SoundReport& report) {
    return base::foreign_document(classify_json(report));
}

}  // namespace

std::string stamp_text(double seconds) {
    using namespace std::chrono;
    const sys_time<milliseconds> time{milliseconds(std::llround(1000.0 * seconds))};
    const sys_days day = floor<days>(time);
    const year_month_day date{day};
    const hh_mm_ss clock{time - day};
    return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", static_cast<int>(date.year()),
                       static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()), clock.hours().count(),
                       clock.minutes().count(), clock.seconds().count(), clock.subseconds().count());
}

double seconds_of_stamp(const std::string& text) {
    using namespace std::chrono;
    int year = 0;
    unsigned month = 0;
    unsigned day = 0;
    unsigned hour = 0;
    unsigned minute = 0;
    double second = 0.0;
    int read = 0;
    const int fields =
        std::sscanf(text.c_str(), "%4d-%2u-%2uT%2u:%2u:%lfZ%n", &year, &month, &day, &hour, &minute, &second, &read);
    const year_month_day date{std::chrono::year(year), std::chrono::month(month), std::chrono::day(day)};
    const bool is_time = fields == 6 && static_cast<std::size_t>(read) == text.size() && date.ok() && hour < 24 &&
                         minute < 60 && second >= 0.0 && second < 61.0;
    if (!is_time)
        throw Error(ErrorKind::input,
                    {"\"" + text + "\" is no moment", "it is told in UTC", "Write it as 2026-11-27T15:42:25Z."});
    const auto days = static_cast<double>(sys_days(date).time_since_epoch().count());
    return 86400.0 * days + 3600.0 * hour + 60.0 * minute + second;
}

std::string_view take_end_name(hearing::TakeEnd why) {
    return take_ends[static_cast<std::size_t>(why)];
}

SoundReport report_of(hearing::LiveTake take, const LiveInput& input, const parameters::SoundThresholds& thresholds) {
    SoundReport report;
    report.file = input.name;
    report.format = input.format;
    report.thresholds = thresholds;
    report.channels = std::move(take.channels);
    report.verdicts = std::move(take.verdicts);
    report.loudest = sound::loudest(report.channels);
    return report;
}

std::string begin_event(const LiveInput& input, double begin) {
    Json event = live_opening("begin", 0.0, begin);
    event.update(Json{{"schema", "stridor.listen-in/1"},
                      {"version", base::version()},
                      {"commit", base::commit()},
                      {"source", input.name},
                      {"format", input.format},
                      {"rate", input.layout.rate}});
    event["channels"] = Json::array();
    for (const signal::Channel& channel : input.layout.channels)
        event["channels"].push_back(
            {{"name", channel.name}, {"unit", channel.unit}, {"level_unit", signal::level_unit(channel.unit)}});
    return event_line(event);
}

std::string passage_event(const hearing::LivePassage& passage, const LiveInput& input, double begin) {
    Json event = live_opening("passage", passage.from, begin);
    event.update(Json{{"from", passage.from},
                      {"to", passage.to},
                      {"channel", passage.channel + 1},
                      {"category", classification::name(passage.category())},
                      {"background", passage.is_background},
                      {"level", passage.level},
                      {"frequency", passage.frequency}});
    event["verdict"] =
        verdict_object(passage.verdict, signal::reference_of(input.layout.channels[passage.channel].unit));
    return event_line(event);
}

std::string noise_event(const hearing::LiveNoise& noise, const LiveInput& input, const KeptClip& kept, double begin) {
    const hearing::LivePassage& strongest = noise.strongest;
    Json event = live_opening("noise", noise.from, begin);
    event.update(Json{{"number", noise.number},
                      {"from", noise.from},
                      {"to", noise.to},
                      {"cut", noise.is_cut},
                      {"channel", strongest.channel + 1},
                      {"category", classification::name(strongest.category())},
                      {"probability", strongest.verdict.probability},
                      {"level", strongest.level},
                      {"level_unit", signal::level_unit(input.layout.channels[strongest.channel].unit)},
                      {"frequency", strongest.frequency}});
    const bool is_kept = !kept.file.empty() || kept.entry > 0;
    if (is_kept) event["clip"] = {{"from", noise.clip_from}, {"to", noise.clip_to}};
    if (!kept.file.empty()) event["clip"]["file"] = kept.file;
    if (kept.entry > 0) event["clip"]["entry"] = kept.entry;
    if (!kept.failure.empty()) event["not_kept"] = kept.failure;
    return event_line(event);
}

std::string gap_event(const LiveGap& gap, double begin) {
    Json event = live_opening("gap", gap.at, begin);
    event["at"] = gap.at;
    event["seconds"] = gap.seconds ? Json(*gap.seconds) : Json();
    event["why"] = gap.why;
    return event_line(event);
}

std::string take_event(const hearing::LiveTake& take, const SoundReport& report, double begin) {
    Json event = live_opening("take", take.from, begin);
    event.update(
        Json{{"number", take.number}, {"from", take.from}, {"to", take.to}, {"ended_by", take_end_name(take.why)}});
    event["classify"] = classified_object(report);
    return event_line(event);
}

std::string end_event(const LiveSum& sum, double begin) {
    Json event = live_opening("end", sum.heard, begin);
    event.update(
        Json{{"heard", sum.heard}, {"takes", sum.takes}, {"noises", sum.noises}, {"gaps", sum.gaps}, {"why", sum.why}});
    return event_line(event);
}

}  // namespace stridor::io
