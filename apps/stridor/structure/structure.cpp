#include "structure/structure.hpp"

#include "arguments.hpp"
#include "commands.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/console/results/case_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/structure/json_structure.hpp"
#include "stridor/io/structure/reduced_netcdf.hpp"
#include "stridor/reduction/contact_surface.hpp"
#include "stridor/reduction/craig_bampton.hpp"
#include "stridor/reduction/macneal.hpp"
#include "stridor/reduction/part_contacts.hpp"
#include "stridor/reduction/part_figures.hpp"
#include "stridor/reduction/reduction_errors.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdlib>
#include <memory>
#include <optional>
#include <set>

namespace stridor::app {

namespace {

struct PartInfoOptions {
    PartOptions part;
    bool json = false;
};

void info(const PartInfoOptions& options) {
    const reduction::ElasticPart part = load_part(options.part);
    const reduction::PartSize size = part_size(part);
    console::print(options.json ? io::part_json(part, size, nullptr) + "\n" : console::part_text(part, size));
}

struct PartCheckOptions {
    PartOptions part;
    int modes = 6;
    std::vector<std::string> contact;  // rows
    int normal = 0;                    // component with the sign of the direction
    double friction = 1.0;
    bool json = false;
};

// what its contacts meet in an impact; null where none are named
std::optional<reduction::PartContacts> contacts_of(const reduction::ElasticPart& part,
                                                   const PartCheckOptions& options) {
    if (options.contact.empty()) return std::nullopt;
    std::optional<reduction::PartContacts> contacts =
        part_contacts(part, named_rows(part, options.contact), std::abs(options.normal), options.part.solver);
    if (!contacts)
        throw Error(ErrorKind::numerical, {"the inertia of the contacts is not known", "some motion has no mass",
                                           "Reduce the part first: stridor structure reduce."});
    return contacts;
}

void say_doubt(const base::Problem& doubt) {
    console::say(fmt::format("stridor: note: {} ({}).{}{}", doubt.what, doubt.why, doubt.suggestion.empty() ? "" : " ",
                             doubt.suggestion));
}

void check(const PartCheckOptions& options) {
    const reduction::ElasticPart part = load_part(options.part);
    const reduction::PartSize size = part_size(part);
    const reduction::PartVibration vibration = part_vibration(part, options.modes, options.part.solver);
    const std::optional<reduction::PartContacts> contacts = contacts_of(part, options);
    if (options.json)
        console::print(io::part_json(part, size, &vibration, contacts ? &*contacts : nullptr) + "\n");
    else
        console::print(console::part_text(part, size) + console::vibration_text(vibration) +
                       (contacts ? console::part_contacts_text(*contacts) : ""));
    if (!contacts) return;
    for (const base::Problem& doubt : surface_doubts(part, named_rows(part, options.contact), options.normal))
        say_doubt(doubt);
    for (const base::Problem& doubt : doubts(*contacts, options.friction))
        say_doubt(doubt);
}

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
        reduction_errors(condensed, reduced, contact_states(reduced, std::abs(options.normal)), compared);
    io::write_reduced_part(options.file, reduced, io::origin(options.part.files));
    console::print(options.json ? io::reduction_json(reduced, errors) + "\n"
                                : console::reduction_text(reduced, errors) + options.file + "\n");
    if (const std::string doubt = errors_doubt(reduced, errors); !doubt.empty())
        console::say("stridor: note: " + doubt);
    if (options.normal == 0) return;
    for (const base::Problem& doubt : surface_doubts(part, request.boundary, options.normal))
        say_doubt(doubt);
}

}  // namespace

