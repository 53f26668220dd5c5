#include "library/library.hpp"
#include "stridor/noise_library/field.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <string>
#include <string_view>

namespace stridor::app {

using noise_library::Entry;
using noise_library::EntryField;

void add_library_option(CLI::App& command, LibraryOption& option) {
    command
        .add_option("--library", option.file,
                    "the library's file (default: stridor/library.sqlite in $XDG_DATA_HOME or ~/.local/share)")
        ->type_name("FILE");
}

void add_selection_options(CLI::App& command, SelectionOptions& options) {
    command
        .add_option("--where", options.where,
                    "only entries that meet this: \"preload > 10 N and system = brake\"; = != < <= > >= ~ (contains), "
                    "repeatable")
        ->type_name("CONDITION")
        ->allow_extra_args(false);
    command.add_option("--search", options.search, "only entries whose text holds all these words")->type_name("WORDS");
}

noise_library::Query query_of(const SelectionOptions& options) {
    return noise_library::parse_query(options.where, options.search, options.sort);
}

void add_entry_options(CLI::App& command, EntryOptions& options) {
    for (const EntryField& field : noise_library::fields()) {
        if (field.writer != noise_library::Writer::user || is_document(field)) continue;
        const std::string_view unit = unit_of(field);
        command
            .add_option_function<std::string>(
                option_of(field),
                [&options, name = std::string(field.name)](const std::string& text) { options.fields[name] = text; },
                std::string(field.sentence) + (unit.empty() ? "" : fmt::format(" [{}]", unit)))
            ->type_name(unit.empty() ? "TEXT" : "VALUE");
    }
    command.add_option("--case", options.case_file, "case file (TOML) that a simulated sound came from")
        ->type_name("FILE");
    command.add_option("--figure", options.figures, "a figure of your own: level=\"62 dB\" (repeatable)")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
}

void apply(const EntryOptions& options, Entry& entry) {
    for (const auto& [name, text] : options.fields)
        noise_library::set_from_text(entry, *noise_library::find_field(name), text);
    if (!options.case_file.empty()) noise_library::set_case(entry, storage::read_file(options.case_file));
    for (const std::string& text : options.figures)
        noise_library::set_figure_from_text(entry, text);
}

}  // namespace stridor::app
