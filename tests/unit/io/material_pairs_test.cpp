#include "stridor/io/case/material_pairs.hpp"

#include "io_support.hpp"
#include "stridor/io/case/packed_case.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <gtest/gtest.h>

#include <string>

namespace stridor::io {
namespace {

using parameters::canonical_text;
using parameters::Case;

constexpr const char* pairs_toml = R"([[pair]]
name = "EPDM on glass"
source = "rig 4"
humidity = "30 %"
load = "10 N"
static_friction = 1.0
kinetic_friction = 0.8

[[pair]]
name = "EPDM on glass"
humidity = 0.7
load = 10
static_friction = 0.6
kinetic_friction = 0.4

[[pair]]
name = "PA on steel"
static_friction = 0.4
kinetic_friction = 0.3
)";

// the squeal case whose coefficients are a pair's
std::string pair_case(const std::string& lines = "pair = \"pairs.toml: EPDM on glass\"\nhumidity = \"50 %\"\n") {
    std::string text = replaced(squeal_toml(), "static_friction = 0.8\n", "");
    text = replaced(text, "preload = \"20 N\"", "preload = \"10 N\"");
    return replaced(text, "kinetic_friction = 0.6\n", lines);
}

class MaterialPairs : public testing::Test {
protected:
    void write(const std::string& text) { storage::write_file(folder / "pairs.toml", text); }
    Case read(const std::string& text, std::vector<std::string> overrides = {}) const {
        return read_case(TomlSource{text, (folder / "case.toml").string(), std::move(overrides)});
    }
    std::string refusal(const std::string& text, std::vector<std::string> overrides = {}) const {
        const auto error = error_of([&] { read(text, overrides); });
        EXPECT_TRUE(error.has_value());
        return error ? error->what() : "";
    }
    void SetUp() override { write(pairs_toml); }

    support::ScratchFolder folder;
};

void expect_words(const std::string& text, const std::string& words) {
    EXPECT_NE(text.find(words), std::string::npos) << text;
}

TEST_F(MaterialPairs, GiveACaseItsCoefficients) {
    const Case c = read(pair_case());
    EXPECT_NEAR(c.contact().static_friction, 0.8, 1e-15);
    EXPECT_NEAR(c.contact().kinetic_friction, 0.6, 1e-15);
    EXPECT_EQ(read(pair_case(), {"humidity=70 %"}).contact().kinetic_friction, 0.4);
    EXPECT_EQ(read(pair_case("pair = \"pairs.toml: PA on steel\"\n")).contact().kinetic_friction, 0.3);
}

TEST_F(MaterialPairs, AreKeptWhole) {
    const Case c = read(pair_case());
    const Case again = read_case(TomlSource{case_toml(c), "elsewhere.toml", {}});
    EXPECT_EQ(canonical_text(again), canonical_text(c));
    EXPECT_EQ(again.contact().static_friction, c.contact().static_friction);
    EXPECT_EQ(canonical_text(unpacked_case(packed_case(c))), canonical_text(c));
    expect_words(canonical_text(c), "contact.pair = humidity: 0.3, 0.7; load: 10; static_friction: 1, 0.6");
    EXPECT_EQ(canonical_text(c).find("contact.static_friction"), std::string::npos);
}

TEST_F(MaterialPairs, OfWhichNothingFitsAreRefused) {
    expect_words(refusal(pair_case("pair = \"pairs.toml: EPDM on glas\"\n")), "Did you mean \"EPDM on glass\"?");
    expect_words(refusal(pair_case("pair = \"none.toml: EPDM on glass\"\n")), "cannot read");
    expect_words(refusal(pair_case("pair = \"pairs.toml: EPDM on glass\"\n")), "missing key contact.humidity");
    expect_words(refusal(pair_case("pair = \"pairs.toml: PA on steel\"\nhumidity = 0.5\n")),
                 "contact.humidity means nothing for this case");
    expect_words(refusal(pair_case(), {"preload=20 N"}), "where the rows of contact.pair end");
    expect_words(refusal(pair_case(), {"humidity=90 %"}), "it must be between 0.3 and 0.7");
    expect_words(refusal(pair_case() + "\n", {"mu_s=0.5"}), "it follows from contact.pair");
}

TEST_F(MaterialPairs, WithABadRowAreRefusedAtItsPlace) {
    const auto refused = [&](const char* from, const char* to) {
        write(replaced(pairs_toml, from, to));
        return refusal(pair_case());
    };
    expect_words(refused("static_friction = 1.0", "static_friction = -1.0"), "a coefficient of -1 at");
    expect_words(refused("load = \"10 N\"", "load = \"10 mm\""), "pairs.toml:5:8");
    expect_words(refused("load = \"10 N\"", "lode = \"10 N\""), "Did you mean load?");
    expect_words(refused("humidity = 0.7", "humidity = 0.3"), "the pair has two rows at humidity 0.3, load 10 N");
    expect_words(refused("kinetic_friction = 0.4\n", ""), "this row has no kinetic_friction");
    expect_words(refused("load = 10\n", "load = 20\n"), "the pair has no row at humidity 0.3, load 20 N");
}

TEST_F(MaterialPairs, AreNoFilesToWhoMayNameNone) {
    const std::string text = pair_case();
    const auto error = error_of([&] {
        read_case(parse_toml({text, (folder / "case.toml").string(), {}}), readers_without_files());
    });
    ASSERT_TRUE(error.has_value());
    expect_words(error->what(), "contact.pair names no file here");
}

}  // namespace
}  // namespace stridor::io
