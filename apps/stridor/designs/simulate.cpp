#include "stridor/integration/simulate.hpp"

#include "commands.hpp"
#include "interrupt.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/console/results/simulation_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/integration/failure.hpp"
#include "stridor/io/simulation/json_simulation.hpp"
#include "stridor/io/simulation/motion_csv.hpp"
#include "stridor/io/simulation/motion_netcdf.hpp"
#include "stridor/parameters/field.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/pictures/many_contacts.hpp"
#include "stridor/pictures/picture_files.hpp"

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

constexpr double most_trace_samples = 2e6;  // of a trace: 0.9 GB with the text of its file

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
    const bool draws_trace = !options.figure.empty() && !pictures::shows_many_contacts(c);
    const bool wants_trace = !options.trace.empty() || draws_trace;
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
    if (samples > most_trace_samples || !is_countable)
        throw Error(ErrorKind::input,
                    {fmt::format("the trace has {:.3g} samples", samples),
                     fmt::format("a trace is kept in memory, {:.0f} samples at most", most_trace_samples),
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

void write_records(const SimulateOptions& options, const parameters::Case& c, integration::Motion& motion,
                   double interval) {
    if (!options.figure.empty()) pictures::draw(pictures::motion_scene(c, motion.record, options.zoom), options.figure);
    if (c.own_structure) record::add_points(motion.record.trace, parameters::output_weights(*c.own_structure));
    if (!options.history.empty()) console::write_output(options.history, io::history_csv(c, motion.record.histories));
    if (options.trace.ends_with(".nc"))
        io::write_trace_netcdf(options.trace, c, motion.record);
    else if (!options.trace.empty())
        console::write_output(options.trace, io::trace_csv(c, motion.record.trace, interval));
}

void simulate(const SimulateOptions& options) {
    require_ending("--trace", options.trace, {".csv", ".nc"});
    require_ending("--history", options.history, {".csv"});
    const parameters::Case c = load_case(options.input);
    const record::Request request = request_for(options, c);
    const Interrupt interrupt;
    integration::Motion motion = integration::simulate(c, request, interrupt.token());
    if (const std::optional<Error> failure = integration::failure(c, motion)) {
        // where a motion has no end, its document says what the contacts did there
        if (options.json && failure->kind() == ErrorKind::numerical)
            console::print(io::simulation_json(c, motion, integration::cost(c), {}) + "\n");
        throw Error(*failure);
    }
    const std::vector<Verdict> verdicts = classification::classify_phases(motion.record.phases, c.verdict);
    write_records(options, c, motion, request.trace.interval);
    console::print(options.json ? io::simulation_json(c, motion, integration::cost(c), verdicts) + "\n"
                                : console::simulation_text(c, motion, verdicts));
    if (!options.json && console::has_terminal() && !c.own_structure)
        console::say(console::styled(fmt::format("next: stridor stability {} --over contact.kinetic_friction=0:{:g}",
                                                 options.input.file, c.contact.static_friction),
                                     console::Style::dim, STDERR_FILENO));
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
                     "draw motion and contact states (Figure 5) to FILE.png, FILE.svg or FILE.pdf; of an own structure "
                     "with several contacts each one's states and loads")
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
