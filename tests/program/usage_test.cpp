// The program as a new user meets it: its help, its names, and what it answers to slips of the keyboard.

#include "support/json_of.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using nlohmann::json;
using stridor::support::Finished;
using stridor::support::json_of;
using stridor::support::Launch;
using stridor::support::read_text;
using stridor::support::run;
using stridor::support::ScratchFolder;
using stridor::support::write_text;

namespace {

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

// the names below "Subcommands:" in a help
std::vector<std::string> commands_in(const std::string& help) {
    std::vector<std::string> names;
    std::istringstream lines(help);
    bool is_list = false;
    for (std::string line; std::getline(lines, line);) {
        if (is_list && line.empty()) break;
        if (is_list && line.starts_with("  ") && line[2] != ' ') names.push_back(line.substr(2, line.find(' ', 2) - 2));
        if (line == "Subcommands:") is_list = true;
    }
    return names;
}

// every command with its subcommands: {"init"}, {"library", "add"}
std::vector<std::vector<std::string>> all_commands() {
    std::vector<std::vector<std::string>> commands;
    for (const std::string& name : commands_in(run({"--help"}).out)) {
        const std::vector<std::string> inner = commands_in(run({name, "--help"}).out);
        if (inner.empty()) commands.push_back({name});
        for (const std::string& each : inner)
            commands.push_back({name, each});
    }
    return commands;
}

bool is_of_name(char c) {
    return c == '-' || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
}

// "--set", "--over": every long option that a text names, in its order
std::vector<std::string> options_named_in(const std::string& text) {
    std::vector<std::string> options;
    for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--", at)) {
        const std::size_t begin = at;
        at += 2;
        const bool is_option = (begin == 0 || !is_of_name(text[begin - 1])) && text[at] >= 'a' && text[at] <= 'z';
        while (is_of_name(text[at]))
            ++at;
        if (is_option) options.push_back(text.substr(begin, at - begin));
    }
    return options;
}

// those that a command takes, but --help
std::vector<std::string> options_of(std::vector<std::string> command) {
    command.emplace_back("--help");
    std::istringstream lines(run(command).out);
    std::vector<std::string> options;
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("  -")) continue;
        for (const std::string& option : options_named_in(line.substr(0, line.find("  ", 2))))
            if (option != "--help") options.push_back(option);
    }
    return options;
}

std::string words(const std::vector<std::string>& command) {
    return command.size() == 1 ? "stridor " + command[0] : command[0] + " " + command[1];
}

// the manual page without what makes words bold and signs plain
std::string manual() {
    std::string page = run({"manual"}).out;
    for (const std::string escape : {"\\fB", "\\fI", "\\fP", "\\fR", "\\"})
        for (std::size_t at = page.find(escape); at != std::string::npos; at = page.find(escape, at))
            page.erase(at, escape.size());
    return page;
}

// what the manual says of a command; empty: nothing
std::string section_on(const std::string& manual, const std::vector<std::string>& command) {
    const std::string title = "\n.SS " + command[0] + (command.size() > 1 ? " " + command[1] : "");
    for (std::size_t at = manual.find(title); at != std::string::npos; at = manual.find(title, at + 1))
        if (const char next = manual[at + title.size()]; next == '\n' || next == ' ')
            return manual.substr(at, manual.find("\n.S", at + 1) - at);
    return "";
}

bool is_among(const std::vector<std::string>& options, const std::string& option) {
    return std::find(options.begin(), options.end(), option) != options.end();
}

// how much stands below the line that names an option [1]
std::size_t length_of_sentence(const std::string& section, const std::string& option) {
    for (std::size_t at = section.find("\n.TP\n"); at != std::string::npos; at = section.find("\n.TP\n", at + 1)) {
        std::istringstream lines(section.substr(at + 5));
        std::string names;
        std::string sentence;
        std::getline(lines, names);
        std::getline(lines, sentence);
        if (is_among(options_named_in(names), option)) return sentence.starts_with('.') ? 0 : sentence.size();
    }
    return 0;
}

void expect_answer(const std::vector<std::string>& arguments, const std::string& answer) {
    const Finished finished = run(arguments);
    EXPECT_EQ(finished.exit_code, 2) << finished.err;
    EXPECT_EQ(finished.out, "");
    EXPECT_TRUE(contains(finished.err, answer)) << "\"" << answer << "\" is not in:\n" << finished.err;
}

std::size_t longest_prose_line(const std::string& help) {
    std::size_t longest = 0;
    std::istringstream lines(help);
    for (std::string line; std::getline(lines, line);)
        if (!line.starts_with("  stridor ")) longest = std::max(longest, line.size());
    return longest;
}

}  // namespace

