#include "stridor/parameters/fields/field.hpp"

#include "stridor/parameters/own_structure.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "support/error_text.hpp"
#include "support/property.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace stridor::parameters {
namespace {

using support::Thrown;
using support::thrown_by;

const Field& field(std::string_view key) {
    const Field* found = find_field(key);
    EXPECT_NE(found, nullptr) << key;
    return *found;
}

Thrown refusal(std::string_view key, std::string_view text) {
    const Thrown thrown = thrown_by([&] {
        Case c;
        set_from_text(c, field(key), text);
    });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    return thrown;
}

TEST(FieldTable, HasEachKeyOnce) {
    std::set<std::string> keys;
    for (const Field& entry : fields()) {
        EXPECT_TRUE(keys.insert(key_of(entry)).second) << key_of(entry);
        EXPECT_EQ(find_field(key_of(entry)), &entry);
    }
    EXPECT_EQ(find_field("contact.colour"), nullptr);
    EXPECT_EQ(find_field(""), nullptr);
    EXPECT_EQ(find_field("preload"), nullptr);
}

TEST(FieldTable, KeepsSectionsTogether) {
    std::vector<std::string_view> sections;
    for (const Field& entry : fields())
        if (sections.empty() || sections.back() != entry.section) sections.push_back(entry.section);
    EXPECT_EQ(sections, (std::vector<std::string_view>{"", "joint", "plate", "structure", "contact", "temperature",
                                                       "drive", "run", "verdict"}));
}

TEST(FieldTable, SaysWhatEachFieldIs) {
    for (const Field& entry : fields()) {
        EXPECT_FALSE(entry.sentence.empty()) << key_of(entry);
        EXPECT_EQ(key_of(entry), entry.section.empty() ? std::string(entry.name)
                                                       : std::string(entry.section) + "." + std::string(entry.name));
        const auto* quantity = std::get_if<Quantity>(&entry.kind);
        const auto* choice = std::get_if<Choice>(&entry.kind);
        EXPECT_FALSE(quantity != nullptr && quantity->unit.empty()) << key_of(entry);
        EXPECT_FALSE(choice != nullptr && choice->names.empty()) << key_of(entry);
    }
}

// with a structure whose builder takes all that any builder takes
Case with_recipe() {
    Recipe recipe{.builder = "all", .build = [](const Recipe& numbers) {
                      OwnStructure structure;
                      structure.recipe = numbers;
                      return structure;
                  }};
    for (const Field& entry : fields())
        if (is_of_builder(entry)) recipe.numbers[std::string(entry.name)] = 0.5;
    Case c;
    c.own_structure = std::make_shared<const OwnStructure>(recipe.build(recipe));
    return c;
}

TEST(FieldTable, AcceptsEveryDefault) {
    const Case defaults = with_recipe();
    for (const Field& entry : fields()) {
        Case c = defaults;
        if (std::holds_alternative<Quantity>(entry.kind)) {
            EXPECT_NO_THROW(set_quantity(c, entry, get_quantity(defaults, entry))) << key_of(entry);
        } else if (const auto* choice = std::get_if<Choice>(&entry.kind)) {
            EXPECT_LT(static_cast<std::size_t>(choice->get(defaults)), choice->names.size()) << key_of(entry);
        }
    }
}

// each field reads and writes a member of its own: changing one changes the text of no other
TEST(FieldTable, GivesEachFieldItsOwnMember) {
    const Case defaults = with_recipe();
    for (const Field& changed : fields()) {
        Case c = defaults;
        if (std::holds_alternative<Quantity>(changed.kind))
            std::get<Quantity>(changed.kind).set(c, get_quantity(defaults, changed) + 0.125);
        else if (const auto* choice = std::get_if<Choice>(&changed.kind))
            choice->set(c, static_cast<int>(choice->names.size()) - 1);
        else
            std::get<Text>(changed.kind).set(c, "another");
        for (const Field& other : fields()) {
            const bool is_same = value_text(c, other) == value_text(defaults, other);
            const bool has_one_choice =
                std::holds_alternative<Choice>(changed.kind) && std::get<Choice>(changed.kind).names.size() == 1;
            EXPECT_EQ(is_same, &other != &changed || has_one_choice) << key_of(changed) << " and " << key_of(other);
        }
    }
}

TEST(FieldTable, ChoicesRoundTripThroughText) {
    for (const Field& entry : fields()) {
        const auto* choice = std::get_if<Choice>(&entry.kind);
        if (choice == nullptr) continue;
        for (const std::string_view name : choice->names) {
            Case c;
            set_from_text(c, entry, name);
            EXPECT_EQ(value_text(c, entry), name) << key_of(entry);
        }
    }
}

// a value inside the range, closer to its ends than to the middle as often as not
double any_value(const Range& range) {
    const double low = std::max(range.low, -1e6);
    const double high = std::min(range.high, 1e6);
    const double share = *support::whole_between(1, 100000) * 1e-5;
    return share * share * share * (high - low) + low;
}

RC_GTEST_PROP(FieldTable, QuantitiesRoundTripThroughText, ()) {
    for (const Field& entry : fields()) {
        const auto* quantity = std::get_if<Quantity>(&entry.kind);
        if (quantity == nullptr) continue;
        const double value = any_value(quantity->range);
        Case c = with_recipe();
        set_quantity(c, entry, value);
        RC_ASSERT(get_quantity(c, entry) == value);
        Case read = with_recipe();
        set_from_text(read, entry, value_text(c, entry));
        RC_ASSERT(get_quantity(read, entry) == value);
    }
}

TEST(Field, ConvertsUnits) {
    Case c;
    set_from_text(c, field("joint.axial_stiffness"), "8 kN/mm");
    EXPECT_EQ(c.joint().axial_stiffness, 8e6);
    set_from_text(c, field("drive.amplitude"), "4 mm");
    EXPECT_EQ(c.drive.amplitude, 0.004);
    set_from_text(c, field("run.step"), "0.1 us");
    EXPECT_EQ(c.run.step, 1e-7);
    set_from_text(c, field("verdict.quiet_slip"), "95 %");
    EXPECT_EQ(c.verdict.quiet_slip, 0.95);
    set_from_text(c, field("title"), "4 mm");
    EXPECT_EQ(c.title, "4 mm");
}

TEST(Field, RefusesValuesOutOfRange) {
    EXPECT_TRUE(refusal("contact.preload", "0").says("contact.preload = 0 is out of range"));
    EXPECT_TRUE(refusal("contact.preload", "-1 N").says("above 0 N"));
    EXPECT_TRUE(refusal("contact.static_friction", "-0.1").says("at least 0"));
    EXPECT_TRUE(refusal("run.beta_2", "0.4").says("between 0.5 and 1"));
    EXPECT_TRUE(refusal("verdict.least_intervals", "1").says("between 2 and 1000"));
    EXPECT_TRUE(refusal("joint.incidence_angle", "361").says("between -360 and 360 deg"));
    EXPECT_TRUE(refusal("joint.mass", "3 mm").says("expected a mass (kg)"));
    Case c;
    for (const double value : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
        EXPECT_TRUE(thrown_by([&] { set_quantity(c, field("drive.velocity"), value); }).says("must be finite"));
}

TEST(Field, AcceptsClosedEndsOfItsRange) {
    Case c;
    EXPECT_NO_THROW(set_quantity(c, field("run.beta_2"), 0.5));
    EXPECT_NO_THROW(set_quantity(c, field("run.beta_2"), 1.0));
    EXPECT_NO_THROW(set_quantity(c, field("contact.kinetic_friction"), 0.0));
    EXPECT_NO_THROW(set_quantity(c, field("joint.incidence_angle"), -360.0));
}

TEST(Field, SuggestsTheNearestChoiceAndKey) {
    EXPECT_TRUE(refusal("drive.kind", "sinusodial").says("Did you mean \"sinusoidal\"?"));
    EXPECT_TRUE(refusal("drive.kind", "triangular").says("\"sinusoidal\", \"constant\", \"sampled\""));
    EXPECT_EQ(nearest_key("contact.prelaod"), "contact.preload");
    EXPECT_EQ(nearest_key("something.else"), "");
}

TEST(Field, BelongsWhereItMeansSomething) {
    Case c;
    EXPECT_TRUE(field("drive.amplitude").belongs(c));
    EXPECT_FALSE(field("drive.velocity").belongs(c));
    EXPECT_TRUE(field("verdict.settling").belongs(c));
    EXPECT_FALSE(field("run.perturbation").belongs(c));
    c.drive.kind = DriveKind::constant;
    EXPECT_FALSE(field("drive.amplitude").belongs(c));
    EXPECT_FALSE(field("drive.frequency").belongs(c));
    EXPECT_TRUE(field("drive.velocity").belongs(c));
    EXPECT_FALSE(field("verdict.settling").belongs(c));
    c.drive.kind = DriveKind::sampled;
    EXPECT_TRUE(field("drive.file").belongs(c));
    EXPECT_TRUE(field("verdict.reversal").belongs(c));
    EXPECT_FALSE(field("drive.velocity").belongs(c));
    c.run.initial = Initial::sliding;
    EXPECT_TRUE(field("run.perturbation").belongs(c));
}

TEST(Field, SaysWhichChoicesGiveItAMeaning) {
    const Case c;
    EXPECT_EQ(home_of(c, *find_field("drive.velocity")), R"(drive.kind = "constant" or "trapezoidal")");
    EXPECT_EQ(home_of(c, *find_field("drive.file")), R"(drive.kind = "sampled")");
    Case steady;
    steady.drive.kind = DriveKind::constant;
    EXPECT_EQ(home_of(steady, *find_field("verdict.settling")),
              R"(drive.kind = "sinusoidal", "sampled" or "trapezoidal")");
    EXPECT_EQ(home_of(c, *find_field("temperature.value")), "");
    const std::vector<Home> homes = homes_of(c, *find_field("contact.restitution"));
    ASSERT_EQ(homes.size(), 1U);
    EXPECT_EQ(homes.front().choice, find_field("contact.impact"));
    EXPECT_EQ(homes.front().name, "restitution");
}

TEST(UsualRange, LiesWithinWhatTheFieldAllows) {
    for (const Field& entry : fields()) {
        const auto* quantity = std::get_if<Quantity>(&entry.kind);
        if (quantity == nullptr || !quantity->usual) continue;
        Case c;
        EXPECT_NO_THROW(set_quantity(c, entry, quantity->usual->from)) << key_of(entry);
        EXPECT_NO_THROW(set_quantity(c, entry, quantity->usual->to)) << key_of(entry);
        EXPECT_LT(quantity->usual->from, quantity->usual->to) << key_of(entry);
        EXPECT_TRUE(quantity->usual->scale == Scale::linear || quantity->usual->from > 0.0) << key_of(entry);
    }
}

TEST(UsualRange, HoldsTheFourCasesOfTable1) {
    for (const PaperCase which : {PaperCase::squeal, PaperCase::squeak, PaperCase::creak, PaperCase::quiet})
        for (const Field& entry : fields()) {
            const auto* quantity = std::get_if<Quantity>(&entry.kind);
            if (quantity == nullptr || !quantity->usual || entry.name.ends_with("_cubic")) continue;  // it has none
            const double value = get_quantity(paper_case(which), entry);
            EXPECT_GE(value, quantity->usual->from) << key_of(entry);
            EXPECT_LE(value, quantity->usual->to) << key_of(entry);
        }
}

TEST(UsualRange, BelongsToWhatADesignerVariesAndToNothingElse) {
    for (const Field& entry : fields()) {
        const auto* quantity = std::get_if<Quantity>(&entry.kind);
        if (quantity == nullptr) continue;
        // the temperature is what a design has to bear
        const bool is_setting = entry.section == "run" || entry.section == "verdict" || entry.section == "temperature";
        // a chain or a string may be of any size, and where a motion begins is no part of a design
        EXPECT_EQ(quantity->usual.has_value(), !is_setting && !is_of_builder(entry) && !is_of_start(entry))
            << key_of(entry);
    }
}

TEST(QuantityKeys, AreTheFieldsThatCanBeAnAxis) {
    const std::vector<std::string> keys = quantity_keys();
    EXPECT_NE(std::find(keys.begin(), keys.end(), "contact.preload"), keys.end());
    EXPECT_EQ(std::find(keys.begin(), keys.end(), "drive.kind"), keys.end());
    EXPECT_EQ(std::find(keys.begin(), keys.end(), "title"), keys.end());
}

TEST(CanonicalText, NamesWhatChangesAResultAndNothingElse) {
    const Case c;
    Case other = c;
    other.title = "another title";
    other.drive.velocity = 99.0;  // means nothing for a sinusoidal drive
    EXPECT_EQ(canonical_text(other), canonical_text(c));
    other.contact().preload = 21.0;
    EXPECT_NE(canonical_text(other), canonical_text(c));
    EXPECT_NE(canonical_text(c).find("contact.preload = 20 N\n"), std::string::npos);
    EXPECT_EQ(canonical_text(c).find("drive.velocity"), std::string::npos);
}

TEST(CanonicalText, NamesASampledDriveByItsSamples) {
    Case c;
    c.drive.kind = DriveKind::sampled;
    c.drive.file = "here.csv";
    c.drive.times = {0.0, 1.0};
    c.drive.velocities = {0.1, 0.2};
    Case moved = c;
    moved.drive.file = "there.csv";
    EXPECT_EQ(canonical_text(moved), canonical_text(c));
    moved.drive.velocities[1] = 0.25;
    EXPECT_NE(canonical_text(moved), canonical_text(c));
}

// a law that came later goes without saying: stores of before keep their study
TEST(CanonicalText, OfACaseWithCoulombsLawDoesNotNameIt) {
    Case c;
    EXPECT_EQ(canonical_text(c).find("contact.friction"), std::string::npos);
    c.contact().friction = FrictionKind::directional;
    EXPECT_NE(canonical_text(c).find("contact.friction = directional\n"), std::string::npos);
    EXPECT_NE(canonical_text(c).find("contact.kinetic_friction_coming = 0.6\n"), std::string::npos);
}

}  // namespace
}  // namespace stridor::parameters
