#include "stridor/noise_library/field.hpp"

#include "stridor/noise_library/query.hpp"
#include "support/error_text.hpp"
#include "support/property.hpp"

#include <cmath>
#include <set>

namespace stridor::noise_library {
namespace {

using support::thrown_by;

Entry with(std::string_view field, std::string_view text) {
    Entry entry;
    set_from_text(entry, *find_field(field), text);
    return entry;
}

std::string refusal(std::string_view field, std::string_view text) {
    return thrown_by([&] { with(field, text); }).message;
}

TEST(NoiseFields, HaveEachANameOfItsOwnAndAnOption) {
    std::set<std::string> options;
    for (const EntryField& field : fields()) {
        EXPECT_EQ(find_field(field.name), &field);
        EXPECT_FALSE(field.sentence.empty());
        options.insert(option_of(field));
    }
    EXPECT_EQ(options.size(), fields().size());
    EXPECT_TRUE(options.contains("--velocity-profile"));
}

TEST(NoiseFields, ReadQuantitiesWithUnits) {
    EXPECT_EQ(with("preload", "20").preload, 20.0);
    EXPECT_EQ(with("preload", "0.02 kN").preload, 20.0);
    EXPECT_EQ(with("velocity", "4 mm/s").velocity, 0.004);
    EXPECT_EQ(with("humidity", "45 %").humidity, 45.0);
    EXPECT_EQ(with("humidity", "45").humidity, 45.0);
}

TEST(NoiseFields, ReadLevelsWithAndWithoutTheirReference) {
    for (const char* text : {"65 dB re 20 uPa", "65 dB", "65dB", "65"})
        EXPECT_EQ(parse_value(text, "dB re 20 uPa"), 65.0) << text;
    EXPECT_THROW(parse_value("65 dB re 1e-9 m/s", "dB re 20 uPa"), Error);
}

TEST(NoiseFields, ReadTemperaturesOnThreeScales) {
    EXPECT_EQ(with("temperature", "-10 degC").temperature, -10.0);
    EXPECT_EQ(with("temperature", "-10 °C").temperature, -10.0);
    EXPECT_EQ(with("temperature", "-10").temperature, -10.0);
    EXPECT_NEAR(with("temperature", "-40 degF").temperature, -40.0, 1e-12);
    EXPECT_NEAR(with("temperature", "293.15 K").temperature, 20.0, 1e-12);
    EXPECT_NE(refusal("temperature", "-300 degC").find("at least -273.15 degC"), std::string::npos);
    EXPECT_NE(refusal("temperature", "20 N").find("expected a temperature"), std::string::npos);
}

TEST(NoiseFields, AreClearedByUnknown) {
    Entry entry = with("preload", "20 N");
    set_from_text(entry, *find_field("preload"), "unknown");
    EXPECT_TRUE(std::isnan(entry.preload));
    entry = with("system", "brake");
    set_from_text(entry, *find_field("system"), "");
    EXPECT_EQ(entry.system, "");
}

TEST(NoiseFields, RefuseWhatMeansNothingAndSayWhy) {
    EXPECT_NE(refusal("preload", "20 mm").find("preload: \"20 mm\" is a length (m)"), std::string::npos);
    EXPECT_NE(refusal("preload", "-1 N").find("at least 0 N"), std::string::npos);
    EXPECT_NE(refusal("humidity", "101").find("between 0 and 100 %"), std::string::npos);
    EXPECT_NE(refusal("recorded", "rigg").find("Did you mean \"rig\"?"), std::string::npos);
    EXPECT_NE(refusal("system", "a\nb").find("control character"), std::string::npos);
    EXPECT_NE(refusal("notes", "a\x1b[31m").find("control character"), std::string::npos);
    EXPECT_EQ(with("notes", "a\nb").notes, "a\nb");
}

TEST(NoiseFields, TakeDatesThatExist) {
    for (const char* good : {"2026", "2026-11", "2026-11-21", "2024-02-29", "2000-02-29"})
        EXPECT_EQ(with("date", good).date, good);
    for (const char* bad : {"21.11.2026", "2026-13", "2026-00-01", "2023-02-29", "1900-02-29", "2026-11-31", "2026-1-1",
                            "2026-11-21T10:00", "26", "-026"})
        EXPECT_NE(refusal("date", bad).find("is no date"), std::string::npos) << bad;
}

TEST(NoiseFigures, AreReadWithAnyUnit) {
    EXPECT_EQ(parse_figure("level=62.5 dB"), (Figure{"level", "dB", 62.5}));
    EXPECT_EQ(parse_figure("risk_number = 7"), (Figure{"risk_number", "1", 7.0}));
    for (const char* bad : {"level", "=3", "Level=3", "level=", "level=dB", "preload=3 N", "id=3", "a b=3"})
        EXPECT_EQ(thrown_by([&] { parse_figure(bad); }).kind, ErrorKind::input) << bad;
}

TEST(NoiseFigures, StandSortedAndOnce) {
    Entry entry;
    for (const char* text : {"level=1 dB", "kurtosis=3", "level=2 dB"})
        set_figure(entry, parse_figure(text));
    ASSERT_EQ(entry.figures.size(), 2U);
    EXPECT_EQ(entry.figures[0].name, "kurtosis");
    EXPECT_EQ(number_of(entry, "level"), 2.0);
    EXPECT_TRUE(std::isnan(number_of(entry, "roughness")));
}

TEST(Digest, ChangesWithEveryFieldAndNotWithTheId) {
    std::set<std::string> digests{digest(Entry{})};
    for (const EntryField& field : fields()) {
        Entry entry;
        if (std::holds_alternative<EntryQuantity>(field.kind))
            quantity_in(entry, field) = 1.0;
        else
            words_in(entry, field) = "1";
        digests.insert(digest(entry));
    }
    Entry figured;
    set_figure(figured, {"level", "dB", 1.0});
    digests.insert(digest(figured));
    EXPECT_EQ(digests.size(), fields().size() + 2);
    Entry numbered;
    numbered.id = 7;
    EXPECT_EQ(digest(numbered), digest(Entry{}));
}

TEST(Conditions, AreReadWithOrWithoutBlanks) {
    const std::vector<Condition> two = parse_conditions("preload>10 N and system = door hinge");
    ASSERT_EQ(two.size(), 2U);
    EXPECT_EQ(two[0].name, "preload");
    EXPECT_EQ(two[0].comparison, Comparison::more);
    EXPECT_EQ(two[0].value, "10 N");
    EXPECT_EQ(two[1].value, "door hinge");
    EXPECT_EQ(parse_conditions("velocity-profile ~ 'to and fro'")[0].name, "velocity_profile");
    EXPECT_EQ(parse_conditions("velocity-profile ~ 'to and fro'")[0].value, "to and fro");
    EXPECT_EQ(parse_conditions("a<=1")[0].comparison, Comparison::at_most);
    EXPECT_EQ(parse_conditions("a==1")[0].value, "1");
}

TEST(Query, TakesALimitOrAll) {
    EXPECT_EQ(parse_limit("20"), 20U);
    EXPECT_EQ(parse_limit("all"), 0U);
    for (const char* text : {"0", "", "-1", "2x", "99999999999999999999"})
        EXPECT_TRUE(support::thrown_by([&] { parse_limit(text); }).says("is no number of entries")) << text;
}

TEST(Conditions, AreRefusedWhereTheyEndTooSoon) {
    for (const char* bad :
         {"", "preload", "preload >", "> 10", "preload > 10 and", "system = \"brake", "a = 'b' c = d"})
        EXPECT_EQ(thrown_by([&] { parse_conditions(bad); }).kind, ErrorKind::input) << bad;
}

}  // namespace
}  // namespace stridor::noise_library
