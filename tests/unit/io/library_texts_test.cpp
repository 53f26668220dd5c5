#include "stridor/io/library/library_texts.hpp"

#include "stridor/noise_library/field.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

// Entries of a noise library as JSON and CSV.
namespace stridor::io {
namespace {

using namespace noise_library;

std::vector<Entry> two_entries() {
    Entry first;
    first.id = 4;
    first.system = "door \"hinge\", left";
    first.preload = 0.1;
    first.verdict = "{\"category\": \"creak\", \"margin\": 0.5}";
    set_figure(first, {"level", "dB", 62.5});
    Entry second;
    second.id = 9;
    second.verdict = "no JSON";
    set_figure(second, {"kurtosis", "1", 3.0});
    return {first, second};
}

TEST(LibraryJson, HoldsWhatIsKnownAndNoMore) {
    const auto document = nlohmann::json::parse(library_json("x.sqlite", two_entries()));
    EXPECT_EQ(document["schema"], "stridor.library/1");
    const auto& first = document["entries"][0];
    EXPECT_EQ(first["preload"], 0.1);
    EXPECT_EQ(first["figures"]["level"], 62.5);
    EXPECT_EQ(first["verdict"]["margin"], 0.5);
    EXPECT_FALSE(first.contains("temperature"));
    EXPECT_EQ(document["entries"][1]["verdict"], "no JSON");
    EXPECT_EQ(document["units"]["preload"], "N");
    EXPECT_EQ(document["units"]["figures.level"], "dB");
}

TEST(LibraryCsv, HasAColumnPerFieldAndFigure) {
    const std::string text = library_csv(two_entries());
    EXPECT_TRUE(text.starts_with("# schema: stridor.library/1 | version: ")) << text;
    EXPECT_NE(text.find("\nid,system,parts"), std::string::npos);
    EXPECT_NE(text.find(",category,kurtosis,level [dB]\n"), std::string::npos);
    EXPECT_NE(text.find("\n4,\"door \"\"hinge\"\", left\","), std::string::npos);
    EXPECT_NE(text.find(",,62.5\n"), std::string::npos);
    EXPECT_EQ(text.find("margin"), std::string::npos);
}

TEST(SensitivityJson, HoldsRecordsBinsAndCorrelations) {
    std::vector<Entry> entries = two_entries();
    entries[1].preload = 3.0;
    const auto document = nlohmann::json::parse(sensitivity_json("x.sqlite", sensitivity(entries, {})));
    EXPECT_EQ(document["schema"], "stridor.sensitivity/1");
    EXPECT_EQ(document["over"], "preload");
    EXPECT_EQ(document["records"][1]["preload"], 3.0);
    EXPECT_TRUE(document["records"][1]["level"].is_null());
    EXPECT_EQ(document["bins"].size(), 2U);
    EXPECT_EQ(document["level"]["records"], 1);
    EXPECT_TRUE(document["level"]["spearman"].is_null());
}

}  // namespace
}  // namespace stridor::io
