#include "stridor/base/escapes.hpp"
#include "stridor/explorer/answers/answers.hpp"
#include "stridor/explorer/answers/asked_advice.hpp"
#include "stridor/report/design_report.hpp"
#include "stridor/report/design_results.hpp"
#include "stridor/report/timed_parts.hpp"

#include <string>
#include <utility>

namespace stridor::explorer {

namespace {

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

Response report(const World& world, const Json& body, const std::stop_token& stop) {
    const advice::AdviceOptions options = advice_options_in(world, body, stop);
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
