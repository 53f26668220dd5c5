#include "library/library.hpp"

#include "commands.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/field_table.hpp"
#include "stridor/console/results/library_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/library/csv_library.hpp"
#include "stridor/io/library/json_library.hpp"
#include "stridor/noise_library/field.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <sstream>

namespace stridor::app {

namespace {

using noise_library::Access;
using noise_library::Entry;
using noise_library::EntryExtent;
using noise_library::Field;
using noise_library::Library;

constexpr const char* usual_columns =
    "id,system,denomination,category,recorded,preload,velocity,temperature,duration,file";

struct ListOptions {
    LibraryOption library;
    SelectionOptions selection;
    std::string columns = usual_columns;
    std::string limit;  // empty: what a screen is good for, everything elsewhere
    bool json = false;
    bool csv = false;
};

std::vector<std::string> parted_at_commas(const std::string& text) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, ',');)
        parts.push_back(part);
    return parts;
}

// no more than the table shows
EntryExtent extent_of(const ListOptions& options) {
    if (options.csv) return EntryExtent::figures;
    EntryExtent extent = EntryExtent::summary;
    for (const std::string& name : parted_at_commas(options.columns)) {
        const Field* field = noise_library::find_field(name);
        if (field != nullptr && is_document(*field)) return EntryExtent::whole;
        if (field == nullptr && name != "id") extent = EntryExtent::figures;
    }
    return extent;
}

constexpr std::size_t screenful = 100;  // rows that a person reads on a terminal

std::size_t limit_of(const ListOptions& options) {
    if (options.limit.empty()) return options.json || options.csv || ::isatty(STDOUT_FILENO) == 0 ? 0 : screenful;
    if (options.limit == "all") return 0;
    std::size_t limit = 0;
    const char* end = options.limit.data() + options.limit.size();
    const auto [stop, problem] = std::from_chars(options.limit.data(), end, limit);
    if (problem != std::errc() || stop != end || limit == 0)
        throw Error(ErrorKind::input,
                    {"--limit " + options.limit + " is no number of entries", "it is a whole number, or all", ""});
    return limit;
}

// in pieces: what is listed may be larger than memory should be
void print_json(Library& library, const noise_library::Query& query) {
    constexpr std::size_t piece = std::size_t{1} << 16U;
    io::LibraryJson document;
    std::string text = document.opening(library.file());
    library.visit(query, [&](const Entry& entry) {
        text += document.entry(entry);
        if (text.size() < piece) return;
        console::print(text);
        text.clear();
    });
    console::print(text + document.closing() + "\n");
}

void list(const ListOptions& options) {
    Library library = open_library(options.library, Access::read);
    noise_library::Query query = query_of(options.selection);
    query.extent = extent_of(options);
    query.limit = limit_of(options);
    if (options.json) return print_json(library, query);
    const std::vector<Entry> entries = library.find(query);
    if (options.csv) return console::print_data(io::library_csv(entries));
    if (entries.empty()) return console::say("no entry meets the conditions");
    console::print(console::entry_table(entries, parted_at_commas(options.columns), library.figures()));
    if (query.limit == 0 || entries.size() < query.limit) return;
    if (const std::int64_t left = library.count(query) - static_cast<std::int64_t>(entries.size()); left > 0)
        console::say(
            fmt::format("... and {} more: --limit all shows them, --where and --search narrow the list", left));
}

struct ShowOptions {
    LibraryOption library;
    std::vector<std::int64_t> ids;
    std::string field;
    bool audio = false;
    bool json = false;
};

std::string shown(const ShowOptions& options, const Library& library, const Entry& entry) {
    if (options.audio) return library.sound_file(entry).string() + "\n";
    if (options.field.empty()) return console::entry_page(library, entry);
    const Field* field = noise_library::find_field(options.field);
    if (field == nullptr)
        throw Error(ErrorKind::input,
                    {"\"" + options.field + "\" is no field", "",
                     base::did_you_mean(options.field, noise_library::field_names([](const Field&) { return true; }),
                                        "`stridor library fields` lists them.")});
    const std::string value = noise_library::value_text(entry, *field);
    return value + (value.ends_with('\n') ? "" : "\n");
}

void show(const ShowOptions& options) {
    Library library = open_library(options.library, Access::read);
    const std::vector<Entry> entries = library.get(options.ids);
    if (options.json) return console::print(io::library_json(library.file(), entries) + "\n");
    std::string text;
    for (const Entry& entry : entries)
        text += (text.empty() || options.audio || !options.field.empty() ? "" : "\n") + shown(options, library, entry);
    options.audio || !options.field.empty() ? console::print_data(text) : console::print(text);
}

struct EditOptions {
    LibraryOption library;
    std::vector<std::int64_t> ids;
    EntryOptions entry;
};

void edit(const EditOptions& options) {
    const EntryOptions& said = options.entry;
    if (said.fields.empty() && said.figures.empty() && said.case_file.empty())
        throw Error(ErrorKind::input, {"there is nothing to change", "no field was named",
                                       "Write, for example, --preload \"40 N\"; --preload unknown clears it."});
    Library library = open_library(options.library, Access::read);
    std::string text;
    for (const Entry& entry : library.edit(options.ids, [&](Entry& each) { apply(said, each); }))
        text += (text.empty() ? "" : "\n") + console::entry_page(library, entry);
    console::print(text);
}

struct RemoveOptions {
    LibraryOption library;
    std::vector<std::int64_t> ids;
};

void remove(const RemoveOptions& options) {
    Library library = open_library(options.library, Access::read);
    const std::vector<Entry> entries = library.get(options.ids);
    library.remove(options.ids);
    for (const Entry& entry : entries)
        console::say(fmt::format("removed {} ({})", entry.id, entry.file));
}

