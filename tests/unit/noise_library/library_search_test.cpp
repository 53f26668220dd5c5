// What is found in a noise library, and in which order.

#include "stridor/noise_library/field.hpp"
#include "stridor/noise_library/library.hpp"
#include "support/counter_random.hpp"
#include "support/error_text.hpp"
#include "unit/noise_library/library_folder.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace stridor::noise_library {
namespace {

using support::CounterRandom;
using support::Thrown;
using support::thrown_by;

std::string lowered(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

// conditions, looked at by code of their own
bool meets(const Entry& entry, const Condition& condition) {
    const EntryField& field = *find_field(condition.name);
    if (std::holds_alternative<EntryQuantity>(field.kind)) {
        const double value = quantity_in(entry, field);
        const double other = parse_value(condition.value, unit_of(field));
        switch (condition.comparison) {
            case Comparison::equal:
                return value == other;
            case Comparison::different:
                return !std::isnan(value) && value != other;
            case Comparison::less:
                return value < other;
            case Comparison::at_most:
                return value <= other;
            case Comparison::more:
                return value > other;
            default:
                return value >= other;
        }
    }
    const std::string words = lowered(words_in(entry, field));
    const std::string other = lowered(condition.value);
    if (condition.comparison == Comparison::equal) return words == other;
    if (condition.comparison == Comparison::different) return !words.empty() && words != other;
    return words.find(other) != std::string::npos;
}

Entry random_entry(CounterRandom& random) {
    const char* const systems[] = {"", "brake", "Brake", "wiper", "door hinge"};
    Entry entry;
    entry.system = systems[random.below(5)];
    entry.materials = random.one_in(3) ? "EPDM / glass" : "";
    if (!random.one_in(4)) entry.preload = static_cast<double>(random.below(5)) * 10.0;
    if (!random.one_in(4)) entry.temperature = static_cast<double>(random.below(7)) * 10.0 - 20.0;
    return entry;
}

Condition random_condition(CounterRandom& random) {
    if (random.one_in(2)) {
        const char* const values[] = {"brake", "WIPER", "r", "hinge"};
        const Comparison comparisons[] = {Comparison::equal, Comparison::different, Comparison::contains};
        return {"system", comparisons[random.below(3)], values[random.below(4)]};
    }
    const bool is_preload = random.one_in(2);
    return {is_preload ? "preload" : "temperature", static_cast<Comparison>(random.below(6)),
            std::to_string(random.below(5) * 10) + (is_preload ? " N" : " degC")};
}

TEST_F(LibraryFile, FindsWhatAnIndependentFilterFinds) {
    CounterRandom random(1);
    Library library = open();
    std::vector<Entry> all;
    for (int k = 0; k < 60; ++k)
        all.push_back(add_bytes(library, sound_, std::to_string(k), random_entry(random)));
    for (int trial = 0; trial < 300; ++trial) {
        Query query;
        for (std::size_t k = random.below(3); k < 3; ++k)
            query.conditions.push_back(random_condition(random));
        std::vector<std::int64_t> expected;
        for (const Entry& entry : all)
            if (std::all_of(query.conditions.begin(), query.conditions.end(),
                            [&](const Condition& condition) { return meets(entry, condition); }))
                expected.push_back(entry.id);
        std::vector<std::int64_t> found;
        for (const Entry& entry : library.find(query))
            found.push_back(entry.id);
        EXPECT_EQ(found, expected);
    }
}

TEST_F(LibraryFile, FindsByFiguresDatesUnknownsAndWords) {
    Library library = open();
    Entry entry = full_entry();
    add_bytes(library, sound_, "one", entry);
    entry.date = "2025-03";
    entry.notes = "Gummi auf Glas";
    entry.figures.clear();
    set_figure(entry, {"level", "dB", 50.0});
    entry.preload = unknown;
    add_bytes(library, sound_, "two", entry);
    const auto ids = [&](const std::string& where, const std::string& search = "") {
        Query query;
        if (!where.empty()) query.conditions = parse_conditions(where);
        query.words = parse_words(search);
        std::string found;
        for (const Entry& each : library.find(query))
            found += std::to_string(each.id);
        return found;
    };
    EXPECT_EQ(ids("level > 60 dB"), "1");
    EXPECT_EQ(ids("level > 40"), "12");
    EXPECT_EQ(ids("kurtosis = unknown"), "2");
    EXPECT_EQ(ids("preload = unknown"), "2");
    EXPECT_EQ(ids("preload != unknown"), "1");
    EXPECT_EQ(ids("date < 2026-01"), "2");
    EXPECT_EQ(ids("id >= 2"), "2");
    EXPECT_EQ(ids("system = unknown"), "");
    EXPECT_EQ(ids("", "glas GUMMI"), "2");
    EXPECT_EQ(ids("", "sound.wav"), "12");
    EXPECT_EQ(ids("system = \"'; DROP TABLE entry; --\""), "");
    EXPECT_EQ(library.size(), 2);
    EXPECT_TRUE(thrown_by([&] { ids("prelaod > 1"); }).says("Did you mean \"preload\"?"));
    EXPECT_TRUE(thrown_by([&] { ids("kurtosi > 1"); }).says("Did you mean \"kurtosis\"?"));
    EXPECT_TRUE(thrown_by([&] { ids("preload > 1 mm"); }).says("preload: \"1 mm\" is a length"));
    EXPECT_TRUE(thrown_by([&] { ids("preload ~ 1"); }).says("is a number"));
    EXPECT_TRUE(thrown_by([&] { ids("system > a"); }).says("words"));
    EXPECT_TRUE(thrown_by([&] { ids("recorded = rgi"); }).says("Did you mean \"rig\"?"));
}

TEST_F(LibraryFile, SortsWithTheUnknownLast) {
    Library library = open();
    for (const double preload : {20.0, unknown, 40.0, 10.0}) {
        Entry entry;
        entry.preload = preload;
        if (preload > 10.0) set_figure(entry, {"level", "dB", -preload});
        add_bytes(library, sound_, std::to_string(preload), entry);
    }
    const auto order = [&](const char* key, SortOrder direction) {
        Query query;
        query.sort = key;
        query.direction = direction;
        std::string ids;
        for (const Entry& entry : library.find(query))
            ids += std::to_string(entry.id);
        return ids;
    };
    EXPECT_EQ(order("preload", SortOrder::rising), "4132");
    EXPECT_EQ(order("preload", SortOrder::falling), "3142");
    EXPECT_EQ(order("level", SortOrder::rising), "3124");
    EXPECT_EQ(order("", SortOrder::falling), "4321");
}

TEST_F(LibraryFile, ReadsSummariesWithoutDocumentsAndFigures) {
    Library library = open();
    add_bytes(library, sound_, "one", full_entry());
    const Entry summary = library.find({}).front();
    EXPECT_EQ(summary.case_text, "");
    EXPECT_TRUE(summary.figures.empty());
    EXPECT_EQ(summary.system, "words of system");
    EXPECT_EQ(library.words("system"), std::vector<std::string>{"words of system"});
    EXPECT_EQ(library.figures().size(), 2U);
}

}  // namespace
}  // namespace stridor::noise_library
