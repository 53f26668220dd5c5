#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace stridor::pictures {
struct Sheet;
}

/// What a user types, before and after CLI11 has looked at it.
namespace stridor::app {

/// The words of a command line in their order; "help COMMAND" is "COMMAND --help".
std::vector<std::string> arguments_of(int count, char** words);

/// Throws `Error` (input) for a command or subcommand that there is none of, with the one that was meant.
void check_commands(const CLI::App& program, const std::vector<std::string>& arguments);

/// Tells on stderr why a command line cannot be understood, and which option was meant.
void say_usage_error(const CLI::App& program, const CLI::ParseError& error);

/// Lets an option be one of these words; for another it says which one was meant.
CLI::Validator one_of(const std::vector<std::string>& names);

/// Adds --threads; 0, and without it, one per processor.
void add_threads_option(CLI::App& command, int& threads);

/// Adds --json, whose document has this schema.
CLI::Option* add_json_option(CLI::App& command, bool& is_json, const std::string& schema,
                             const std::string& what = "print one JSON document");

/// Accepts a file to write, if its folder is there: that is told before what may take long is computed. Throws `Error`
/// (io) where it is not.
CLI::Validator in_a_folder();

/// Adds --title and --width of the sheet that a command draws on; where `figure` is the option that asks for the
/// picture, they need it.
void add_sheet_options(CLI::App& command, pictures::Sheet& sheet, CLI::Option* figure = nullptr);

/// Adds -o and --output for the file that a command writes; --out is understood, too.
CLI::Option* add_output_file(CLI::App& command, std::string& file, const std::string& sentence);

/// Adds --out for the folder that a command fills; -o and --output are understood, too.
CLI::Option* add_output_folder(CLI::App& command, std::string& folder, const std::string& sentence);

}  // namespace stridor::app
