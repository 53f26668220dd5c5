#include "arguments.hpp"

#include "commands.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/drawing/picture.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/parameters/drive.hpp"
#include "stridor/pictures/picture_files.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "stridor/storage/new_file.hpp"
#include "stridor/sweep/starts.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <string_view>
#include <utility>

namespace stridor::app {

namespace {

std::string path_of(const CLI::App& command) {
    const CLI::App* parent = command.get_parent();
    return (parent == nullptr ? "" : path_of(*parent) + " ") + command.get_name();
}

// what other programs and people call it
constexpr std::array<std::pair<std::string_view, std::string_view>, 16> other_words{{
    {"run", "simulate"},
    {"sim", "simulate"},
    {"solve", "simulate"},
    {"plot", "figure"},
    {"draw", "figure"},
    {"sweep", "chart"},
    {"map", "chart"},
    {"new", "init"},
    {"create", "init"},
    {"play", "listen"},
    {"gui", "explore"},
    {"optimize", "advise"},
    {"seal", "weatherstrip"},
    {"door", "weatherstrip"},
    {"window", "glass-run"},
    {"brake", "brake-pad"},
}};

std::string nearest(const std::string& word, const std::vector<std::string>& names) {
    for (const auto& [other, ours] : other_words)
        if (word == other && std::find(names.begin(), names.end(), ours) != names.end()) return std::string(ours);
    const std::vector<std::string_view> views(names.begin(), names.end());
    return std::string(base::nearest_name(word, views));
}

// the last command of those that were named
const CLI::App& innermost(const CLI::App& program) {
    const CLI::App* command = &program;
    for (std::vector<CLI::App*> named = command->get_subcommands(); !named.empty(); named = command->get_subcommands())
        command = named.front();
    return *command;
}

std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        if (!option->get_group().empty())
            for (const std::string& name : option->get_lnames())
                names.push_back("--" + name);
    return names;
}

// `--set a b` for `--set a=b`
std::string assignment_meant(const CLI::App& command, const std::string& value) {
    const CLI::Option* set = command.get_option_no_throw("--set");
    if (set == nullptr) return "";
    for (const std::string& key : set->results())
        if (key.find('=') == std::string::npos) return "Write --set " + key + "=" + value + ".";
    return "";
}

base::Problem unexpected(const CLI::App& command, const std::vector<std::string>& extras) {
    const auto option = std::find_if(extras.begin(), extras.end(),
                                     [](const std::string& word) { return word.size() > 1 && word.front() == '-'; });
    const std::string see = "See `" + path_of(command) + " --help`.";
    const std::string meant = assignment_meant(command, extras.front());
    if (!meant.empty() || option == extras.end())
        return {"`" + path_of(command) + "` takes no \"" + extras.front() + "\"", "", meant.empty() ? see : meant};
    const std::string word = option->substr(0, option->find('='));
    const std::string near = nearest(word, option_names(command));
    return {"`" + path_of(command) + "` has no option " + word, "",
            near.empty() ? see : "Did you mean " + near + "? " + see};
}

// a file where a command stands
std::string command_of_file(const std::string& word) {
    const std::string ending = std::filesystem::path(word).extension().string();
    if (ending == ".toml") return "simulate";
    for (const std::string_view recording : {".wav", ".flac", ".ogg", ".mp3", ".uff", ".csv", ".mat", ".mf4", ".tdms"})
        if (ending == recording) return "classify";
    return "";
}

std::pair<CLI::Option*, CLI::Option*> sheet_options(CLI::App& command, pictures::Sheet& sheet) {
    const auto set_title = [&sheet](const std::string& text) { sheet.title = text == "none" ? "" : text; };
    const auto set_width = [&sheet](const std::string& text) {
        constexpr double least = 40.0, most = 500.0;  // [mm]
        sheet.width = 1e3 * base::parse_quantity(text, "m");
        if (!(*sheet.width >= least && *sheet.width <= most))
            throw Error(ErrorKind::input, {"--width " + text + " is no width of a picture",
                                           "it lies outside of 40 mm to 500 mm", "For example \"85 mm\"."});
    };
    CLI::Option* title = command.add_option_function<std::string>(
        "--title", set_title, "another title for the picture; none: it gets none, as journals want it");
    CLI::Option* width = command.add_option_function<std::string>(
        "--width", set_width, "width of the picture, \"85 mm\" for a column; letters stay 8 pt");
    return {title->type_name("TEXT"), width->type_name("LENGTH")};
}

}  // namespace

