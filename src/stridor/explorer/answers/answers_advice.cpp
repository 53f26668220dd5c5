#include "stridor/advice/advice.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/escapes.hpp"
#include "stridor/explorer/answers/answers.hpp"
#include "stridor/io/advice/json_advice.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/report/design_report.hpp"
#include "stridor/report/report_chart.hpp"
#include "stridor/report/timed_parts.hpp"

#include <array>
#include <utility>

namespace stridor::explorer {

namespace {

constexpr std::size_t most_asked = 40;  // ranges or tolerances

const Json& list_in(const Json& body, const std::string& name) {
    static const Json none = Json::array();
    const auto found = body.find(name);
    if (found == body.end() || found->is_null()) return none;
    bool are_objects = found->is_array() && found->size() <= most_asked;
    for (const Json& item : *found)
        are_objects = are_objects && item.is_object();
    if (!are_objects) throw Error(ErrorKind::input, {"\"" + name + "\" must be a list of at most 40 objects", "", ""});
    return *found;
}

std::optional<double> optional_in(const Json& object, const std::string& name) {
    return object.contains(name) ? std::optional(number_in(object, name)) : std::nullopt;
}

advice::AdviceOptions options_in(const World& world, const Json& body, const std::stop_token& stop) {
    constexpr int most_samples = 16384;
    advice::AdviceOptions options;
    options.crew = crew::thread_crews(world.threads);
    options.stop = stop;
    for (const Json& range : list_in(body, "over"))
        options.over.push_back({text_in(range, "key"), optional_in(range, "from"), optional_in(range, "to")});
    for (const Json& tolerance : list_in(body, "tolerance"))
        options.tolerances.push_back({text_in(tolerance, "key"), optional_in(tolerance, "relative"),
                                      optional_in(tolerance, "absolute"), advice::Spread::uniform});
    const int samples = whole_in(body, "samples", 2048);
    if (samples < 1 || samples > most_samples)
        throw Error(ErrorKind::input, {"\"samples\" must be from 1 to " + std::to_string(most_samples), "", ""});
    options.chance.samples = static_cast<std::size_t>(samples);
    return options;
}

// what prints the same verdict
std::string command_of(const World& world, const Json& body) {
    const Preset& preset = preset_named(world, text_in(body, "preset"));
    std::string text = "stridor init " + base::shell_word(preset.name) + " | stridor simulate -";
    if (!preset.file.empty()) text = "stridor simulate FILE";
    for (const std::string& item : preset.overrides)
        text += " --set " + base::shell_word(item);
    for (const std::string& item : overrides_in(body))
        text += " --set " + base::shell_word(item);
    return text;
}

}  // namespace

Response advice(const World& world, const Json& body, const std::stop_token& stop) {
    return json(io::advice_json(advice::advise(case_in(world, body), options_in(world, body, stop))));
}

Response design(const World& world, const Json& body, const std::stop_token& stop) {
    const parameters::Case c = case_in(world, body);
    advice::AdviceOptions options;
    options.crew = crew::thread_crews(world.threads);
    options.stop = stop;
    const advice::Look look = flag_in(body, "around") ? advice::Look::around : advice::Look::here;
    Json document = Json::parse(io::standing_json(advice::standing_of(c, look, options)));
    document["ranges"] = ranges_object(c);
    return json(base::text_of(document));
}

Response report(const World& world, const Json& body, const std::stop_token& stop) {
    const advice::AdviceOptions options = options_in(world, body, stop);
    report::DesignResults results = report::basic_results(case_in(world, body), options);
    results.command = command_of(world, body);
    results.date = report::report_date();
    report::add_sounds(results, stop, report::longest_part);
    if (body.contains("chart")) {
        sweep::Study study = study_in(world, body);
        report::judge_alike(study, results.standing.space);
        sweep::RunOptions charting;
        charting.crew = options.crew;
        charting.stop = stop;
        report::add_chart(results, study, charting, report::longest_part);
    }
    report::add_advice(results, options, report::longest_part);
    Response response{200, "text/html; charset=utf-8", report::html(report::design_report(results))};
    response.headers = {{"Content-Disposition", "attachment; filename=\"stridor-report.html\""}};
    return response;
}

}  // namespace stridor::explorer
