#include "arguments.hpp"
#include "commands.hpp"
#include "stridor/io/case_schema.hpp"
#include "stridor/io/toml_writer.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/sweep/paper_charts.hpp"
#include "stridor/sweep/soft_parts.hpp"
#include "terminal.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace stridor::app {

namespace {

struct InitOptions {
    std::string kind;
    std::string output;
};

std::string text_of(const std::string& kind) {
    if (kind == "noise-chart") return io::study_toml(sweep::figure_8());
    if (kind == "rate-map") return io::study_toml(sweep::figure_6(70.0));
    if (kind == "schema") return io::json_schema();
    for (std::size_t k = 0; k < sweep::soft_part_names.size(); ++k)
        if (kind == sweep::soft_part_names[k].name)
            return io::study_toml(sweep::soft_part(static_cast<sweep::SoftPart>(k)));
    const auto found = std::find(parameters::paper_case_names.begin(), parameters::paper_case_names.end(), kind);
    return io::case_toml(
        parameters::paper_case(static_cast<parameters::PaperCase>(found - parameters::paper_case_names.begin())));
}

std::vector<std::string> kinds() {
    std::vector<std::string> kinds(parameters::paper_case_names.begin(), parameters::paper_case_names.end());
    kinds.insert(kinds.end(), {"noise-chart", "rate-map"});
    for (const sweep::SoftPartName& part : sweep::soft_part_names)
        kinds.emplace_back(part.name);
    kinds.emplace_back("schema");
    return kinds;
}

}  // namespace

void add_init(CLI::App& program) {
    auto options = std::make_shared<InitOptions>();
    CLI::App* command = program.add_subcommand("init", "Write a commented case or chart file to start from.");
    command
        ->add_option(
            "kind", options->kind,
            "squeal, squeak, creak, quiet: Table 1; noise-chart: Figure 8; rate-map: Figure 6; weatherstrip, "
            "weatherstrip-shaken, glass-run, clip, wiper, brake-pad: soft parts of a car, each with its chart; "
            "schema: JSON Schema of case files")
        ->required()
        ->check(CLI::IsMember(kinds()));
    add_output_file(*command, options->output, "file to write (default: stdout)");
    command->footer(
        "Examples:\n  stridor init squeal -o squeal.toml\n  stridor init quiet | stridor simulate -\n"
        "  stridor init weatherstrip | stridor chart - --out seal");
    command->callback([options] { write_output(options->output, text_of(options->kind)); });
}

}  // namespace stridor::app
