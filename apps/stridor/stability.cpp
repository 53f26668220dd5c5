#include "commands.hpp"
#include "figures.hpp"
#include "stability_scan.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/io/simulation/json_simulation.hpp"
#include "terminal.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <memory>

namespace stridor::app {

namespace {

using analysis::StabilityKind;

struct StabilityOptions {
    CaseOptions input;
    std::string over;  // "key=from:to[:points]"
    std::string figure;
    bool json = false;
};

std::string kind_name(StabilityKind kind) {
    return std::string(analysis::stability_names[static_cast<std::size_t>(kind)]);
}

std::string modes_text(const analysis::SlidingStability& stability) {
    std::string text;
    for (const analysis::Eigenmode& mode : stability.modes)
        text += fmt::format("  {:9.2f} Hz {:+10.3f} 1/s", mode.frequency, mode.growth);
    return text;
}

std::string header(const analysis::StabilityScan& scan) {
    std::string text = styled("stability of steady sliding", Style::bold, STDOUT_FILENO) + "\n\n";
    for (const analysis::DirectionScan& direction : scan.directions) {
        const analysis::SlidingStability& here = direction.here;
        text += fmt::format("{:<8}{:<11}N/F {:8.4f}  modes{}\n",
                            parameters::direction_names[static_cast<std::size_t>(direction.direction)],
                            kind_name(here.kind), here.normal_force / scan.base.contact.preload, modes_text(here));
    }
    return text;
}

std::string boundary_lines(const analysis::StabilityScan& scan, const analysis::DirectionScan& direction) {
    std::string text;
    const std::string name(parameters::direction_names[static_cast<std::size_t>(direction.direction)]);
    if (direction.path.boundaries.empty())
        text += fmt::format("{:<8}{} throughout\n", name, kind_name(direction.path.points.front().stability.kind));
    for (const analysis::StabilityBoundary& boundary : direction.path.boundaries)
        text += fmt::format("{:<8}{} -> {} at {} = {:.5g}{} ({:.2f} Hz)\n", name, kind_name(boundary.below),
                            kind_name(boundary.above), scan.key, boundary.value,
                            scan.unit == "1" ? "" : " " + scan.unit, boundary.frequency);
    return text;
}

std::string table(const analysis::StabilityScan& scan) {
    std::string text = header(scan);
    if (scan.key.empty()) return text;
    text += "\n";
    for (const analysis::DirectionScan& direction : scan.directions)
        text += boundary_lines(scan, direction);
    const std::string name = scan.key.substr(scan.key.find('.') + 1);
    const std::size_t width = std::max<std::size_t>(12, name.size());
    for (const analysis::DirectionScan& direction : scan.directions) {
        text += fmt::format("\n{:<8}{:>{}}  {:<11}modes (frequency, growth)\n",
                            parameters::direction_names[static_cast<std::size_t>(direction.direction)], name, width,
                            "kind");
        for (const analysis::StabilityPoint& point : direction.path.points)
            text += fmt::format("{:<8}{:>{}.6g}  {:<11}{}\n", "", point.value, width, kind_name(point.stability.kind),
                                modes_text(point.stability));
    }
    return text;
}

void stability(const StabilityOptions& options) {
    const parameters::Case c = load_case(options.input);
    const analysis::StabilityScan scan = scan_stability(c, options.over);
    if (!options.figure.empty()) draw_stability(scan, options.figure);
    print(options.json ? io::stability_json(scan) + "\n" : table(scan));
}

}  // namespace

void add_stability(CLI::App& program) {
    auto options = std::make_shared<StabilityOptions>();
    CLI::App* command = program.add_subcommand(
        "stability", "Complex eigenvalues of steady sliding: mode coupling (flutter) and sprag-slip (divergence).");
    add_case_options(*command, options->input);
    command
        ->add_option("--over", options->over,
                     "follow a parameter: contact.kinetic_friction=0:0.8[:POINTS]; ends may carry units")
        ->type_name("KEY=FROM:TO[:POINTS]");
    command
        ->add_option("--figure", options->figure,
                     "draw frequencies and growth rates to FILE.png, FILE.svg or FILE.pdf (needs --over)")
        ->type_name("FILE")
        ->needs("--over");
    command->add_flag("--json", options->json, "print one JSON document (schema stridor.stability/1)");
    command->footer(
        "The linear analysis says where steady sliding cannot last; a sliding contact that is stable may still be "
        "noisy when started otherwise.\n"
        "Examples:\n  stridor stability squeal.toml\n  stridor stability squeal.toml --over "
        "contact.kinetic_friction=0:0.8 --figure modes.png\n"
        "  stridor stability squeal.toml --over \"joint.incidence_angle=0 deg:180 deg:181\"");
    command->callback([options] { stability(*options); });
}

}  // namespace stridor::app
