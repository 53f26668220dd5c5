#include "commands.hpp"
#include "stridor/console/results/case_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/integration/cost.hpp"
#include "stridor/integration/failure.hpp"
#include "stridor/io/simulation/json_simulation.hpp"
#include "stridor/parameters/rules/engines.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <memory>
#include <numbers>

namespace stridor::app {

namespace {

struct CheckOptions {
    CaseOptions input;
    bool json = false;
};

void check(const CheckOptions& options) {
    const parameters::Case c = load_case(options.input);
    const integration::Cost cost = integration::cost(c);
    if (parameters::engine_of(c) != parameters::Engine::exact && c.run.step > cost.step_limit)
        throw integration::beyond_step_limit(c);
    if (options.json) {
        console::print(io::check_json(c) + "\n");
        return;
    }
    console::print(console::case_text(c, cost));
}

}  // namespace

void add_check(CLI::App& program) {
    auto options = std::make_shared<CheckOptions>();
    CLI::App* command = program.add_subcommand(
        "check", "Validate a case; print it resolved, with natural frequencies, cost and largest stable time step.");
    add_case_options(*command, options->input);
    command->add_flag("--json", options->json, "print the resolved case as JSON");
    command->footer(
        "Examples:\n  stridor check squeal.toml\n  stridor check squeal.toml --set joint.incidence_angle=\"80 deg\"");
    command->callback([options] { check(*options); });
}

}  // namespace stridor::app