void add_part_options(CLI::App& command, PartOptions& options) {
    command.add_option("files", options.files.files, "the part: what a finite-element program wrote of it, or a .nc");
    command
        .add_option("--stiffness", options.files.stiffness,
                    "a matrix that does not say that it is the stiffness; FILE:NAME, one of several")
        ->type_name("FILE");
    command.add_option("--mass", options.files.mass, "a matrix that does not say that it is the mass")
        ->type_name("FILE");
    command.add_option("--damping", options.files.damping, "a matrix that does not say that it is the damping")
        ->type_name("FILE");
    command.add_option("--labels", options.files.labels, "node and component of each row: CSV, or Ansys' mapping")
        ->type_name("FILE");
    command.add_option("--units", options.units, "of the files: m-kg-s, mm-t-s, mm-kg-ms, mm-kg-s or cm-g-s")
        ->type_name("UNITS")
        ->capture_default_str();
    const auto choose = [&options](const std::string& name) { options.solver = reduction::solver_named(name); };
    command
        .add_option_function<std::string>(
            "--solver", choose,
            "who factorises: eigen gives the same bits on every machine; mumps, where the program "
            "was built with it, takes solids of 10^5 rows")
        ->check(CLI::IsMember({"eigen", "mumps"}))
        ->default_str("eigen");
}

reduction::ElasticPart load_part(const PartOptions& options) {
    const io::PartFiles& files = options.files;
    if (files.files.empty() && files.stiffness.empty() && files.mass.empty())
        base::refuse("no file of a part is named", "", "`stridor structure info job.sti`, or --stiffness and --mass.");
    const reduction::UnitSystem& units = reduction::unit_system(options.units);
    const bool is_in_si = io::is_reduced_part(files);
    reduction::ElasticPart part = is_in_si ? io::read_reduced_part(files.files.front()).part : io::read_part(files);
    expect_sound(part, options.solver);
    for (const std::string& note : part.notes)
        console::say("stridor: note: " + note);
    if (is_in_si) return part;
    if (const std::string doubt = units_doubt(part_size(part), units); !doubt.empty())
        console::say("stridor: note: " + doubt);
    return in_si(std::move(part), units);
}

void add_structure_info(CLI::App& structure) {
    auto options = std::make_shared<PartInfoOptions>();
    CLI::App* command = structure.add_subcommand("info", "What a part holds: rows, nodes, sets, mass, units.");
    add_part_options(*command, options->part);
    add_json_option(*command, options->json, "stridor.part/1");
    command->footer(
        "Examples:\n  stridor structure info block.sti\n"
        "  stridor structure info --stiffness k.mtx --mass m.mtx --labels rows.csv --units mm-t-s");
    command->callback([options] { info(*options); });
}

void add_structure_check(CLI::App& structure) {
    auto options = std::make_shared<PartCheckOptions>();
    CLI::App* command =
        structure.add_subcommand("check", "Is it a structure? Its rigid-body modes and frequencies as well.");
    add_part_options(*command, options->part);
    command->add_option("--modes", options->modes, "how many frequencies")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    CLI::Option* contact =
        command->add_option("--contact", options->contact, "rows at which it is to rub: can their inertia be believed?")
            ->type_name("ROWS")
            ->take_all();
    command
        ->add_option("--normal", options->normal,
                     "direction in which a gap opens, into the part: 1 to 3 for x, y, z, or -1 to -3")
        ->check(CLI::IsMember({1, 2, 3, -1, -2, -3}))
        ->needs(contact);
    command->add_option("--friction", options->friction, "largest coefficient of friction that is meant")
        ->check(CLI::PositiveNumber.description(""))
        ->needs(contact)
        ->capture_default_str();
    add_json_option(*command, options->json, "stridor.part/1");
    command->footer(
        "Examples:\n  stridor structure check block.sti --modes 10\n"
        "  stridor structure check block.nc --contact FOOT --normal 3");
    command->callback([options] { check(*options); });
}

void add_structure(CLI::App& program) {
    CLI::App* structure =
        program.add_subcommand("structure", "Parts of finite-element programs: look at them, check them, reduce them.");
    structure->require_subcommand(1);
    add_structure_info(*structure);
    add_structure_check(*structure);
    add_structure_reduce(*structure);
    structure->footer(
        "Read are CalculiX (.sti, .mas, .dof), Matrix Market, SciPy (.npz), Abaqus, Nastran (.pch, .op4), Ansys "
        "(Harwell-Boeing), and what `stridor structure reduce` writes.");
}

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
                     "direction in which a gap opens, into the part: 1 to 3 or -1 to -3, to compare sliding as well")
        ->check(CLI::IsMember({1, 2, 3, -1, -2, -3}));
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