std::vector<std::string> arguments_of(int count, char** words) {
    std::vector<std::string> arguments(words + std::min(count, 1), words + count);
    if (arguments.empty() || arguments.front() != "help") return arguments;
    arguments.erase(arguments.begin());
    arguments.emplace_back("--help");
    return arguments;
}

void check_commands(const CLI::App& program, const std::vector<std::string>& arguments) {
    const CLI::App* command = &program;
    for (const std::string& word : arguments) {
        std::vector<std::string> names;
        for (const CLI::App* each : command->get_subcommands({}))
            names.push_back(each->get_name());
        if (names.empty() || word.starts_with('-')) return;
        if (std::find(names.begin(), names.end(), word) == names.end()) {
            const std::string of_file = command_of_file(word);
            const std::string near = of_file.empty() ? nearest(word, names) : "`stridor " + of_file + " " + word + "`";
            const std::string see = "`" + path_of(*command) + " --help` lists the commands.";
            throw Error(ErrorKind::input, {"there is no command `" + path_of(*command) + " " + word + "`", "",
                                           near.empty() ? see : "Did you mean " + near + "? " + see});
        }
        command = command->get_subcommand(word);
    }
}

void say_usage_error(const CLI::App& program, const CLI::ParseError& error) {
    const CLI::App& command = innermost(program);
    const bool lacks_command = !command.get_subcommands({}).empty();
    base::Problem problem{error.what(), "", "See `" + path_of(command) + " --help`."};
    if (const std::vector<std::string> extras = program.remaining(true); !extras.empty())
        problem = unexpected(command, extras);
    else if (lacks_command)
        problem = {
            "`" + path_of(command) + "` needs a command", "",
            "`" + path_of(command) + " --help` lists them, `" + path_of(command) + " COMMAND --help` their options."};
    console::say_error(Error(ErrorKind::input, problem));
}

CLI::Validator one_of(const std::vector<std::string>& names) {
    const CLI::IsMember member(names);
    const auto complaint = [member, names](std::string& word) -> std::string {
        if (member(word).empty()) return "";
        std::string list;
        for (const std::string& name : names)
            list += (list.empty() ? "" : ", ") + name;
        const std::string near = nearest(word, names);
        return "\"" + word + "\" is none of " + list + (near.empty() ? "" : "; did you mean " + near + "?");
    };
    return {complaint, member.get_description()};
}

void add_threads_option(CLI::App& command, int& threads) {
    command
        .add_option("--threads", threads,
                    "number of threads (default: one per processor); the results do not depend on it")
        ->check(CLI::Range(0, 4096));
}

CLI::Option* add_json_option(CLI::App& command, bool& is_json, const std::string& schema, const std::string& what) {
    return command.add_flag("--json", is_json, what + " (schema " + schema + ")");
}

CLI::Validator in_a_folder() {
    const auto has_folder = [](const std::string& name) -> std::string {
        storage::expect_folder_of(name);
        return "";
    };
    return {has_folder, ""};
}

CLI::Option* add_figure_option(CLI::App& command, std::string& file, pictures::Sheet& sheet, const std::string& what) {
    const auto is_picture = [](const std::string& name) -> std::string {
        drawing::format_of(name);
        return "";
    };
    CLI::Option* figure = command.add_option("--figure", file, what + " to FILE.png, FILE.svg or FILE.pdf")
                              ->type_name("FILE")
                              ->check(in_a_folder())
                              ->check({is_picture, ""});
    const auto [title, width] = sheet_options(command, sheet);
    title->needs(figure);
    width->needs(figure);
    return figure;
}

void add_sheet_options(CLI::App& command, pictures::Sheet& sheet) {
    sheet_options(command, sheet);
}

CLI::Option* add_csv_option(CLI::App& command, std::string& file, const std::string& sentence) {
    const auto is_table = [](const std::string& name) -> std::string {
        storage::expect_ending("--csv", name, {".csv"});
        return "";
    };
    return command.add_option("--csv", file, sentence)->type_name("FILE")->check(in_a_folder())->check({is_table, ""});
}

CLI::Option* add_output_file(CLI::App& command, std::string& file, const std::string& sentence) {
    command.add_option("--out", file)->group("")->check(in_a_folder());
    return command.add_option("-o,--output", file, sentence)->type_name("FILE")->check(in_a_folder());
}

CLI::Option* add_output_folder(CLI::App& command, std::string& folder, const std::string& sentence) {
    command.add_option("-o,--output", folder)->group("");
    return command.add_option("--out", folder, sentence)->type_name("DIR");
}

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
