#include "stridor/console/command.hpp"

#include <gtest/gtest.h>

namespace stridor::console {
namespace {

// a program with all that can be said of a command
Command some_program() {
    const Argument set{
        .names = {"--set"}, .value = "KEY=VALUE", .sentence = "it's [a] key: \\n `x`", .is_repeated = true};
    const Argument json{.names = {"--json"}, .sentence = "as JSON", .facts = {"not with -o"}};
    const Argument output{.names = {"-o", "--output"}, .value = "FILE", .sentence = ".toml file"};
    const Argument way{.names = {"--way"}, .value = "TEXT", .sentence = "which way", .choices = {"up", "down"}};
    const Argument file{.names = {"file"}, .value = "TEXT", .sentence = "a case", .is_required = true};
    const Argument author{.names = {"--author"}, .value = "TEXT", .sentence = "who"};
    const Argument library{.names = {"--library"}, .value = "FILE", .sentence = "whose"};
    const Argument system{.names = {"--system"}, .value = "TEXT", .sentence = "of the vehicle"};
    const Command simulate{"simulate",
                           "Runs: a case.",
                           "It stops.\nExample:\n  stridor simulate a-b.toml\n  x  1 Hz  one",
                           {file},
                           {set, json, output, way}};
    const Command list{"list", "Lists.", "", {}, {author, system, library}};
    return {"stridor", "Predicts.", "", {}, {}, {simulate, {"library", "Keeps.", "", {}, {}, {list}}}};
}

void expect_parts(const std::string& text, const std::vector<std::string>& parts) {
    for (const std::string& part : parts)
        EXPECT_NE(text.find(part), std::string::npos) << part << "\nis not in\n" << text;
}

// "word: meaning" each, behind what the shell adds
std::string found(const std::vector<std::string>& words) {
    return completion_lines(completions(some_program(), words));
}

TEST(Completion, KnowsCommandsAndSubcommands) {
    EXPECT_EQ(found({}), found({""}));
    EXPECT_EQ(found({""}), "nothing\nsimulate\tRuns: a case.\nlibrary\tKeeps.\nhelp\tPrint the help of a command.\n");
    EXPECT_EQ(found({"sim"}), "nothing\nsimulate\tRuns: a case.\n");
    EXPECT_EQ(found({"library", ""}), "nothing\nlist\tLists.\n");
    EXPECT_EQ(found({"help", "library", "l"}), "nothing\nlist\tLists.\n");
    EXPECT_EQ(found({"nonsense", ""}).find("nothing\n"), 0U);
}

TEST(Completion, KnowsOptionsThatAreNotThereYet) {
    EXPECT_EQ(found({"simulate", "--"}),
              "nothing\n--set\tit's [a] key: \\n `x`\n--json\tas JSON\n--output\t.toml file\n"
              "--way\twhich way\n");
    EXPECT_EQ(found({"simulate", "--json", "--set", "a=1", "--set", "b=2", "--j"}), "nothing\n");
    EXPECT_EQ(found({"simulate", "-o", "a.toml", "--out"}), "nothing\n");
    EXPECT_EQ(found({"simulate", "a.toml", "--set", "a=1", "--s"}), "nothing\n--set\tit's [a] key: \\n `x`\n");
}

TEST(Completion, KnowsWhatTheValueOfAnOptionMayBe) {
    EXPECT_EQ(found({"simulate", "--way", ""}), "nothing\nup\t\ndown\t\n");
    EXPECT_EQ(found({"simulate", "--way=d"}), "nothing\n--way=down\t\n");
    EXPECT_EQ(found({"simulate", "--way", "=", "d"}), "nothing\n--way=down\t\n");  // as bash parts it
    EXPECT_EQ(found({"simulate", "-o", ""}), "files\n");
    EXPECT_EQ(found({"simulate", "--author", ""}), "files\n");  // no such option: a place
    EXPECT_NE(found({"simulate", "--set", "contact.pre"}).find("nothing\ncontact.preload=\t"), std::string::npos);
    EXPECT_NE(found({"library", "list", "--library", "no.sqlite", "--system", ""}).find("brake"), std::string::npos);
    EXPECT_EQ(found({"library", "list", "--library", "no.sqlite", "--author", ""}), "nothing\n");
}

TEST(Completion, TakesFilesForArgumentsByTheirPlace) {
    EXPECT_EQ(found({"simulate", ""}), "files\n");
    EXPECT_EQ(found({"simulate", "a=b"}), "files\n");
    EXPECT_EQ(found({"simulate", "a.toml", ""}), "nothing\n");
    EXPECT_EQ(found({"library", "list", ""}), "nothing\n");
}

TEST(Manual, SaysOfACommandWhatItsHelpSays) {
    const std::string page = manual_page(some_program(), "1.2.3");
    expect_parts(page,
                 {".TH STRIDOR 1 \"\" \"Stridor 1.2.3\" \"User Commands\"\n.SH NAME\nstridor \\- predict ",
                  ".SS simulate \\fIfile\\fP\nRuns: a case.\n",
                  ".TP\n\\fB\\-\\-set\\fP \\fIKEY=VALUE\\fP ...\nit\\(aqs [a] key: \\(rsn \\fBx\\fP\n",
                  ".TP\n\\fB\\-o\\fP, \\fB\\-\\-output\\fP \\fIFILE\\fP\n\\&.toml file\n", "\nas JSON; not with \\-o\n",
                  "\nwhich way; up, down\n",
                  ".PP\nExample:\n.PP\n.RS\n.EX\nstridor simulate a\\-b.toml\n.EE\n.RE\n.TP\n\\fBx 1 Hz\\fP\none\n",
                  ".SS library list\nLists.\n.TP\n\\fB\\-\\-author\\fP", ".SH EXIT STATUS\n"});
}

TEST(Manual, NamesChoicesWhereTheSentenceDoesNot) {
    const Argument way{.names = {"--way"}, .sentence = "up or down", .choices = {"up", "down"}, .facts = {"required"}};
    EXPECT_EQ(full_sentence(way), "up or down; required");
    EXPECT_EQ(full_sentence({.names = {"--way"}, .sentence = "up", .choices = {"up", "down"}}), "up; up, down");
}

}  // namespace
}  // namespace stridor::console
