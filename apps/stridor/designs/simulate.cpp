#include "stridor/integration/simulate.hpp"

#include "arguments.hpp"
#include "commands.hpp"
#include "interrupt.hpp"
#include "stridor/base/text.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/console/results/simulation_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/integration/cost.hpp"
#include "stridor/integration/failure.hpp"
#include "stridor/io/chart/range_text.hpp"
#include "stridor/io/simulation/end_state_file.hpp"
#include "stridor/io/simulation/json_simulation.hpp"
#include "stridor/io/simulation/simulation_tables.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/pictures/many_contacts.hpp"
#include "stridor/pictures/picture_files.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <memory>
#include <optional>
#include <utility>

namespace stridor::app {

namespace {

using classification::Category;
using classification::Verdict;

struct SimulateOptions {
    CaseOptions input;
    bool json = false;
    std::string trace;  // file to write
    io::TraceTexts times;
    std::string history;    // file to write
    std::string figure;     // file to draw
    std::string end_state;  // file to write
    std::string from;       // end state to go on with
    std::string initial;    // end state to begin in
    std::string zoom;       // "from:to" with units
    pictures::Sheet sheet;
};

record::Request request_for(const SimulateOptions& options, const parameters::Case& c) {
    record::Request request;
    const bool draws_trace = !options.figure.empty() && !pictures::shows_many_contacts(c);
    const bool wants_trace = !options.trace.empty() || draws_trace;
    const bool wants_history = !options.history.empty() || !options.figure.empty() || options.trace.ends_with(".nc");
    if (wants_history) request.history = record::KeepHistory::yes;
    if (wants_trace) request.trace = io::trace_request(options.times, c);
    return request;
}

void write_records(const SimulateOptions& options, const parameters::Case& c, integration::Motion& motion,
                   double interval) {
    if (!options.figure.empty())
        pictures::draw(pictures::motion_scene(c, motion.record, options.zoom), options.figure, options.sheet);
    record::add_points(motion.record.trace, parameters::output_weights(c));
    if (!options.history.empty()) console::write_output(options.history, io::history_csv(c, motion.record.histories));
    if (options.trace.ends_with(".nc"))
        io::write_trace_netcdf(options.trace, c, motion.record);
    else if (!options.trace.empty())
        console::write_output(options.trace, io::trace_csv(c, motion.record.trace, interval));
}

// the case, to begin in the end state of another run
parameters::Case begun_in(const SimulateOptions& options, parameters::Case c) {
    if (options.initial.empty()) return c;
    const io::ReadEndState read = io::read_end_state_file(options.initial);
    io::expect_same_shape(read, c, options.initial);
    return integration::begun_at(std::move(c), read.state);
}

// a run of the same case to go on with
std::optional<integration::EndState> state_to_go_on_with(const SimulateOptions& options, const parameters::Case& c) {
    if (options.from.empty()) return std::nullopt;
    io::ReadEndState read = io::read_end_state_file(options.from);
    io::expect_same_case(read, c, options.from);
    return std::move(read.state);
}

void simulate(const SimulateOptions& options) {
    storage::expect_ending("--trace", options.trace, {".csv", ".nc"});
    storage::expect_ending("--history", options.history, {".csv"});
    storage::expect_ending("--end-state", options.end_state, {".json"});
    const parameters::Case c = begun_in(options, load_case(options.input));
    const std::optional<integration::EndState> from = state_to_go_on_with(options, c);
    const record::Request request = request_for(options, c);
    const Interrupt interrupt;
    integration::Motion motion = from ? integration::go_on(c, *from, request, interrupt.token())
                                      : integration::simulate(c, request, interrupt.token());
    if (const std::optional<Error> failure = integration::failure(c, motion)) {
        // where a motion has no end, its document says what the contacts did there
        if (options.json && failure->kind() == ErrorKind::numerical)
            console::print(io::simulation_json(c, motion, integration::cost(c), {}) + "\n");
        throw Error(*failure);
    }
    const std::vector<Verdict> verdicts =
        classification::classify_phases(motion.record.phases, c.verdict, classification::contact_names(c));
    write_records(options, c, motion, request.trace.interval);
    if (!options.end_state.empty()) {
        const integration::Ended ended = integration::run_to_end(c, from ? &*from : nullptr, interrupt.token());
        if (ended.outcome.reason == integration::Reason::cancelled)
            throw Error(ErrorKind::interrupted, {"the end state was not made", "it was interrupted", ""});
        console::write_output(options.end_state, io::end_state_json(c, ended.state) + "\n");
    }
    console::print(options.json ? io::simulation_json(c, motion, integration::cost(c), verdicts) + "\n"
                                : console::simulation_text(c, motion, verdicts));
    if (!options.json && console::has_terminal() && parameters::has_plate(c))
        console::say(console::styled(fmt::format("next: stridor stability {} --over contact.kinetic_friction=0:{:g}",
                                                 options.input.file, c.contact().static_friction),
                                     console::Style::dim, STDERR_FILENO));
}

}  // namespace

void add_simulate(CLI::App& program) {
    auto options = std::make_shared<SimulateOptions>();
    CLI::App* command =
        program.add_subcommand("simulate", "Run one case and say whether it squeals, squeaks, creaks or stays quiet.");
    add_case_options(*command, options->input);
    add_no_early_option(*command, options->input);
    add_json_option(*command, options->json, "stridor.simulation/1");
    command->add_option("--trace", options->trace, "write the sampled motion to FILE.csv or FILE.nc")
        ->type_name("FILE")
        ->check(in_a_folder());
    command->add_option("--trace-from", options->times.from, "first sample (default 0)")->type_name("TIME");
    command->add_option("--trace-to", options->times.to, "last sample (default: the end)")->type_name("TIME");
    command->add_option("--trace-interval", options->times.interval, "time between samples")
        ->type_name("TIME")
        ->capture_default_str();
    command->add_option("--history", options->history, "write every contact state with its times to FILE.csv")
        ->type_name("FILE")
        ->check(in_a_folder());
    command
        ->add_option("--end-state", options->end_state,
                     "write where the run stands at its end to FILE.json, to go on with it")
        ->type_name("FILE")
        ->check(in_a_folder());
    CLI::Option* from = command
                            ->add_option("--from", options->from,
                                         "go on with a run of the same case: its --end-state; run.duration counts "
                                         "from that run's begin")
                            ->type_name("FILE");
    command
        ->add_option("--initial", options->initial,
                     "begin a run of its own in the --end-state of another one, perhaps of other quantities")
        ->type_name("FILE")
        ->excludes(from);
    add_figure_option(*command, options->figure, options->sheet,
                      "draw motion and contact states (Figure 5), of an own structure with several contacts each one's "
                      "states and loads,");
    command->add_option("--zoom", options->zoom, "time range of the figure's zoom")->type_name("FROM:TO");
    command->footer(
        "Examples:\n  stridor simulate squeal.toml\n  stridor simulate squeal.toml --set contact.preload=\"200 N\" "
        "--json\n"
        "  stridor simulate squeal.toml --figure squeal.png --zoom \"230 ms:250 ms\"\n  stridor init creak | stridor "
        "simulate -");
    command->callback([options] { simulate(*options); });
}

}  // namespace stridor::app
