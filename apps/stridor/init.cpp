#include "arguments.hpp"
#include "commands.hpp"
#include "stridor/base/error.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/case/case_schema.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "stridor/sweep/paper_charts.hpp"
#include "stridor/sweep/soft_parts.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

namespace stridor::app {

namespace {

struct InitOptions {
    std::string kind;
    std::string output;
    bool is_forced = false;
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

// a file that holds what somebody wrote is not lost; what init wrote itself may go
void spare_others(const std::string& file) {
    std::error_code ignored;
    if (file.empty() || file == "-" || !std::filesystem::is_regular_file(file, ignored)) return;
    const std::string there = storage::read_file(file);
    const std::vector<std::string> all = kinds();
    const bool is_ours = std::any_of(all.begin(), all.end(), [&](const auto& kind) { return text_of(kind) == there; });
    if (!there.empty() && !is_ours)
        throw Error(ErrorKind::input, {"\"" + file + "\" is there already", "it holds other than `stridor init` writes",
                                       "Name another file, or take --force to lose it."});
}

void init(const InitOptions& options) {
    if (!options.is_forced) spare_others(options.output);
    console::write_output(options.output, text_of(options.kind));
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
    command->add_flag("--force", options->is_forced, "write over a file that was changed by hand");
    command->footer(
        "Examples:\n  stridor init squeal -o squeal.toml\n  stridor init quiet | stridor simulate -\n"
        "  stridor init weatherstrip | stridor chart - --out seal");
    command->callback([options] { init(*options); });
}

}  // namespace stridor::app
