#include "arguments.hpp"
#include "commands.hpp"
#include "crews.hpp"
#include "interrupt.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/escapes.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/console/progress.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/explorer/first_answers.hpp"
#include "stridor/explorer/page_file.hpp"
#include "stridor/io/advice/advice_texts.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/io/chart/range_text.hpp"
#include "stridor/report/design_report.hpp"
#include "stridor/report/design_results.hpp"
#include "stridor/report/html.hpp"
#include "stridor/report/timed_parts.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

namespace stridor::app {

namespace {

struct ReportOptions {
    CaseOptions input;
    RunsOptions runs;
    std::string output;
    std::string author;
    std::string part;
    std::string longest = "60 s";
    io::AxisTexts axes;
    int points = 24;
    int threads = 0;
    bool has_chart = true;
    bool has_advice = true;
    bool is_live = false;
};

// how far a part is, for who looks on; a log needs no lines of it, since no part takes long
class PartDisplay {
public:
    explicit PartDisplay(const std::string& part) : display_(part, console::TimeLeft::shown) { show(0.0); }
    void clear() { display_.clear(); }
    void show(double share) {
        if (console::has_terminal()) display_.show(share);
    }

private:
    console::ShareDisplay display_;
};

std::string command_of(const ReportOptions& options, const std::string& output) {
    std::string text = "stridor report " + base::shell_word(options.input.file);
    for (const std::string& item : options.input.overrides)
        text += " --set " + base::shell_word(item);
    if (!options.author.empty()) text += " --author " + base::shell_word(options.author);
    if (!options.part.empty()) text += " --part " + base::shell_word(options.part);
    if (!options.axes.x.empty()) text += " --x " + base::shell_word(options.axes.x);
    if (!options.axes.y.empty()) text += " --y " + base::shell_word(options.axes.y);
    if (options.points != ReportOptions{}.points) text += fmt::format(" --points {}", options.points);
    for (const std::string& direction : options.runs.directions)
        text += " --direction " + direction;
    for (const std::string& start : options.runs.starts)
        text += " --start " + start;
    if (options.longest != ReportOptions{}.longest) text += " --longest " + base::shell_word(options.longest);
    if (!options.has_chart) text += " --no-chart";
    if (!options.has_advice) text += " --no-advice";
    if (options.is_live) text += " --live";
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

report::DesignResults results_of(const io::TomlSource& source, const parameters::Case& c,
                                 const ReportOptions& options) {
    const Interrupt interrupt;
    advice::AdviceOptions asked;
    asked.runs = io::read_asked_runs(options.runs.directions, options.runs.starts);
    asked.crew = crews(options.threads);
    asked.stop = interrupt.token();
    std::optional<sweep::Study> study;
    if (options.has_chart && c.contact().static_friction > 0.0)
        study = report::chart_to_report(source, c, options.axes, options.points, asked.runs);
    const report::PartTime longest(base::parse_quantity(options.longest, "s"));
    report::DesignResults results;
    {
        const PartDisplay display("verdict:");
        results = report::basic_results(c, asked);
    }
    {
        const PartDisplay display("sounds:");
        report::add_sounds(results, asked.stop, longest);
    }
    if (study) {
        PartDisplay display("chart:");
        sweep::RunOptions charting;
        charting.crew = crew::thread_crews(options.threads);
        charting.stop = asked.stop;
        charting.progress = [&](const sweep::Progress& progress) {
            display.show(static_cast<double>(progress.done) / static_cast<double>(progress.total));
        };
        report::add_chart(results, *study, charting, longest);
    }
    if (options.has_advice) {
        PartDisplay display("what to change:");
        asked.progress = [&](const advice::AdviceProgress& progress) { display.show(progress.share); };
        report::add_advice(results, asked, longest);
    }
    for (const std::string* left_out :
         {&results.without_sound, &results.without_stability, &results.about_chart, &results.without_advice})
        if (!left_out->empty()) console::say_note(*left_out);
    return results;
}

// as asked for, else as the file has it
std::string document_text(const io::TomlSource& source, const char* key, const std::string& asked) {
    const io::TomlDocument document = io::parse_toml(source);
    const io::TomlEntry* entry = asked.empty() ? document.find(key) : nullptr;
    return entry == nullptr ? asked : std::get<std::string>(entry->value);
}

// before the work begins: a program may have no page
std::string live_page(const io::TomlSource& source) {
    const explorer::StandingCase standing = explorer::standing_alone(source);
    return explorer::page_with_first_answers(
        explorer::page_with_case(explorer::one_file_page(std::filesystem::read_symlink("/proc/self/exe")), standing),
        &standing);
}

void make_report(const ReportOptions& options) {
    const std::string output = output_of(options);
    const bool is_pdf = output.ends_with(".pdf");
    if (is_pdf && options.is_live)
        throw Error(ErrorKind::input, {"a PDF cannot be live", "paper runs no script", "Write FILE.html."});
    if (is_pdf) report::expect_printer();
    const io::TomlSource source = io::load_toml(options.input.file, options.input.overrides);
    const std::string live = options.is_live ? live_page(source) : "";
    const parameters::Case c = io::read_case(source);
    const std::string date = report::report_date();
    report::DesignResults results = results_of(source, c, options);
    results.file = options.input.file == "-" ? "" : std::filesystem::path(options.input.file).filename().string();
    results.date = date;
    results.author = document_text(source, "document.author", options.author);
    results.part = document_text(source, "document.part", options.part);
    results.command = command_of(options, output);
    report::Report written = report::design_report(results);
    written.live = live;
    const std::string page = report::html(written);
    PartDisplay display("pages:");
    const std::string bytes = is_pdf ? report::printed_pdf(page) : page;
    display.clear();
    console::write_output(output, bytes);
    if (output != "-") console::print(output + "\n");
}

}  // namespace

void add_report(CLI::App& program) {
    auto options = std::make_shared<ReportOptions>();
    CLI::App* command =
        program.add_subcommand("report", "A page on a design to hand over, and the details behind it; HTML or PDF.");
    add_case_options(*command, options->input);
    add_no_early_option(*command, options->input);
    command
        ->add_option("-o,--output", options->output,
                     "FILE.html or FILE.pdf, - for stdout (default: the case's name with -report.html)")
        ->type_name("FILE")
        ->check(in_a_folder());
    command
        ->add_option("--x", options->axes.x,
                     "the chart's axis x, as for `stridor chart` (default: the file's [chart], else the preload)")
        ->type_name("KEY=FROM:TO[:POINTS[:SCALE]]");
    command->add_option("--y", options->axes.y, "the chart's axis y (default: likewise, else the kinetic friction)")
        ->type_name("KEY=FROM:TO[:POINTS[:SCALE]]");
    command->add_option("--points", options->points, "most points of an axis")
        ->check(CLI::Range(2, 400))
        ->capture_default_str();
    command->add_option("--author", options->author, "who answers for it (default: document.author of the file)");
    command->add_option("--part", options->part, "number of the part (default: document.part of the file)");
    command
        ->add_option(
            "--longest", options->longest,
            "how long sounds, chart and what to change may each take; what does not end is coarse or left out, "
            "and the report says so")
        ->type_name("TIME")
        ->capture_default_str();
    command->add_flag("!--no-chart", options->has_chart, "leave the chart out");
    command->add_flag("!--no-advice", options->has_advice,
                      "leave out what to change, whose search takes most of the time");
    command->add_flag("--live", options->is_live,
                      "with sliders and a chart in it that a reader can move (`stridor page`); 1.6 MB more");
    add_runs_options(*command, options->runs);
    add_threads_option(*command, options->threads);
    command->footer(
        "The page has the verdict with its margin both ways, a chart around the design and what to change; sounds, "
        "pictures, figures and the case follow. It needs nothing else: no script (but for --live), no other file, no "
        "network. A PDF is printed by a browser or wkhtmltopdf. Its date is today's, or that of SOURCE_DATE_EPOCH.\n"
        "Examples:\n  stridor report squeal.toml -o report.html\n  stridor report squeal.toml --author \"M. Weber\" "
        "--part 51.3372-2 -o report.pdf\n"
        "  stridor report wiper.toml --x velocity=0.05:0.5 --y mu_d=0.2:1.2 -o wiper.html");
    command->callback([options] { make_report(*options); });
}

}  // namespace stridor::app
