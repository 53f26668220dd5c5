#include "library/library.hpp"
#include "stridor/base/error.hpp"
#include "stridor/noise_library/field.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <system_error>

namespace stridor::app {

using noise_library::Entry;
using noise_library::Field;

void add_library_option(CLI::App& command, LibraryOption& option) {
    command
        .add_option("--library", option.file,
                    "the library's file (default: stridor/library.sqlite in $XDG_DATA_HOME or ~/.local/share)")
        ->type_name("FILE");
}

noise_library::Library open_library(const LibraryOption& option, noise_library::Access access) {
    const bool is_own = option.file.empty();
    const std::filesystem::path file = is_own ? noise_library::default_library() : std::filesystem::path(option.file);
    if (is_own && access == noise_library::Access::fill) {
        std::error_code error;
        std::filesystem::create_directories(file.parent_path(), error);
        if (error)
            throw Error(ErrorKind::io, {"cannot make the folder " + file.parent_path().string(), error.message(),
                                        "Name another place with --library FILE."});
    }
    noise_library::LibraryOptions options;
    options.access = access;
    return noise_library::Library(file, options);
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
    noise_library::Query query;
    for (const std::string& text : options.where)
        for (const noise_library::Condition& condition : noise_library::parse_conditions(text))
            query.conditions.push_back(condition);
    query.words = noise_library::parse_words(options.search);
    query.sort = options.sort;
    if (query.sort.starts_with('-')) {
        query.sort.erase(0, 1);
        query.direction = noise_library::SortOrder::falling;
    }
    return query;
}

void add_entry_options(CLI::App& command, EntryOptions& options) {
    for (const Field& field : noise_library::fields()) {
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
    if (!options.case_file.empty()) {
        noise_library::set_from_text(entry, *noise_library::find_field("case"), storage::read_file(options.case_file));
        if (entry.recorded.empty()) entry.recorded = "simulation";
    }
    for (const std::string& text : options.figures)
        if (const std::size_t equals = text.find('='); text.substr(std::min(equals, text.size())) == "=unknown")
            std::erase_if(entry.figures, [&](const auto& figure) { return figure.name == text.substr(0, equals); });
        else
            noise_library::set_figure(entry, noise_library::parse_figure(text));
}

}  // namespace stridor::app