TEST(Usage, ThereAreCommandsAndSubcommands) {
    const auto commands = all_commands();
    EXPECT_GT(commands.size(), 25U);
    EXPECT_NE(std::find(commands.begin(), commands.end(), std::vector<std::string>{"library", "judge"}),
              commands.end());
}

TEST(Usage, ManualGuideAndCompletionNameEveryCommand) {
    const std::string page = manual();
    const std::string guide = read_text(STRIDOR_SOURCE_DIR "/docs/guide/commands.md");
    for (const std::vector<std::string>& command : all_commands()) {
        EXPECT_NE(section_on(page, command), "") << "the manual lacks " << words(command);
        EXPECT_TRUE(contains(guide, words(command))) << "docs/guide/commands.md lacks " << words(command);
        std::vector<std::string> typed{"completion", "bash", "--"};
        typed.insert(typed.end(), command.begin(), command.end());
        EXPECT_TRUE(contains(run(typed).out, "\n" + command.back() + "\t"))
            << "the completion lacks " << words(command);
    }
}

TEST(Usage, TheManualHasASentenceOnEveryOptionOfACommand) {
    const std::string page = manual();
    for (const std::vector<std::string>& command : all_commands())
        for (const std::string& option : options_of(command))
            EXPECT_GT(length_of_sentence(section_on(page, command), option), 5U)
                << "the manual says nothing of " << words(command) << " " << option;
}

// a line that begins with a dot is a request, and none is misspelt
TEST(Usage, TheManualIsMadeOfKnownRequests) {
    const std::vector<std::string> known{".TH", ".SH", ".SS", ".TP", ".PP", ".RS", ".RE", ".EX",
                                         ".EE", ".B",  ".I",  ".BR", ".IR", ".RI", ".br"};
    std::istringstream lines(run({"manual"}).out);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_FALSE(line.empty());
        EXPECT_FALSE(line.starts_with('\'')) << line;
        EXPECT_TRUE(!line.starts_with('.') || is_among(known, line.substr(0, line.find(' ')))) << line;
        EXPECT_EQ(line.find("\t"), std::string::npos) << line;
    }
}

// STRIDOR_UPDATE_GUIDE=1 writes the table anew
TEST(Usage, TheGuideListsTheOptionsOfEveryCommand) {
    std::string table = "| command | options |\n| --- | --- |\n";
    for (const std::vector<std::string>& command : all_commands()) {
        std::string options;
        for (const std::string& option : options_of(command))
            options += (options.empty() ? "`" : ", `") + option + "`";
        table += "| `" + command[0] + (command.size() > 1 ? " " + command[1] : "") + "` | " +
                 (options.empty() ? "none" : options) + " |\n";
    }
    const std::string page = STRIDOR_SOURCE_DIR "/docs/guide/commands.md";
    const std::string guide = read_text(page);
    if (std::getenv("STRIDOR_UPDATE_GUIDE") != nullptr)
        write_text(page, guide.substr(0, guide.find(table.substr(0, table.find('\n')))) + table);
    EXPECT_TRUE(read_text(page).ends_with("\n\n" + table)) << page << " must end with\n\n" << table;
}

TEST(Usage, ManualAndGuideNameNoOptionThatNoCommandHas) {
    std::vector<std::string> known{"--help", "--version", "--array"};  // the last is one of sbatch
    for (const std::vector<std::string>& command : all_commands())
        for (const std::string& option : options_of(command))
            known.push_back(option);
    for (const std::string& page : {manual(), read_text(STRIDOR_SOURCE_DIR "/docs/guide/commands.md")})
        for (const std::string& option : options_named_in(page))
            EXPECT_TRUE(is_among(known, option)) << option;
}

TEST(Usage, ACompletionIsTheScriptThatIsInstalled) {
    for (const std::string shell : {"bash", "zsh", "fish"})
        EXPECT_EQ(run({"completion", shell}).out, read_text(STRIDOR_SOURCE_DIR "/completions/stridor." + shell));
}

TEST(Usage, HelpOfEveryCommandFitsItsColumns) {
    for (const std::vector<std::string>& command : all_commands()) {
        std::vector<std::string> arguments = command;
        arguments.emplace_back("--help");
        const Finished finished = run(arguments);
        EXPECT_EQ(finished.exit_code, 0) << words(command);
        EXPECT_LE(longest_prose_line(finished.out), 80U) << finished.out;
    }
}

