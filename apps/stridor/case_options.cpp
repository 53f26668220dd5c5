#include "arguments.hpp"
#include "commands.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/parameters/drive.hpp"
#include "stridor/sweep/starts.hpp"

#include <CLI/CLI.hpp>

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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
        "simulate to the end, even once silence is proven or a limit cycle found (run.early_ending=never)");
}

void add_runs_options(CLI::App& command, RunsOptions& options) {
    const auto words = [](std::span<const std::string_view> names) {
        return std::vector<std::string>(names.begin(), names.end());
    };
    command
        .add_option("--direction", options.directions,
                    "judge this direction of motion alone (repeatable); without it both, as whoever uses it moves it")
        ->check(one_of(words(parameters::direction_names)))
        ->allow_extra_args(false);
    command
        .add_option("--start", options.starts,
                    "judge motions that begin so (repeatable); without it all that the case can begin with")
        ->check(one_of(words(sweep::start_names())))
        ->allow_extra_args(false);
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
