#include "arguments.hpp"
#include "commands.hpp"
#include "crews.hpp"
#include "interrupt.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/escapes.hpp"
#include "stridor/console/progress.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/io/chart/axis_text.hpp"
#include "stridor/report/design_report.hpp"
#include "stridor/report/pdf.hpp"
#include "stridor/report/report_chart.hpp"
#include "stridor/report/timed_advice.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>

namespace stridor::app {

namespace {

constexpr std::chrono::seconds longest_advice{60};

struct ReportOptions {
    CaseOptions input;
    std::string output;
    io::AxisTexts axes;
    int points = 24;
    int threads = 0;
    bool has_chart = true;
    bool has_advice = true;
};

void add_advice(report::DesignResults& results, const ReportOptions& options, const std::stop_token& asked) {
    console::ShareDisplay display("advice:", console::TimeLeft::shown);
    advice::AdviceOptions advice;
    advice.crew = crews(options.threads);
    advice.stop = asked;
    advice.progress = [&](const advice::AdviceProgress& progress) { display.show(progress.share); };
    report::add_advice(results, advice, longest_advice);
}

std::string command_of(const ReportOptions& options, const std::string& output) {
    std::string text = "stridor report " + base::shell_word(options.input.file);
    for (const std::string& item : options.input.overrides)
        text += " --set " + base::shell_word(item);
    if (!options.axes.x.empty()) text += " --x " + base::shell_word(options.axes.x);
    if (!options.axes.y.empty()) text += " --y " + base::shell_word(options.axes.y);
    if (options.points != ReportOptions{}.points) text += fmt::format(" --points {}", options.points);
    if (!options.has_chart) text += " --no-chart";
    if (!options.has_advice) text += " --no-advice";
    return text + " -o " + base::shell_word(output);
}

std::string output_of(const ReportOptions& options) {
    if (options.output.empty()) {
        const bool is_stdin = options.input.file == "-";
        return (is_stdin ? "case" : std::filesystem::path(options.input.file).stem().string()) + "-report.html";
    }
    const std::string extension = std::filesystem::path(options.output).extension().string();
    if (options.output != "-" && extension != ".html" && extension != ".htm" && extension != ".pdf")
        throw Error(ErrorKind::input, {"cannot write a report into " + options.output,
                                       "a report is a .html or a .pdf file", "Give the name one of these endings."});
    return options.output;
}

void make_report(const ReportOptions& options) {
    const std::string output = output_of(options);
    const bool is_pdf = output.ends_with(".pdf");
    if (is_pdf) report::expect_printer();
    const io::TomlSource source = io::load_toml(options.input.file, options.input.overrides);
    const parameters::Case c = io::read_case(source);
    const bool has_chart = options.has_chart && c.contact.static_friction > 0.0;
    std::optional<sweep::Study> study;
    if (has_chart) study = report::chart_to_report(source, c, options.axes, options.points);
    const Interrupt interrupt;
    report::DesignResults results = report::basic_results(c, interrupt.token());
    results.command = command_of(options, output);
    if (study) results.chart = report::chart_in_memory(*study, options.threads, interrupt.token());
    if (options.has_advice) add_advice(results, options, interrupt.token());
    const std::string page = report::html(report::design_report(results));
    console::write_output(output, is_pdf ? report::printed_pdf(page) : page);
    if (output != "-") console::print(output + "\n");
}

}  // namespace

void add_report(CLI::App& program) {
    auto options = std::make_shared<ReportOptions>();
    CLI::App* command = program.add_subcommand(
        "report", "One page on a design: verdict, sound, chart, what to change, the case itself; HTML or PDF.");
    add_case_options(*command, options->input);
    add_no_early_option(*command, options->input);
    command
        ->add_option("-o,--output", options->output,
                     "FILE.html or FILE.pdf, - for stdout (default: the case's name with -report.html)")
        ->type_name("FILE");
    command
        ->add_option("--x", options->axes.x,
                     "the chart's axis x, as for `stridor chart` (default: the file's [chart], else the preload)")
        ->type_name("KEY=FROM:TO[:POINTS[:SCALE]]");
    command->add_option("--y", options->axes.y, "the chart's axis y (default: likewise, else the kinetic friction)")
        ->type_name("KEY=FROM:TO[:POINTS[:SCALE]]");
    command->add_option("--points", options->points, "most points of an axis")
        ->check(CLI::Range(2, 400))
        ->capture_default_str();
    command->add_flag("!--no-chart", options->has_chart, "leave the chart out");
    command->add_flag("!--no-advice", options->has_advice,
                      "leave out what to change; its search takes some seconds, and is given up after 60 s");
    add_threads_option(*command, options->threads);
    command->footer(
        "The page needs nothing else: no script, no other file, no network. A PDF is printed by a browser or "
        "wkhtmltopdf.\n"
        "Examples:\n  stridor report squeal.toml -o report.html\n  stridor report squeal.toml --set "
        "contact.kinetic_friction=0.3 -o "
        "report.pdf\n"
        "  stridor report wiper.toml --x velocity=0.05:0.5 --y mu_d=0.2:1.2 -o wiper.html");
    command->callback([options] { make_report(*options); });
}

}  // namespace stridor::app