TEST(Usage, AMisspeltCommandOrOptionIsAnsweredWithTheOneThatWasMeant) {
    expect_answer({"simualte", "x.toml"}, "Did you mean simulate?");
    expect_answer({"library", "lst"}, "Did you mean list?");
    expect_answer({"figure", "papr"}, "Did you mean paper?");
    expect_answer({"rig", "frictoin"}, "Did you mean friction?");
    expect_answer({"stability", "x.toml", "--ovr", "mu_d=0:1"}, "Did you mean --over?");
    expect_answer({"run", "x.toml"}, "Did you mean simulate?");
    expect_answer({"init", "seal"}, "did you mean weatherstrip?");
    expect_answer({"x.toml"}, "Did you mean `stridor simulate x.toml`?");
    expect_answer({"door.wav"}, "Did you mean `stridor classify door.wav`?");
    expect_answer({"simulate", "x.toml", "--set", "velocity", "-1"}, "Write --set velocity=-1.");
    expect_answer({"simulate", "x.toml", "--set", "velocity", "2"}, "Write --set velocity=2.");
    expect_answer({"library"}, "`stridor library` needs a command");
    expect_answer({"unheard"}, "`stridor --help` lists the commands");
    expect_answer({"check", "a.toml", "b.toml"}, "takes no \"b.toml\"");
}

TEST(Usage, ACaseInThePlaceOfARecordingIsToldWhatToDoWithIt) {
    const ScratchFolder folder;
    write_text(folder / "seal.toml", run({"init", "squeal"}).out);
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"classify", "seal.toml"}, {"analyse", "seal.toml"}}) {
        const Finished finished = run(arguments, folder.path());
        EXPECT_EQ(finished.exit_code, 2) << words(arguments);
        EXPECT_TRUE(contains(finished.err, "`stridor simulate seal.toml`")) << finished.err;
    }
}

// before anything is computed
TEST(Usage, AFolderThatIsNotThereIsToldAtOnce) {
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"simulate", "not-there.toml", "--trace", "no/trace.csv"},
                                               {"simulate", "not-there.toml", "--figure", "no/run.png"},
                                               {"report", "not-there.toml", "-o", "no/report.pdf"},
                                               {"listen", "not-there.toml", "-o", "no/sound.wav"},
                                               {"convert", "not-there.wav", "no/b.csv"}}) {
        const Finished finished = run(arguments);
        EXPECT_EQ(finished.exit_code, 5) << words(arguments);
        EXPECT_TRUE(contains(finished.err, "Create the folder \"no\" first.")) << finished.err;
    }
}

// the case is not there: it would be the first to be told if anything were computed
TEST(Usage, APictureOrTableOfAnotherEndingIsToldAtOnce) {
    const std::vector<std::vector<std::string>> commands{{"simulate", "none.toml"},
                                                         {"stability", "none.toml", "--over", "preload=1:2"},
                                                         {"follow", "none.toml", "--over", "preload=1:2"},
                                                         {"strokes", "none.toml", "--strokes", "2", "--duration", "1s"},
                                                         {"analyse", "none.wav"},
                                                         {"rig", "sensitivity"},
                                                         {"verify", "--published"}};
    for (std::vector<std::string> command : commands) {
        command.insert(command.end(), {"--figure", "motion.gif"});
        expect_answer(command, "cannot draw into motion.gif");
    }
    for (const std::size_t writes_table : {1U, 2U, 3U}) {
        std::vector<std::string> command = commands[writes_table];
        command.insert(command.end(), {"--csv", "table.txt"});
        expect_answer(command, "--csv table.txt has an ending that says nothing");
    }
}

TEST(Usage, EveryDocumentSaysWhereItIsFrom) {
    const ScratchFolder folder;
    const auto done = [&](const std::vector<std::string>& command) {
        const Finished finished = run(command, folder.path());
        EXPECT_EQ(finished.exit_code, 0) << words(command) << ": " << finished.err;
        return finished.out;
    };
    done({"init", "squeal", "-o", "c.toml"});
    done({"init", "noise-chart", "-o", "pair.toml"});
    const std::string chart =
        done({"chart", "pair.toml", "--out", "d", "--set", "chart.x.points=2", "--set", "chart.y.points=2", "--set",
              "run.duration=0.1", "--set", "run.window=0.1", "--json"});
    const std::vector<std::pair<std::string, std::string>> documents{
        {"chart", chart},
        {"chart-status", done({"chart-status", "d", "--json"})},
        {"check", done({"check", "c.toml", "--json"})},
        {"simulation", done({"simulate", "c.toml", "--json"})},
        {"stability", done({"stability", "c.toml", "--json"})},
        {"following", done({"follow", "c.toml", "--over", "preload=10:30:2", "--json"})},
        {"strokes", done({"strokes", "c.toml", "--strokes", "2", "--duration", "1 s", "--wear", "1e-5 mm^3/J", "--area",
                          "20 mm^2", "--interference", "1.5 mm", "--json"})},
    };
    for (const auto& [name, text] : documents) {
        const json document = json_of(text);
        EXPECT_EQ(document["schema"], "stridor." + name + "/1");
        EXPECT_TRUE(document["version"].is_string()) << name;
        EXPECT_TRUE(document["commit"].is_string()) << name;
        const json& c = name == "check" ? document : document["case"];
        if (name != "chart-status") {
            EXPECT_TRUE(c["run"]["engine"].is_string()) << name;
        }
    }
}

