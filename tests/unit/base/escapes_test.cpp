#include "stridor/base/escapes.hpp"

#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

namespace stridor::base {
namespace {

using namespace std::string_literals;

// what bash hands to a program for a word
std::string as_bash_reads(const std::string& word) {
    const support::ScratchFolder folder;
    const std::string script = (folder / "script").string();
    std::ofstream(script) << "printf '%s\\0' " << word;
    std::string read;
    if (std::FILE* pipe = ::popen(("bash '" + script + "' 2>&1").c_str(), "r")) {
        for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
            read += static_cast<char>(c);
        ::pclose(pipe);
    }
    return read;
}

TEST(Visible, ShowsWhatWouldSteerATerminal) {
    EXPECT_EQ(visible("plain ä € 😀\n\ttext"), "plain ä € 😀\n\ttext");
    EXPECT_EQ(visible("\x1b]0;title\x07"), "\\u001b]0;title\\u0007");
    EXPECT_EQ(visible("a\rb\x7f\b"), "a\\u000db\\u007f\\u0008");
    EXPECT_EQ(visible("\0x"s), "\\u0000x");
    EXPECT_EQ(visible("\xc2\x9b"
                      "31m"),
              "\\u009b31m")
        << "CSI as one character";
    EXPECT_EQ(visible("a\xe2\x80\xae"
                      "b\xe2\x81\xa6"),
              "a\\u202eb\\u2066")
        << "order of writing";
    EXPECT_EQ(visible("\x9b\xff\xc3"), "\\x9b\\xff\\xc3") << "no UTF-8";
}

RC_GTEST_PROP(Visible, LeavesNothingBehind, (const std::string& text)) {
    std::string shown = visible(text);
    RC_ASSERT(is_utf8(shown));
    RC_ASSERT(visible(shown) == shown);
    std::erase(shown, '\n');
    std::erase(shown, '\t');
    RC_ASSERT(!has_control(shown));
}

TEST(ShellWord, IsQuotedWhereSomethingIsSpecial) {
    EXPECT_EQ(shell_word("contact.preload=20"), "contact.preload=20");
    EXPECT_EQ(shell_word(""), "''");
    EXPECT_EQ(shell_word("my file's.toml"), "'my file'\\''s.toml'");
    EXPECT_EQ(shell_word("x; rm -rf ~"), "'x; rm -rf ~'");
    EXPECT_EQ(shell_word("=ls"), "'=ls'");
    EXPECT_EQ(shell_word("a\nb'\\"), "$'a\\012b\\'\\\\'");
    EXPECT_EQ(shell_word("\xff"), "$'\\377'");
    EXPECT_EQ(shell_word("größe"), "'größe'");
}

// bash itself is asked: one word, the same bytes
RC_GTEST_PROP(ShellWord, IsOneWordWithTheSameBytesForAShell, ()) {
    const std::vector<std::string> pieces{"a",    " ",  "'", "\"", "$(id)", "`id`",     "\\",   "\n",
                                          "\x1b", "!",  "*", "~",  "=",     "\xc2\x9b", "\xff", "€",
                                          ";",    "\t", "-", "1",  "7",     "{a,b}",    "#"};
    std::string text;
    for (auto left = *rc::gen::inRange(0, 8); left > 0; --left)
        text += pieces[*rc::gen::inRange<std::size_t>(0, pieces.size())];
    const std::string word = shell_word(text);
    RC_ASSERT(!has_control(word));
    RC_ASSERT(is_utf8(word));
    RC_ASSERT(as_bash_reads(word) == text + std::string(1, '\0'));
}

TEST(SpreadsheetText, IsNoFormula) {
    for (const char* text :
         {"=1+1", "+cmd|' /C calc'!A0", "-2+3+cmd", "@SUM(A1)", "\t=1", "\r=1", "\n=1", "-x", "+-1", "-inf", "'=1"})
        EXPECT_EQ(spreadsheet_text(text), "'" + std::string(text));
    for (const char* text : {"", "-", "+", "-0.1257", "+1e-7", "door", "a=b", "'quoted'", "1-2", "mm"})
        EXPECT_EQ(spreadsheet_text(text), text);
}

TEST(SpreadsheetText, HoldsForEveryPieceOfALine) {
    EXPECT_EQ(spreadsheet_line("# title: a,=cmd|' /C calc'!A0; -0.5,\"@x\t +y,-"),
              "# title: a,'=cmd|' /C calc'!A0; -0.5,\"'@x\t '+y,-");
    EXPECT_EQ(spreadsheet_line("# x: contact.preload"), "# x: contact.preload");
}

RC_GTEST_PROP(SpreadsheetText, ReadsBackAsItWas, ()) {
    const auto text = *rc::gen::container<std::string>(rc::gen::elementOf(std::string("'=+-@\t\r\n1.ea")));
    const std::string cell = spreadsheet_text(text);
    RC_ASSERT(from_spreadsheet_text(cell) == text);
}

TEST(MarkupText, HasNoCharacterThatMeansSomethingToHtml) {
    EXPECT_EQ(markup_text("<a href=\"b\">c & d</a> 'e'"), "&lt;a href=&quot;b&quot;&gt;c &amp; d&lt;/a&gt; 'e'");
}

}  // namespace
}  // namespace stridor::base
