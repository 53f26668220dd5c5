#include "stridor/integration/simulate.hpp"

#include "commands.hpp"
#include "figures.hpp"
#include "interrupt.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/integration/failure.hpp"
#include "stridor/io/simulation/json_simulation.hpp"
#include "stridor/io/simulation/motion_csv.hpp"
#include "stridor/io/simulation/motion_netcdf.hpp"
#include "stridor/parameters/field.hpp"
#include "terminal.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <memory>

namespace stridor::app {

namespace {

using classification::Category;
using classification::Verdict;

constexpr double most_samples = 2e6;  // of a trace: 0.9 GB with the text of its file

struct SimulateOptions {
    CaseOptions input;
    bool json = false;
    std::string trace;       // file to write
    std::string trace_from;  // with unit
    std::string trace_to;    // with unit
    std::string trace_interval = "20 us";
    std::string history;  // file to write
    std::string figure;   // file to draw
    std::string zoom;     // "from:to" with units
};

record::Request request_for(const SimulateOptions& options, const parameters::Case& c) {
    record::Request request;
    const bool wants_trace = !options.trace.empty() || !options.figure.empty();
    const bool wants_history = !options.history.empty() || !options.figure.empty() || options.trace.ends_with(".nc");
    if (wants_history) request.history = record::KeepHistory::yes;
    if (!wants_trace) return request;
    request.trace.from = options.trace_from.empty() ? 0.0 : base::parse_quantity(options.trace_from, "s");
    request.trace.to = options.trace_to.empty() ? c.run.duration : base::parse_quantity(options.trace_to, "s");
    request.trace.interval = base::parse_quantity(options.trace_interval, "s");
    const bool is_ordered = request.trace.interval > 0.0 && request.trace.from <= request.trace.to;
    if (!is_ordered)
        throw Error(ErrorKind::input, {"the trace has no samples",
                                       "its interval must be positive and --trace-from before --trace-to", ""});
    const double samples = (request.trace.to - request.trace.from) / request.trace.interval;
    const bool is_countable = std::abs(request.trace.to / request.trace.interval) <= 1e15;
    if (samples > most_samples || !is_countable)
        throw Error(ErrorKind::input,
                    {fmt::format("the trace has {:.3g} samples", samples),
                     fmt::format("a trace is kept in memory, {:.0f} samples at most", most_samples),
                     "Lengthen --trace-interval, or shorten the time from --trace-from to --trace-to."});
    return request;
}

// a name without an ending is taken as it is: /dev/stdout, or - for standard output
void require_ending(const std::string& option, const std::string& file,
                    std::initializer_list<std::string_view> endings) {
    const std::string ending = std::filesystem::path(file).extension().string();
    if (ending.empty() || std::find(endings.begin(), endings.end(), ending) != endings.end()) return;
    std::string known;
    for (const std::string_view each : endings)
        known += (known.empty() ? "" : " or ") + std::string(each);
    throw Error(ErrorKind::input,
                {option + " " + file + " has an ending that says nothing", "the ending chooses the format: " + known,
                 "Name it " + std::filesystem::path(file).replace_extension(*endings.begin()).string() + "."});
}

std::string drive_text(const parameters::Case& c) {
    using parameters::DriveKind;
    switch (c.drive.kind) {
        case DriveKind::sinusoidal:
            return fmt::format("sinusoidal drive of {:g} mm at {:g} Hz", 1e3 * c.drive.amplitude, c.drive.frequency);
        case DriveKind::constant:
            return fmt::format("constant drive of {:g} m/s", c.drive.velocity);
        case DriveKind::sampled:
            return "sampled drive " + c.drive.file;
    }
    return {};
}

std::string figure_or_dash(double value, const char* format) {
    return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : std::string("-");
}

std::string verdict_row(const Verdict& verdict) {
    const analysis::Evidence& e = verdict.evidence;
    const bool is_noisy = verdict.category != Category::none;
    // padded before it is styled: escape codes have no width
    const std::string category = styled(fmt::format("{:<10}", classification::name(verdict.category)),
                                        is_noisy ? Style::bold : Style::plain, STDOUT_FILENO);
    return fmt::format(
        "{:<8}{}{:>8}{:>8}{:>8}{:>13}{:>12}{:>12}\n", record::phase_names[static_cast<std::size_t>(e.phase)], category,
        figure_or_dash(100.0 * e.rates.slip, "{:.1f} %"), figure_or_dash(100.0 * e.rates.stick, "{:.1f} %"),
        figure_or_dash(100.0 * e.rates.separation, "{:.1f} %"), figure_or_dash(e.alternation.regularity, "{:.3f}"),
        figure_or_dash(e.alternation.frequency, "{:.1f} Hz"), figure_or_dash(e.levels.joint.decibels, "{:.1f} dB"));
}

std::string engine_text(const parameters::Case& c) {
    if (c.run.engine == parameters::Engine::beta_2)
        return fmt::format("beta_2 = {:g}, step {:g} s", c.run.beta_2, c.run.step);
    return "exact, impact " + parameters::value_text(c, *parameters::find_field("contact.impact"));
}

// what is known of the rest of a run that ended early
std::string proof_text(const integration::Motion& motion) {
    if (motion.silence)
        return fmt::format("slips for ever from {:.4g} s on: N stays above {:.4g} N, |w| above {:.4g} m/s\n\n",
                           motion.silence->time, motion.silence->normal_force, motion.silence->slip_velocity);
    if (motion.cycle)
        return fmt::format("limit cycle from {:.4g} s on: period {:.9g} s, {} events, returns to {:.1e}\n\n",
                           motion.cycle->time, motion.cycle->period, motion.cycle->events, motion.cycle->residual);
    return "";
}

// what of the window no verdict looks at
std::string left_out(const parameters::Case& c, const std::vector<Verdict>& verdicts) {
    if (c.drive.kind != parameters::DriveKind::constant)
        return "shares are of the whole phase; the verdict is made from its steady part (verdict.settling, "
               "verdict.reversal).\n";
    const analysis::Evidence& e = verdicts.front().evidence;
    if (!(e.window_time > e.judged_time)) return "";
    return fmt::format(
        "shares are of the whole window; the verdict is made from its last {:.4g} s: what comes before is the start\n"
        "(verdict.start) and left out.\n",
        e.judged_time);
}

std::string report(const parameters::Case& c, const integration::Motion& motion, const std::vector<Verdict>& verdicts) {
    std::string text = styled(c.title.empty() ? "case" : c.title, Style::bold, STDOUT_FILENO) + "\n";
    text +=
        fmt::format("{}, preload {:g} N, mu_d {:g}, mu_s {:g}, incidence angle {:g} deg\n", drive_text(c),
                    c.contact.preload, c.contact.kinetic_friction, c.contact.static_friction, c.joint.incidence_angle);
    text += fmt::format("engine {}; start: {}; energy balance closes to {:.1e}\n\n", engine_text(c),
                        parameters::value_text(c, *parameters::find_field("run.initial")),
                        std::abs(motion.energy.relative_residual()));
    text += proof_text(motion);
    text += fmt::format("{:<8}{:<10}{:>8}{:>8}{:>8}{:>13}{:>12}{:>12}\n", "phase", "category", "slip", "stick",
                        "separ.", "regularity", "frequency", "joint level");
    for (const Verdict& verdict : verdicts)
        text += verdict_row(verdict);
    text += "\n";
    for (const Verdict& verdict : verdicts) {
        text += fmt::format("{}: ", record::phase_names[static_cast<std::size_t>(verdict.evidence.phase)]);
        for (std::size_t k = 0; k < verdict.reasons.size(); ++k)
            text += (k > 0 ? "; " : "") + verdict.reasons[k];
        text += "\n";
        for (const classification::Margin& margin : verdict.margins)
            if (std::isfinite(margin.figure))
                text += styled(fmt::format("    {:<18} {:>9.4g}  threshold {:<17} {:>7.4g}  distance {:+.4g}\n",
                                           margin.figure_name, margin.figure, margin.threshold_name, margin.threshold,
                                           margin.distance),
                               Style::dim, STDOUT_FILENO);
    }
    text += "\n" + left_out(c, verdicts) + "A category names a vibration pattern of the model.\n" +
            std::string(analysis::level_note) + "\n";
    return text;
}

void write_records(const SimulateOptions& options, const parameters::Case& c, const integration::Motion& motion,
                   double interval) {
    if (!options.history.empty()) write_output(options.history, io::history_csv(c, motion.record.histories));
    if (options.trace.ends_with(".nc"))
        io::write_trace_netcdf(options.trace, c, motion.record);
    else if (!options.trace.empty())
        write_output(options.trace, io::trace_csv(c, motion.record.trace, interval));
    if (!options.figure.empty()) draw(time_history_scene(c, motion.record, options.zoom), options.figure);
}

void simulate(const SimulateOptions& options) {
    require_ending("--trace", options.trace, {".csv", ".nc"});
    require_ending("--history", options.history, {".csv"});
    const parameters::Case c = load_case(options.input);
    const record::Request request = request_for(options, c);
    const Interrupt interrupt;
    const integration::Motion motion = integration::simulate(c, request, interrupt.token());
    if (const std::optional<Error> failure = integration::failure(c, motion)) throw Error(*failure);
    const std::vector<Verdict> verdicts = classification::classify_phases(motion.record.phases, c.verdict);
    write_records(options, c, motion, request.trace.interval);
    print(options.json ? io::simulation_json(c, motion, integration::cost(c), verdicts) + "\n"
                       : report(c, motion, verdicts));
    if (!options.json && has_terminal())
        say(styled(fmt::format("next: stridor stability {} --over contact.kinetic_friction=0:{:g}", options.input.file,
                               c.contact.static_friction),
                   Style::dim, STDERR_FILENO));
}

}  // namespace

void add_simulate(CLI::App& program) {
    auto options = std::make_shared<SimulateOptions>();
    CLI::App* command =
        program.add_subcommand("simulate", "Run one case and say whether it squeals, squeaks, creaks or stays quiet.");
    add_case_options(*command, options->input);
    add_no_early_option(*command, options->input);
    command->add_flag("--json", options->json, "print one JSON document (schema stridor.simulation/1)");
    command->add_option("--trace", options->trace, "write the sampled motion to FILE.csv or FILE.nc")
        ->type_name("FILE");
    command->add_option("--trace-from", options->trace_from, "first sample (default 0)")->type_name("TIME");
    command->add_option("--trace-to", options->trace_to, "last sample (default: the end)")->type_name("TIME");
    command->add_option("--trace-interval", options->trace_interval, "time between samples")
        ->type_name("TIME")
        ->capture_default_str();
    command->add_option("--history", options->history, "write every contact state with its times to FILE.csv")
        ->type_name("FILE");
    command
        ->add_option("--figure", options->figure,
                     "draw motion and contact states (Figure 5) to FILE.png, FILE.svg or FILE.pdf")
        ->type_name("FILE");
    command->add_option("--zoom", options->zoom, "time range of the figure's zoom")->type_name("FROM:TO");
    command->footer(
        "Examples:\n  stridor simulate squeal.toml\n  stridor simulate squeal.toml --set contact.preload=\"200 N\" "
        "--json\n"
        "  stridor simulate squeal.toml --figure squeal.png --zoom \"230 ms:250 ms\"\n  stridor init creak | stridor "
        "simulate -");
    command->callback([options] { simulate(*options); });
}

}  // namespace stridor::app