TEST(Usage, HelpAndVersionAreWhatOthersHave) {
    EXPECT_EQ(run({"help"}).out, run({"--help"}).out);
    EXPECT_EQ(run({"help", "simulate"}).out, run({"simulate", "--help"}).out);
    EXPECT_EQ(run({"help", "library", "add"}).out, run({"library", "add", "--help"}).out);
    EXPECT_EQ(run({"-v"}).out, run({"--version"}).out);
    EXPECT_TRUE(run({"-v"}).out.starts_with("stridor "));
}

TEST(Usage, NumbersOutOfRangeAreAnsweredWithTheirRange) {
    expect_answer({"explore", "--port", "80000"}, "0 to 65535");
    expect_answer({"convert", "x.csv", "--dataset", "0"}, "1 to 1000000");
}

TEST(Usage, AKeyMayBeShortAndIsShownInFull) {
    const ScratchFolder folder;
    write_text(folder / "squeal.toml", run({"init", "squeal"}).out);
    const auto over = [&](const char* key) {
        return run({"stability", "squeal.toml", "--over", std::string(key) + "=0:0.8:3"}, folder.path()).out;
    };
    EXPECT_TRUE(contains(over("mu_d"), "contact.kinetic_friction"));
    EXPECT_EQ(over("mu_d"), over("contact.kinetic_friction"));
    EXPECT_EQ(over("kinetic_friction"), over("contact.kinetic_friction"));
    const Finished refused = run({"check", "squeal.toml", "--set", "mu_d=much"}, folder.path());
    EXPECT_TRUE(refused.err.starts_with("stridor: error: contact.kinetic_friction = \"much\" is not a number"))
        << refused.err;
    EXPECT_TRUE(contains(refused.err, "    --set mu_d=much\n")) << refused.err;
    const Finished reversed = run({"stability", "squeal.toml", "--over", "mu_d=0.8:0"}, folder.path());
    EXPECT_TRUE(contains(reversed.err, "Swap the ends?")) << reversed.err;
}

TEST(Usage, OutputIsNamedAlikeEverywhere) {
    const ScratchFolder folder;
    EXPECT_EQ(run({"init", "squeal", "--out", "a.toml"}, folder.path()).exit_code, 0);
    EXPECT_EQ(run({"init", "squeal", "-o", "b.toml"}, folder.path()).exit_code, 0);
    EXPECT_EQ(read_text(folder / "a.toml"), read_text(folder / "b.toml"));
    EXPECT_EQ(run({"listen", "a.toml", "--seconds", "0.1", "-o", "a.wav"}, folder.path()).exit_code, 0);
    EXPECT_EQ(run({"listen", "a.toml", "--seconds", "0.1", "--out", "b.wav"}, folder.path()).exit_code, 0);
    EXPECT_EQ(read_text(folder / "a.wav"), read_text(folder / "b.wav"));
}

TEST(Usage, ChannelsHaveNamesAndNumbers) {
    const ScratchFolder folder;
    write_text(folder / "two.csv", "time,left,right\ns,Pa,Pa\n0,1,2\n0.001,3,4\n0.002,5,6\n0.003,7,8\n");
    const auto channel = [&](const char* name) {
        return run({"convert", "two.csv", "--channel", name, "--json"}, folder.path());
    };
    EXPECT_EQ(channel("right").exit_code, 0) << channel("right").err;
    EXPECT_EQ(channel("right").out, channel("2").out);
    EXPECT_TRUE(contains(channel("middle").err, "the recording has 1 \"left\" [Pa], 2 \"right\" [Pa]"));
    EXPECT_EQ(channel("-1").exit_code, 2);
    EXPECT_LT(channel("0").err.size(), 200U) << channel("0").err;
}

TEST(Usage, ATraceHasAnEndingThatSaysItsFormat) {
    const ScratchFolder folder;
    write_text(folder / "squeal.toml", run({"init", "squeal"}).out);
    const Finished refused = run({"simulate", "squeal.toml", "--trace", "x.txt"}, folder.path());
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_TRUE(contains(refused.err, ".csv or .nc")) << refused.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "x.txt"));
}
