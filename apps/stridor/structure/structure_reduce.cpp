#include "arguments.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/console/results/structure_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/structure/json_structure.hpp"
#include "stridor/io/structure/reduced_netcdf.hpp"
#include "stridor/reduction/craig_bampton.hpp"
#include "stridor/reduction/macneal.hpp"
#include "stridor/reduction/reduction_errors.hpp"
#include "structure/structure.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace stridor::app {

namespace {

struct ReduceOptions {
    PartOptions part;
    std::vector<std::string> boundary;
    std::vector<std::string> recovered;
    int modes = 20;
    std::string below;
    int normal = 0;
    std::string method = "craig-bampton";
    std::string inertia = "lumped";
    std::string file;
    bool json = false;
};

// of a set those that have rows: what a support holds does not move
std::vector<Eigen::Index> recovered_rows(const reduction::ElasticPart& part, const std::vector<std::string>& names) {
    std::set<Eigen::Index> rows;
    for (const std::string& name : names) {
        const reduction::NodeSet* set = find_set(part, name);
        if (set == nullptr) {
            const std::vector<Eigen::Index> named = named_rows(part, name);
            rows.insert(named.begin(), named.end());
            continue;
        }
        const std::set<std::string> nodes(set->nodes.begin(), set->nodes.end());
        std::vector<Eigen::Index> moving;
        for (std::size_t row = 0; row < part.labels.size(); ++row)
            if (nodes.contains(part.labels[row].node)) moving.push_back(static_cast<Eigen::Index>(row));
        if (moving.empty()) moving = named_rows(part, name);  // refuses it
        rows.insert(moving.begin(), moving.end());
    }
    return {rows.begin(), rows.end()};
}

void reduce(const ReduceOptions& options) {
    const reduction::ElasticPart part = load_part(options.part);
    const reduction::ReductionRequest request{
        .boundary = named_rows(part, options.boundary),
        .modes = options.modes,
        .below = options.below.empty() ? 0.0 : base::parse_quantity(options.below, "Hz"),
        .inertia =
            options.inertia == "lumped" ? reduction::BoundaryInertia::lumped : reduction::BoundaryInertia::consistent,
        .recovered = recovered_rows(part, options.recovered)};
    const reduction::CondensedPart condensed(part, request.boundary, options.part.solver);
    const reduction::Reduction reduced =
        options.method == "macneal" ? macneal(condensed, request) : craig_bampton(condensed, request);
    constexpr Eigen::Index compared = 6;
    const reduction::ReductionErrors errors =
        reduction_errors(condensed, reduced, contact_states(reduced, options.normal), compared);
    io::write_reduced_part(options.file, reduced, io::origin(options.part.files));
    console::print(options.json ? io::reduction_json(reduced, errors) + "\n"
                                : console::reduction_text(reduced, errors) + options.file + "\n");
    if (const std::string doubt = errors_doubt(reduced, errors); !doubt.empty())
        console::say("stridor: note: " + doubt);
}

}  // namespace

void add_structure_reduce(CLI::App& structure) {
    auto options = std::make_shared<ReduceOptions>();
    CLI::App* command = structure.add_subcommand(
        "reduce", "Reduce a part to its contact nodes and modes (Craig-Bampton or MacNeal), and tell the errors.");
    add_part_options(*command, options->part);
    command
        ->add_option("--boundary", options->boundary,
                     "rows that stay: a set (FOOT), some components of it (FOOT:13), a node, a row (1000.3)")
        ->type_name("ROWS")
        ->required()
        ->take_all();
    command
        ->add_option("--recover", options->recovered,
                     "further rows whose motion is wanted, likewise; of a set those that no support holds")
        ->type_name("ROWS")
        ->take_all();
    CLI::Option* modes = command->add_option("--modes", options->modes, "modes that are kept")
                             ->check(CLI::Range(0, 5000))
                             ->capture_default_str();
    command->add_option("--below", options->below, "keep all modes below this frequency instead")
        ->type_name("FREQUENCY")
        ->excludes(modes);
    command
        ->add_option("--normal", options->normal,
                     "component of the contact's normal (1 to 3), to compare sliding as well")
        ->check(CLI::Range(1, 3));
    command
        ->add_option("--method", options->method,
                     "craig-bampton: modes with the boundary held; macneal: free modes, a boundary without mass")
        ->check(CLI::IsMember({"craig-bampton", "macneal"}))
        ->capture_default_str();
    command->add_option("--inertia", options->inertia, "mass that a contact meets: lumped or consistent")
        ->check(CLI::IsMember({"lumped", "consistent"}))
        ->capture_default_str();
    add_output_file(*command, options->file, "netCDF file of the reduced part")->required();
    add_json_option(*command, options->json, "stridor.reduction/1", "print the errors as one JSON document");
    command->footer(
        "Examples:\n  stridor structure reduce block.sti --boundary FOOT --modes 12 --normal 3 -o block.nc\n"
        "  stridor structure reduce lip.sti --boundary EDGE --below \"8 kHz\" --recover 1040 -o lip.nc");
    command->callback([options] { reduce(*options); });
}

}  // namespace stridor::app
