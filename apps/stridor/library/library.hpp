#pragma once

#include "stridor/base/error.hpp"
#include "stridor/noise_library/add_recordings.hpp"
#include "stridor/noise_library/library.hpp"

#include <map>
#include <string>
#include <vector>

namespace CLI {
class App;
}

/// What the commands of a noise library share.
namespace stridor::app {

/// The library to use.
struct LibraryOption {
    std::string file;  // empty: the user's own
};

void add_library_option(CLI::App& command, LibraryOption& option);

/// The entries to use.
struct SelectionOptions {
    std::vector<std::string> where;
    std::string search;
    std::string sort;  // "-preload" is falling
};

/// Adds `--where` and `--search`.
void add_selection_options(CLI::App& command, SelectionOptions& options);

noise_library::Query query_of(const SelectionOptions& options);

/// A user's values for entries: field name -> text, and figures.
struct EntryOptions {
    std::map<std::string, std::string> fields;
    std::vector<std::string> figures;
    std::string case_file;
};

/// Adds an option per field that users write, `--figure` and `--case`.
void add_entry_options(CLI::App& command, EntryOptions& options);

/// Writes these values into an entry; throws `Error` (input) that names the option.
void apply(const EntryOptions& options, noise_library::Entry& entry);

/// Adds the subcommands that bring entries in and out.
void add_library_add(CLI::App& library);
void add_library_judge(CLI::App& library);
void add_library_starter(CLI::App& library);
void add_library_export(CLI::App& library);
void add_library_import(CLI::App& library);
void add_library_check(CLI::App& library);

}  // namespace stridor::app
