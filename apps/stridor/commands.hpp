#pragma once

#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/parameters/case.hpp"

#include <array>
#include <string>
#include <vector>

namespace CLI {
class App;
}

/// One function per command: it adds the command with its options and examples to the program.
namespace stridor::app {

void add_init(CLI::App& program);
void add_check(CLI::App& program);
void add_simulate(CLI::App& program);
void add_stability(CLI::App& program);
void add_follow(CLI::App& program);
void add_strokes(CLI::App& program);
void add_advise(CLI::App& program);
void add_chart(CLI::App& program);
void add_merge(CLI::App& program);
void add_chart_status(CLI::App& program);
void add_report(CLI::App& program);
void add_figure(CLI::App& program);
void add_listen(CLI::App& program);
void add_listen_in(CLI::App& program);
void add_rig(CLI::App& program);
void add_convert(CLI::App& program);
void add_library(CLI::App& program);
void add_analyse(CLI::App& program);
void add_classify(CLI::App& program);
void add_evaluate(CLI::App& program);
void add_compare(CLI::App& program);
void add_match(CLI::App& program);
void add_structure(CLI::App& program);
void add_explore(CLI::App& program);
void add_page(CLI::App& program);
void add_verify(CLI::App& program);
void add_manual(CLI::App& program);
void add_completion(CLI::App& program);

/// All commands, in the order in which the help lists them.
inline constexpr std::array add_commands{
    add_init,    add_check,     add_simulate,     add_stability, add_follow,    add_strokes,  add_advise,
    add_chart,   add_merge,     add_chart_status, add_report,    add_figure,    add_listen,   add_rig,
    add_convert, add_library,   add_analyse,      add_classify,  add_listen_in, add_evaluate, add_compare,
    add_match,   add_structure, add_explore,      add_page,      add_verify,    add_manual,   add_completion};

/// The options of every command that reads a case.
struct CaseOptions {
    std::string file;                    // "-" is stdin
    std::vector<std::string> overrides;  // "section.key=value"
};

/// Adds the file and `--set`.
void add_case_options(CLI::App& command, CaseOptions& options);

/// Adds `--no-early`, short for --set run.early_ending=never.
void add_no_early_option(CLI::App& command, CaseOptions& options);

/// The motions by which a command judges a design; empty: all.
struct RunsOptions {
    std::vector<std::string> directions;  // "going"
    std::vector<std::string> starts;      // "rest"
};

/// Adds `--direction` and `--start`.
void add_runs_options(CLI::App& command, RunsOptions& options);

/// Loads a case or chart file with its overrides, and says on stderr which of its keys have no meaning for its case.
io::TomlSource load_source(const std::string& path, std::vector<std::string> overrides = {});

/// Reads the case that the options name.
parameters::Case load_case(const CaseOptions& options);

}  // namespace stridor::app