struct WordsOptions {
    LibraryOption library;
    std::string field;
};

std::vector<std::string> words_of(Library& library, const std::string& field) {
    if (field != "id") return library.words(field);
    std::vector<std::string> ids;
    for (const Entry& entry : library.find({}))
        ids.push_back(std::to_string(entry.id));
    return ids;
}

// what is usual, then what this library adds to it; without a library what is usual
void words(const WordsOptions& options) {
    std::vector<std::string> found;
    if (const Field* field = noise_library::find_field(options.field)) {
        if (const auto* text = std::get_if<noise_library::Text>(&field->kind))
            found.assign(text->suggestions.begin(), text->suggestions.end());
        if (const auto* choice = std::get_if<noise_library::Choice>(&field->kind))
            found.assign(choice->names.begin(), choice->names.end());
    }
    try {
        Library library = open_library(options.library, Access::read);
        for (const std::string& word : words_of(library, options.field))
            if (std::find(found.begin(), found.end(), word) == found.end()) found.push_back(word);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::io) throw;
    }
    std::string text;
    for (const std::string& word : found)
        text += word + "\n";
    console::print(text);
}

void fields(const LibraryOption& option) {
    std::vector<noise_library::FigureKind> figures;
    try {
        figures = open_library(option, Access::read).figures();
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::io) throw;  // without a library there are no figures
    }
    console::print(console::fields_text(figures));
}

void add_list(CLI::App& library) {
    auto options = std::make_shared<ListOptions>();
    CLI::App* command = library.add_subcommand("list", "List entries: all, or those that meet conditions.");
    add_library_option(*command, options->library);
    add_selection_options(*command, options->selection);
    command->add_option("--sort", options->selection.sort, "by a field or a figure; -FIELD from the highest")
        ->type_name("FIELD");
    command->add_option("--columns", options->columns, "fields and figures to show, with commas between")
        ->type_name("A,B,...");
    command
        ->add_option("--limit", options->limit, "at most so many, or all (default: 100 on a terminal, all elsewhere)")
        ->type_name("N");
    CLI::Option* json =
        command->add_flag("--json", options->json, "print one JSON document (schema stridor.library/1)");
    command->add_flag("--csv", options->csv, "print CSV: names with units, a row per entry")->excludes(json);
    command->footer(
        "Examples:\n  stridor library list --where \"system = brake and preload > 10 N\" --sort -preload\n"
        "  stridor library list --search rubber --columns id,materials,level\n"
        "  stridor library list --where \"temperature = unknown\"");
    command->callback([options] { list(*options); });
}

void add_show(CLI::App& library) {
    auto options = std::make_shared<ShowOptions>();
    CLI::App* command = library.add_subcommand("show", "Show entries in full.");
    command->add_option("ids", options->ids, "numbers of entries")->required();
    add_library_option(*command, options->library);
    CLI::Option* json =
        command->add_flag("--json", options->json, "print one JSON document (schema stridor.library/1)");
    CLI::Option* field =
        command->add_option("--field", options->field, "print this field alone, as it is")->type_name("NAME");
    command->add_flag("--audio", options->audio, "print the path of the audio alone")->excludes(json)->excludes(field);
    command->footer(
        "Examples:\n  stridor library show 12\n  play \"$(stridor library show 12 --audio)\"\n"
        "  stridor library show 12 --field case > case.toml");
    command->callback([options] { show(*options); });
}

void add_edit(CLI::App& library) {
    auto options = std::make_shared<EditOptions>();
    CLI::App* command = library.add_subcommand("edit", "Change what entries say.");
    command->add_option("ids", options->ids, "numbers of entries; what is said holds for all")->required();
    add_library_option(*command, options->library);
    add_entry_options(*command, options->entry);
    command->footer(
        "\"unknown\" clears a field or a figure.\n"
        "Example:\n  stridor library edit 12 13 --materials \"EPDM, glass\" --humidity unknown");
    command->callback([options] { edit(*options); });
}

void add_remove(CLI::App& library) {
    auto options = std::make_shared<RemoveOptions>();
    CLI::App* command = library.add_subcommand("remove", "Remove entries, and audio that no other entry has.");
    command->add_option("ids", options->ids, "numbers of entries")->required();
    add_library_option(*command, options->library);
    command->footer("Example:\n  stridor library remove 12");
    command->callback([options] { remove(*options); });
}

void add_words(CLI::App& library) {
    auto options = std::make_shared<WordsOptions>();
    CLI::App* command = library.add_subcommand(
        "words", "Print the words of a field, usual ones and those in the library, a line each (for completion).");
    command->add_option("field", options->field, "name of a field, or id")->required();
    add_library_option(*command, options->library);
    command->callback([options] { words(*options); });
}

void add_fields(CLI::App& library) {
    auto option = std::make_shared<LibraryOption>();
    CLI::App* command = library.add_subcommand("fields", "List what an entry can say, with units and figures.");
    add_library_option(*command, *option);
    command->callback([option] { fields(*option); });
}

}  // namespace

void add_library(CLI::App& program) {
    CLI::App* library =
        program.add_subcommand("library", "The noise library: recordings with all that is known of them.");
    library->require_subcommand(1);
    add_library_add(*library);
    add_library_judge(*library);
    add_library_starter(*library);
    add_list(*library);
    add_show(*library);
    add_edit(*library);
    add_remove(*library);
    add_library_export(*library);
    add_library_import(*library);
    add_library_check(*library);
    add_fields(*library);
    add_words(*library);
    library->footer(
        "Examples:\n  stridor library starter\n  stridor library add squeal.wav --system brake --recorded vehicle "
        "--preload \"40 N\"\n"
        "  stridor library list --where \"preload > 10 N\"\n  stridor rig sensitivity --over preload");
}

}  // namespace stridor::app
