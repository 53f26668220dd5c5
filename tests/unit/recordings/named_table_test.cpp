#include "stridor/recordings/table/named_table.hpp"

#include "support/error_text.hpp"

#include <gtest/gtest.h>

namespace stridor::recordings {
namespace {

NamedTable table_of(const std::string& text) {
    return {bytes_of(text), "t.csv"};
}

TEST(NamedTable, HasItsFieldsByNameInAnyOrderAndCase) {
    for (const char* text :
         {"node,x [mm],Set\n7,1.5,A B\n", "SET;Node;X (mm)\nA B;7;1,5\n", "x/mm\tset\tnode\n1.5\tA B\t7\n"}) {
        NamedTable table = table_of(text);
        ASSERT_TRUE(table.next()) << text;
        EXPECT_EQ(table.text("node"), "7") << text;
        EXPECT_EQ(table.text("set"), "A B") << text;
        EXPECT_EQ(table.number("x"), 1.5) << text;
        EXPECT_EQ(table.number("set"), std::nullopt) << text;
        EXPECT_FALSE(table.has("y"));
        EXPECT_EQ(table.text("y"), "");
        for (const NamedColumn& column : table.columns())
            EXPECT_EQ(column.unit, column.name == "x" ? "mm" : "") << text;
        EXPECT_FALSE(table.next()) << text;
    }
}

// as Excel saves it: a mark in front, CR LF, delimiters behind every line
TEST(NamedTable, ReadsWhatSpreadsheetsWrite) {
    NamedTable table = table_of("\xEF\xBB\xBFname;gap;\r\nfoot;0,25;\r\n\"a; b\";;\r\n");
    EXPECT_EQ(table.columns().size(), 2U);
    ASSERT_TRUE(table.next());
    EXPECT_EQ(table.number("gap"), 0.25);
    ASSERT_TRUE(table.next());
    EXPECT_EQ(table.text("name"), "a; b");
    EXPECT_EQ(table.number("gap"), std::nullopt);
}

TEST(NamedTable, PassesOverEmptyLinesAndRemarks) {
    NamedTable table = table_of("# parts\n\nname,gap\n# the left one\nfoot,1\n\n   \nhand\n");
    ASSERT_TRUE(table.next());
    EXPECT_EQ(table.text("name"), "foot");
    EXPECT_EQ(table.place().line, 5);
    ASSERT_TRUE(table.next());
    EXPECT_EQ(table.text("name"), "hand");
    EXPECT_EQ(table.text("gap"), "") << "a row may end early";
    EXPECT_FALSE(table.next());
}

// 0,5 between commas is two fields, and all behind it would stand in wrong columns
TEST(NamedTable, RefusesARowOfMoreFieldsThanNames) {
    NamedTable table = table_of("name,gap,share\nfoot,0,5,1\n");
    const support::Thrown thrown = support::thrown_by([&] { table.next(); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("t.csv:2:10")) << thrown.message;
    EXPECT_TRUE(thrown.says("the row has 4 fields (the first row names 3 columns)")) << thrown.message;
}

TEST(NamedTable, RefusesWhatNamesNoColumns) {
    const auto refused = [](const std::string& text, const char* sentence) {
        const support::Thrown thrown = support::thrown_by([&] { table_of(text); });
        EXPECT_EQ(thrown.kind, ErrorKind::input);
        EXPECT_TRUE(thrown.says(sentence)) << thrown.message;
    };
    refused("", "the table is empty");
    refused("# only a remark\n", "the table is empty");
    refused("gap,name,Gap\n1,a,2\n", "two columns are called \"Gap\"");
    refused(std::string("\xFF\xFEn\0o\0d\0e\0\n\0", 12), "the table is in UTF-16");
}

}  // namespace
}  // namespace stridor::recordings
