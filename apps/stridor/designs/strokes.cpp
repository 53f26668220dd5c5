#include "stridor/sweep/strokes.hpp"

#include "arguments.hpp"
#include "commands.hpp"
#include "interrupt.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/console/progress.hpp"
#include "stridor/console/results/stroke_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/simulation/stroke_texts.hpp"
#include "stridor/pictures/picture_files.hpp"
#include "stridor/pictures/strokes.hpp"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <memory>
#include <string>

namespace stridor::app {

namespace {

struct StrokesOptions {
    CaseOptions input;
    std::int64_t strokes = 0;
    std::string duration;
    std::string pause;
    std::string resistance;
    std::string thermal_time;
    std::string wear;
    std::string area;
    std::string interference;
    double finer = 1.0;  // [1]
    std::string figure;
    std::string csv;
    pictures::Sheet sheet;
    bool json = false;
};

double value_of(const char* option, const std::string& text, const char* unit) {
    return at_option(option, text, [&] { return base::parse_quantity(text, unit); });
}

sweep::StrokePlan plan_of(const StrokesOptions& options) {
    sweep::StrokePlan plan;
    plan.strokes = options.strokes;
    plan.duration = value_of("--duration", options.duration, "s");
    if (!options.pause.empty()) plan.pause = value_of("--pause", options.pause, "s");
    if (!options.resistance.empty())
        plan.heating = sweep::Heating{value_of("--thermal-resistance", options.resistance, "K/W"),
                                      value_of("--thermal-time", options.thermal_time, "s")};
    if (!options.wear.empty())
        plan.wear = sweep::Wear{value_of("--wear", options.wear, "m^3/J"), value_of("--area", options.area, "m^2"),
                                value_of("--interference", options.interference, "m")};
    return plan;
}

sweep::StrokeHistory history_of(const StrokesOptions& options) {
    const sweep::StrokePlan plan = plan_of(options);
    const parameters::Case c = load_case(options.input);
    const Interrupt interrupt;
    console::ShareDisplay display("strokes:", console::TimeLeft::shown);
    sweep::StrokeOptions steps;
    steps.heating_step /= options.finer;
    steps.wear_step /= options.finer;
    steps.stop = interrupt.token();
    steps.progress = [&](std::int64_t stroke, std::int64_t all) {
        display.show(static_cast<double>(stroke) / static_cast<double>(all));
    };
    return sweep::run_strokes(c, plan, steps);
}

void strokes(const StrokesOptions& options) {
    const sweep::StrokeHistory history = history_of(options);
    if (!options.figure.empty()) pictures::draw(pictures::strokes(history), options.figure, options.sheet);
    if (!options.csv.empty()) console::write_output(options.csv, io::strokes_csv(history));
    console::print(options.json ? io::strokes_json(history) + "\n" : console::stroke_text(history));
}

void add_plan_options(CLI::App& command, StrokesOptions& options) {
    command.add_option("--strokes", options.strokes, "how many")->type_name("COUNT")->required();
    command.add_option("--duration", options.duration, "time of sliding in each stroke")->type_name("TIME")->required();
    command.add_option("--pause", options.pause, "after each stroke (default: none)")->type_name("TIME");
    CLI::Option* resistance = command
                                  .add_option("--thermal-resistance", options.resistance,
                                              "how far each watt of friction that lasts warms them")
                                  ->type_name("K/W");
    CLI::Option* time =
        command.add_option("--thermal-time", options.thermal_time, "after which 63 % of that are reached")
            ->type_name("TIME")
            ->needs(resistance);
    resistance->needs(time);
    CLI::Option* wear =
        command.add_option("--wear", options.wear, "worn volume for each joule of friction")->type_name("mm^3/J");
    CLI::Option* area =
        command.add_option("--area", options.area, "that rubs, of all contacts")->type_name("mm^2")->needs(wear);
    CLI::Option* interference =
        command.add_option("--interference", options.interference, "worn depth after which nothing presses any more")
            ->type_name("LENGTH")
            ->needs(wear);
    wear->needs(area)->needs(interference);
    command.add_option("--finer", options.finer, "compute so many times as many strokes")
        ->type_name("TIMES")
        ->check(CLI::Range(1.0, 1e6))
        ->capture_default_str();
}

}  // namespace

void add_strokes(CLI::App& program) {
    auto options = std::make_shared<StrokesOptions>();
    CLI::App* command = program.add_subcommand(
        "strokes", "Run a case stroke after stroke: friction heats the parts and wears the contact down.");
    add_case_options(*command, options->input);
    add_plan_options(*command, *options);
    add_figure_option(*command, options->figure, options->sheet, "draw what changes over the strokes");
    add_csv_option(*command, options->csv, "write all figures of each computed stroke to FILE.csv");
    add_json_option(*command, options->json, "stridor.strokes/1");
    command->footer(
        "Temperature and preload are slow: within a stroke they stand still, and a stroke is computed where they have "
        "changed by 1 degC or 1 %.\n"
        "Examples:\n  stridor strokes weatherstrip.toml --strokes 20000 --duration 0.8s --wear \"2e-5 mm^3/J\" "
        "--area 20mm^2 --interference 1.5mm\n"
        "  stridor strokes seal.toml --strokes 500 --duration 2s --pause 1s --thermal-resistance \"8 K/W\" "
        "--thermal-time 90s");
    command->callback([options] { strokes(*options); });
}

}  // namespace stridor::app
