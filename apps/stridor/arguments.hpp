#pragma once

#include "stridor/base/error.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace stridor::pictures {
struct Sheet;
}

/// The words that a user types, before and after CLI11 has parsed them.
namespace stridor::app {

/// Returns the words of a command line in their order; "help COMMAND" becomes "COMMAND --help".
std::vector<std::string> arguments_of(int count, char** words);

/// Throws `Error` (input) for an unknown command or subcommand, and suggests the nearest one.
void check_commands(const CLI::App& program, const std::vector<std::string>& arguments);

/// Says on stderr why a command line cannot be understood, and suggests the nearest option.
void say_usage_error(const CLI::App& program, const CLI::ParseError& error);

/// Returns what `read()` makes of an option's text. An `Error` (input) of it gets the option as its place.
template <typename Read>
auto at_option(const std::string& option, const std::string& text, const Read& read) {
    try {
        return read();
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::input) throw;
        throw Error(error.kind(), error.problem(), base::Place{option, 0, 0, text});
    }
}

/// Returns a validator that allows only these words, and suggests the nearest one for any other.
CLI::Validator one_of(const std::vector<std::string>& names);

/// Adds --threads; 0, the default, means one per processor.
void add_threads_option(CLI::App& command, int& threads);

/// Adds --json, whose document has this schema.
CLI::Option* add_json_option(CLI::App& command, bool& is_json, const std::string& schema,
                             const std::string& what = "print one JSON document");

/// Returns a validator for a file to write: it throws `Error` (io) if its folder does not exist, before a long
/// computation begins.
CLI::Validator in_a_folder();

/// Adds --figure, whose sentence begins with `what`, with --title and --width of the sheet.
/// A file whose folder or ending is wrong is refused before a long computation begins.
CLI::Option* add_figure_option(CLI::App& command, std::string& file, pictures::Sheet& sheet, const std::string& what);

/// Adds --title and --width of the sheet on which a command draws.
void add_sheet_options(CLI::App& command, pictures::Sheet& sheet);

/// Adds --csv for the table that a command writes; a wrong folder or ending is refused before a computation begins.
CLI::Option* add_csv_option(CLI::App& command, std::string& file, const std::string& sentence);

/// Adds -o and --output for the file that a command writes; --out works, too.
CLI::Option* add_output_file(CLI::App& command, std::string& file, const std::string& sentence);

/// Adds --out for the folder that a command fills; -o and --output work, too.
CLI::Option* add_output_folder(CLI::App& command, std::string& folder, const std::string& sentence);

}  // namespace stridor::app
