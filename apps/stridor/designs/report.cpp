#include "commands.hpp"
#include "interrupt.hpp"
#include "pdf.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/escapes.hpp"
#include "stridor/base/text.hpp"
#include "stridor/console/progress.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/io/chart/axis_text.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/parameters/temperature_table.hpp"
#include "stridor/report/design_report.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

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

// asks for a stop when somebody else does, or when the time is up
class Deadline {
public:
    Deadline(const std::stop_token& asked, std::chrono::seconds time)
        : relay_(asked, [this] { source_.request_stop(); }),
          watch_([this, time](const std::stop_token& end) {
              std::unique_lock lock(mutex_);
              std::condition_variable_any().wait_for(lock, end, time, [] { return false; });
              if (!end.stop_requested()) source_.request_stop();
          }) {}

    std::stop_token token() const { return source_.get_token(); }

private:
    std::stop_source source_;
    std::stop_callback<std::function<void()>> relay_;
    std::mutex mutex_;
    std::jthread watch_;  // last: ends before what it uses
};

bool has_chart_axes(const io::TomlSource& source) {
    const io::TomlDocument document = io::parse_toml(source);
    return document.find("chart.x.parameter") != nullptr && document.find("chart.y.parameter") != nullptr;
}

// the axes asked for, else those of the file, else preload and friction (or the temperature it follows)
sweep::Study study_for(const ReportOptions& options, const io::TomlSource& source, const parameters::Case& c) {
    io::AxisTexts axes = options.axes;
    const bool is_own = axes.x.empty() && axes.y.empty() && !has_chart_axes(source);
    if (is_own) {
        axes.x = fmt::format("contact.preload={}:{}:{}:log", base::shortest(0.1 * c.contact.preload),
                             base::shortest(10.0 * c.contact.preload), options.points);
        const std::vector<double>& at = c.temperature.at;
        axes.y = parameters::temperature_column(c, "contact.kinetic_friction") == nullptr
                     ? fmt::format("contact.kinetic_friction=0:{}:{}", base::shortest(c.contact.static_friction),
                                   options.points)
                     : fmt::format("temperature.value={}:{}:{}", base::shortest(at.front()), base::shortest(at.back()),
                                   options.points);
    }
    sweep::Study study = io::read_study(source, axes);
    if (sweep::has_one_axis(study))
        throw Error(ErrorKind::input, {"the chart of a report has two axes", "--x was given without --y",
                                       "Add --y, such as --y mu_d=0.2:0.8."});
    for (sweep::Axis* axis : {&study.x, &study.y})
        axis->points = std::min(axis->points, options.points);
    study.quantities = {"category"};
    study.refine = 0;
    study.starts.clear();
    return study;
}

void add_advice(report::DesignResults& results, const ReportOptions& options, const std::stop_token& asked) {
    const Deadline deadline(asked, longest_advice);
    console::ShareDisplay display("advice:", console::TimeLeft::shown);
    advice::AdviceOptions advice;
    advice.threads = options.threads;
    advice.stop = deadline.token();
    advice.progress = [&](const advice::AdviceProgress& progress) { display.show(progress.share); };
    try {
        results.advice = advice::advise(results.design, advice);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::interrupted || asked.stop_requested()) throw;
        results.without_advice = fmt::format(
            "The search for a quieting change did not end within {} s and was left out; `stridor advise` takes its "
            "time.",
            longest_advice.count());
    }
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
    if (is_pdf) expect_printer();
    const io::TomlSource source = io::load_toml(options.input.file, options.input.overrides);
    const parameters::Case c = io::read_case(source);
    const bool has_chart = options.has_chart && c.contact.static_friction > 0.0;
    std::optional<sweep::Study> study;
    if (has_chart) study = study_for(options, source, c);
    const Interrupt interrupt;
    report::DesignResults results = report::basic_results(c, interrupt.token());
    results.command = command_of(options, output);
    if (study) results.chart = report::chart_in_memory(*study, options.threads, interrupt.token());
    if (options.has_advice) add_advice(results, options, interrupt.token());
    const std::string page = report::html(report::design_report(results));
    console::write_output(output, is_pdf ? printed_pdf(page) : page);
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
    command->add_option("--threads", options->threads, "number of threads (default: one per processor)")
        ->check(CLI::Range(0, 4096));
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
