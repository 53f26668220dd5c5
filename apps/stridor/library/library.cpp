#include "library/library.hpp"

#include "arguments.hpp"
#include "commands.hpp"
#include "interrupt.hpp"
#include "stridor/console/results/library_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/library/library_texts.hpp"
#include "stridor/noise_library/field.hpp"
#include "stridor/noise_library/listing.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <memory>
#include <string_view>

namespace stridor::app {

namespace {

using noise_library::Access;
using noise_library::Entry;
using noise_library::EntryExtent;
using noise_library::Library;

struct ListOptions {
    LibraryOption library;
    SelectionOptions selection;
    std::string columns = noise_library::usual_columns;
    std::string limit;  // empty: what a screen is good for, everything elsewhere
    bool json = false;
    bool csv = false;
};

constexpr std::size_t screenful = 100;  // rows that a person reads on a terminal

std::size_t limit_of(const ListOptions& options) {
    if (options.limit.empty()) return options.json || options.csv || ::isatty(STDOUT_FILENO) == 0 ? 0 : screenful;
    return noise_library::parse_limit(options.limit);
}

void list(const ListOptions& options) {
    Library library = noise_library::open_library(options.library.file, Access::read, waiting());
    noise_library::Query query = query_of(options.selection);
    const std::vector<std::string> columns = noise_library::parse_columns(options.columns);
    query.extent = options.csv ? EntryExtent::figures : noise_library::extent_for(columns);
    query.limit = limit_of(options);
    if (options.json) return io::library_json(library, query, console::print);
    const std::vector<Entry> entries = library.find(query);
    if (options.csv) return console::print_data(io::library_csv(entries));
    if (entries.empty()) return console::say("no entry meets the conditions");
    console::print(console::entry_table(entries, columns, library.figures()));
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
    const std::string value = noise_library::value_text(entry, noise_library::field_named(options.field));
    return value + (value.ends_with('\n') ? "" : "\n");
}

void show(const ShowOptions& options) {
    Library library = noise_library::open_library(options.library.file, Access::read, waiting());
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
    Library library = noise_library::open_library(options.library.file, Access::read, waiting());
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
    Library library = noise_library::open_library(options.library.file, Access::read, waiting());
    const std::vector<Entry> entries = library.get(options.ids);
    library.remove(options.ids);
    for (const Entry& entry : entries)
        console::say(fmt::format("removed {} ({})", entry.id, entry.file));
}

struct WordsOptions {
    LibraryOption library;
    std::string field;
};

void words(const WordsOptions& options) {
    const std::vector<std::string> found = noise_library::words_to_choose(options.library.file, options.field);
    std::string text;
    for (const std::string& word : found)
        text += word + "\n";
    console::print(text);
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
    CLI::Option* json = add_json_option(*command, options->json, "stridor.library/1");
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
    CLI::Option* json = add_json_option(*command, options->json, "stridor.library/1");
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
        "words", "Print the words of a field, usual ones and those in the library, a line each.");
    command->add_option("field", options->field, "name of a field, or id")->type_name("FIELD")->required();
    add_library_option(*command, options->library);
    command->callback([options] { words(*options); });
}

void add_fields(CLI::App& library) {
    auto option = std::make_shared<LibraryOption>();
    CLI::App* command = library.add_subcommand("fields", "List what an entry can say, with units and figures.");
    add_library_option(*command, *option);
    command->callback([option] { console::print(console::fields_text(noise_library::figures_in(option->file))); });
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
