#include "stridor/pictures/stability.hpp"

#include "arguments.hpp"
#include "commands.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/console/results/stability_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/chart/range_text.hpp"
#include "stridor/io/simulation/json_simulation.hpp"
#include "stridor/io/simulation/simulation_tables.hpp"
#include "stridor/pictures/picture_files.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace stridor::app {

namespace {

struct StabilityOptions {
    CaseOptions input;
    std::string over;  // "key=from:to[:points]"
    std::string figure;
    std::string csv;  // file to write
    pictures::Sheet sheet;
    bool has_modes = false;
    bool json = false;
};

analysis::StabilityScan scan_over(const parameters::Case& c, const std::string& over) {
    if (over.empty()) return analysis::scan_stability(c, std::nullopt);
    return at_option("--over", over, [&] { return analysis::scan_stability(c, io::read_scan_range(over)); });
}

void stability(const StabilityOptions& options) {
    const parameters::Case c = load_case(options.input);
    analysis::StabilityScan scan = scan_over(c, options.over);
    if (options.has_modes) scan = analysis::with_modes(std::move(scan));
    if (!options.figure.empty()) pictures::draw(pictures::stability(scan), options.figure, options.sheet);
    if (!options.csv.empty()) console::write_output(options.csv, io::stability_csv(scan));
    console::print(options.json ? io::stability_json(scan) + "\n" : console::stability_text(scan));
}

}  // namespace

void add_stability(CLI::App& program) {
    auto options = std::make_shared<StabilityOptions>();
    CLI::App* command = program.add_subcommand(
        "stability", "Complex eigenvalues of steady sliding: mode coupling (flutter) and sprag-slip (divergence).");
    add_case_options(*command, options->input);
    command
        ->add_option(
            "--over", options->over,
            "follow a parameter and bisect the boundaries between kinds: contact.kinetic_friction=0:0.8; ends may "
            "carry units")
        ->type_name("KEY=FROM:TO[:POINTS]");
    add_figure_option(*command, options->figure, options->sheet, "draw frequencies and growth rates")->needs("--over");
    add_csv_option(*command, options->csv,
                   "write the modes to FILE.csv, a row each, and which of them grow; with --over those of each point");
    command->add_flag("--modes", options->has_modes,
                      "say what the modes that grow are made of, and which contact feeds them");
    add_json_option(*command, options->json, "stridor.stability/1");
    command->footer(
        "Steady sliding going and coming is stable, flutter (mode coupling), divergence or locked (sprag-slip). The "
        "linear analysis says where steady sliding cannot last; a sliding contact that is stable may still be "
        "noisy when started otherwise.\n"
        "Examples:\n  stridor stability squeal.toml\n  stridor stability squeal.toml --over "
        "contact.kinetic_friction=0:0.8 --figure modes.png\n"
        "  stridor stability squeal.toml --over \"joint.incidence_angle=0 deg:180 deg:181\"");
    command->callback([options] { stability(*options); });
}

}  // namespace stridor::app
