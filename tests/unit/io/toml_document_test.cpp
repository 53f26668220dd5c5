#include "stridor/io/case/toml_document.hpp"

#include "io_support.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <gtest/gtest.h>

#include <variant>

namespace stridor::io {
namespace {

TomlDocument parsed_document(const std::string& text, std::vector<std::string> overrides = {}) {
    return parse_toml({text, "case.toml", std::move(overrides)});
}

std::optional<Error> document_refusal(const std::string& text, std::vector<std::string> overrides = {}) {
    return error_of([&] { parsed_document(text, std::move(overrides)); });
}

TEST(TomlDocument, ListsKeysFromTopToBottomWithTheirPlaces) {
    const TomlDocument document = parsed_document("title = \"t\"\n[plate]\nmass = 1\n[joint]\nmass = 2.5\n");
    std::string keys;
    for (const TomlEntry& entry : document.entries)
        keys += entry.key + " ";
    EXPECT_EQ(keys, "title plate plate.mass joint joint.mass ");
    const TomlEntry* mass = document.find("joint.mass");
    ASSERT_NE(mass, nullptr);
    EXPECT_EQ(std::get<double>(mass->value), 2.5);
    EXPECT_EQ(base::describe(mass->key_place), "case.toml:5:1");
    EXPECT_EQ(base::describe(mass->value_place), "case.toml:5:8");
    EXPECT_EQ(mass->value_place.source_line, "mass = 2.5");
    EXPECT_EQ(document.find("joint.colour"), nullptr);
}

TEST(TomlDocument, LaterOverridesWinOverEarlierOnesAndTheFile) {
    const TomlDocument document = parsed_document("[plate]\nmass = 1\n", {"plate.mass = 2 kg", "plate.mass=\"3 kg\""});
    const TomlEntry* mass = document.find("plate.mass");
    EXPECT_EQ(std::get<std::string>(mass->value), "3 kg");
    EXPECT_EQ(mass->origin, TomlOrigin::override);
    EXPECT_EQ(base::describe(mass->value_place), "--set");
    EXPECT_EQ(mass->value_place.source_line, "plate.mass=\"3 kg\"");
}

TEST(TomlDocument, KnowsTypesThatNoKeyTakes) {
    const TomlDocument document =
        parsed_document("a = true\nb = 1979-05-27\nc = [true]\nd = [\"x\"]\ne = [1, 2.5]\nf = [1, \"x\"]\n");
    EXPECT_EQ(type_name(document.find("a")->value), "a boolean");
    EXPECT_EQ(type_name(document.find("b")->value), "a date or time");
    EXPECT_EQ(type_name(document.find("c")->value), "a list of other things than text or numbers");
    EXPECT_EQ(type_name(document.find("d")->value), "a list");
    EXPECT_EQ(type_name(document.find("e")->value), "a list of numbers");
    EXPECT_EQ(std::get<std::vector<double>>(document.find("e")->value), (std::vector<double>{1.0, 2.5}));
    EXPECT_EQ(type_name(document.find("f")->value), "a list of text and numbers");
}

TEST(TomlDocument, PointsAtWhatIsNotToml) {
    expect_error(document_refusal("[a]\nb = 20 N\n"), "Put a value with a unit in quotes", "case.toml:2:8");
    expect_error(document_refusal("b = 0,5\n"), "Numbers are written with a point", "case.toml:1:6");
    expect_error(document_refusal("b = sinusoidal\n"), "Put text in quotes", "case.toml:1:5");
    expect_error(document_refusal("b = \"open\n"), "the file is not valid TOML", "case.toml:1:10");
    expect_error(document_refusal("[a\n"), "expected ']'", "case.toml:1:3");
    EXPECT_EQ(document_refusal("[a\n")->place()->source_line, "[a");
}

TEST(TomlDocument, PointsAtDuplicates) {
    expect_error(document_refusal("[a]\nmass = 1\nmass = 2\n"), "duplicate key mass (it is set once already)",
                 "case.toml:3:1");
    expect_error(document_refusal("[a]\nb = 1\n[a]\n"), "duplicate section [a]", "case.toml:3:1");
    expect_error(document_refusal("x = { b = 1, b = 2 }\n"), "duplicate key b", "case.toml:1:7");
}

TEST(TomlDocument, RefusesOverridesThatSetNothing) {
    expect_error(document_refusal("", {"contact.preload"}), "\"contact.preload\" sets nothing", "--set");
    expect_error(document_refusal("", {"=5"}), "an override reads section.key=value", "--set");
    expect_error(document_refusal("", {std::string("title=\xff")}), "not UTF-8", "--set");
}

TEST(TomlDocument, SaysOfLatin1InAFileWhatItSaysInAnOverride) {
    const char* const why = "is not UTF-8 text (one of its bytes is of another encoding, such as Latin-1)";
    expect_error(document_refusal("# T\xfcr\na = 1\n"), std::string("the file ") + why, "case.toml:1:3");
    expect_error(document_refusal("", {std::string("title=T\xfcr")}), std::string("an override ") + why, "--set");
}

TEST(TomlDocument, RefusesTextThatWouldOverflowTheStack) {
    const auto nested = [](int depth) {
        std::string keys;
        for (int k = 0; k < depth; ++k)
            keys += "a.";
        return keys + "a = 1\n";
    };
    expect_error(document_refusal(nested(100000)), "this is no case file", "case.toml");
    expect_error(document_refusal(nested(65)), "in each other more than 64 deep", "case.toml");
    EXPECT_EQ(parsed_document(nested(64)).entries.back().key, "a.a.a.a.a") << "the deepest that is parsed at all";
    const auto bracketed = [](std::size_t depth) {
        return "a = " + std::string(depth, '[') + std::string(depth, ']') + "\n";
    };
    expect_error(document_refusal(bracketed(65)), "in each other more than 64 deep", "case.toml");
    EXPECT_EQ(parsed_document(bracketed(64)).entries.size(), 1U);
    expect_error(document_refusal("# " + std::string(17U << 20U, 'x') + "\n"), "this is no case file", "case.toml");
}

std::string repeated(std::size_t times, const std::string& text) {
    std::string all;
    for (std::size_t k = 0; k < times; ++k)
        all += text;
    return all;
}

// the resolved file of a part holds its matrices; each point of a name may open a section, those of numbers do not
TEST(TomlDocument, ReadsMatricesOfManyNumbersAndNoManyNames) {
    EXPECT_EQ(
        parsed_document("a = [" + repeated(200, "[" + repeated(200, "-1.25e-3, ") + "],\n") + "]\n").entries.size(),
        1U);
    for (const std::string& names : {repeated(4001, "1.5 = 2\n"), repeated(4001, "[1.5]\n"),
                                     repeated(2001, "a.b.c = 1\n"), "a = {" + repeated(4001, "1.5=2,") + "}\n"})
        expect_error(document_refusal(names), "points in its names; at most 4000 make sense", "case.toml");
}

TEST(TomlDocument, ReadsByteOrderMarksAndWindowsLineEnds) {
    const TomlDocument document = parsed_document("\xEF\xBB\xBF[plate]\r\nmass = 1\r\n");
    EXPECT_EQ(std::get<double>(document.find("plate.mass")->value), 1.0);
    EXPECT_EQ(document.find("plate.mass")->value_place.source_line, "mass = 1");
}

TEST(TomlDocument, IsNoRecording) {
    const ScratchFolder scratch;
    for (const auto& [name, text] : {std::pair("a.wav", "RIFF"), std::pair("a.csv", "time,acc\n0,1\n"),
                                     std::pair("sound", "RIFF\x24\1\1\1WAVEfmt ")}) {
        const std::string path = (scratch / name).string();
        storage::write_file(path, text);
        expect_error(error_of([&] { load_toml(path); }), "this is a recording, not a case", path);
        expect_error(error_of([&] { load_toml(path); }), "`stridor classify " + path + "` judges it", path);
    }
}

TEST(TomlDocument, LoadsAFileUnderItsOwnName) {
    const ScratchFolder scratch;
    storage::write_file((scratch / "a.toml").string(), "title = \"t\"\n");
    const TomlSource source = load_toml((scratch / "a.toml").string(), {"title=u"});
    EXPECT_EQ(source.name, (scratch / "a.toml").string());
    EXPECT_EQ(source.text, "title = \"t\"\n");
    EXPECT_EQ(source.overrides.size(), 1U);
}

}  // namespace
}  // namespace stridor::io
