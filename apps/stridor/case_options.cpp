#include "commands.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/case/toml_case.hpp"

#include <CLI/CLI.hpp>

#include <utility>

namespace stridor::app {

void add_case_options(CLI::App& command, CaseOptions& options) {
    command.add_option("file", options.file, "case file (TOML); - reads stdin")->required();
    command.add_option("--set", options.overrides, "override a key: --set contact.preload=\"50 N\" (repeatable)")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
}

void add_no_early_option(CLI::App& command, CaseOptions& options) {
    command.add_flag_callback(
        "--no-early", [&options] { options.overrides.emplace_back("run.early_ending=never"); },
        "simulate to the end, even once the rest is proven (run.early_ending=never)");
}

io::TomlSource load_source(const std::string& path, std::vector<std::string> overrides) {
    io::TomlSource source = io::load_toml(path, std::move(overrides));
    for (const base::Complaint& warning : io::case_warnings(io::parse_toml(source)))
        console::say_warning(warning);
    return source;
}

parameters::Case load_case(const CaseOptions& options) {
    return io::read_case(load_source(options.file, options.overrides));
}

}  // namespace stridor::app
