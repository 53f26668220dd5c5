#include "stridor/parameters/tables/material_pair.hpp"

#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/fields/usual_range.hpp"
#include "stridor/parameters/rules/check.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace stridor::parameters {
namespace {

constexpr const char* rubber =
    "temperature: 20, 60; humidity: 0.3, 0.7; load: 10, 30; static_friction: 1.0, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3; "
    "kinetic_friction: 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1";

void set(Case& c, const char* key, const char* text) {
    set_from_text(c, *find_field(key), text);
}

Case of_pair(const char* text) {
    Case c;
    set(c, "contact.pair", text);
    return c;
}

TEST(MaterialPair, IsItsOwnNumberAtAPointOfItsGrid) {
    Case c = of_pair(rubber);
    set(c, "temperature.value", "60 degC");
    set(c, "contact.humidity", "30 %");
    set(c, "contact.preload", "30 N");
    EXPECT_EQ(c.contact().static_friction, 0.5);
    EXPECT_EQ(c.contact().kinetic_friction, 0.3);
}

// linear in each of the three: at the middle of all it is the mean of the eight corners
TEST(MaterialPair, IsLinearInEachBetweenThem) {
    Case c = of_pair(rubber);
    set(c, "temperature.value", "40");
    set(c, "contact.humidity", "0.5");
    set(c, "contact.preload", "20");
    EXPECT_NEAR(c.contact().static_friction, 0.65, 1e-15);
    EXPECT_NEAR(c.contact().kinetic_friction, 0.45, 1e-15);
    set(c, "contact.preload", "15");
    EXPECT_NEAR(c.contact().static_friction, 0.675, 1e-15);
}

TEST(MaterialPair, IsWrittenWholeAndReadBack) {
    const MaterialPair pair = parse_material_pair(rubber);
    const MaterialPair again = parse_material_pair(material_pair_text(pair));
    EXPECT_EQ(again.static_friction, pair.static_friction);
    EXPECT_EQ(again.kinetic_friction, pair.kinetic_friction);
    EXPECT_EQ(again.humidity, pair.humidity);
    EXPECT_EQ(canonical_text(of_pair(material_pair_text(pair).c_str())), canonical_text(of_pair(rubber)));
}

TEST(MaterialPair, KnowsNothingOutsideOfItsRows) {
    Case c = of_pair(rubber);
    const auto refused = [&](const char* key, const char* text) {
        return support::thrown_by([&] { set(c, key, text); });
    };
    EXPECT_TRUE(
        refused("contact.preload", "31 N").says("it must be between 10 and 30 N, where the rows of contact.pair end"));
    EXPECT_TRUE(refused("temperature.value", "19 degC").says("it must be between 20 and 60 degC"));
    EXPECT_TRUE(refused("contact.humidity", "80 %").says("it must be between 0.3 and 0.7"));
    EXPECT_TRUE(refused("contact.static_friction", "0.5").says("it follows from contact.pair"));
    EXPECT_EQ(usual_range(c, "temperature.value")->to, 60.0);
    EXPECT_EQ(usual_range(c, "contact.static_friction"), std::nullopt);
    c.contact().preload = 40.0;
    const std::vector<Finding> found = findings(c);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].key, "contact.preload");
}

TEST(MaterialPair, AsksOnlyForWhatItDependsOn) {
    const Case c = of_pair("load: 10, 30; static_friction: 1, 0.9; kinetic_friction: 0.8, 0.7");
    EXPECT_FALSE(find_field("temperature.value")->belongs(c));
    EXPECT_FALSE(find_field("contact.humidity")->belongs(c));
    EXPECT_TRUE(find_field("contact.humidity")->belongs(of_pair(rubber)));
    EXPECT_FALSE(find_field("contact.pair")->belongs(Case()));
}

TEST(MaterialPair, ThatIsNoGridIsRefused) {
    const auto refused = [](const char* text) { return support::thrown_by([&] { parse_material_pair(text); }); };
    EXPECT_TRUE(
        refused("load: 10, 10; static_friction: 1, 1; kinetic_friction: 1, 1").says("load of the pair does not rise"));
    EXPECT_TRUE(
        refused("load: 10, 30; static_friction: 1; kinetic_friction: 1, 1").says("1 values of static_friction"));
    EXPECT_TRUE(refused("static_friction: -1; kinetic_friction: -1").says("a coefficient of -1"));
    EXPECT_TRUE(refused("static_friction: 0.5; kinetic_friction: 0.6").says("mu_d = 0.6 above mu_s = 0.5"));
    EXPECT_TRUE(refused("pressure: 5; static_friction: 1; kinetic_friction: 1").says("is no part of a pair"));
    EXPECT_TRUE(refused("load: 1 mm; static_friction: 1; kinetic_friction: 1").says("1 mm"));
    EXPECT_TRUE(support::thrown_by([] { named_pair("rubber"); }).says("names no pair of materials"));
}

TEST(MaterialPair, OfRowsIsAFullPlan) {
    const std::vector<PairRow> rows{
        {20.0, {}, 30.0, 0.9, 0.7}, {20.0, {}, 10.0, 1.0, 0.8}, {60.0, {}, 10.0, 0.6, 0.4}, {60.0, {}, 30.0, 0.5, 0.3}};
    const MaterialPair pair = pair_of_rows(rows);
    EXPECT_EQ(pair.static_friction, (std::vector<double>{1.0, 0.9, 0.6, 0.5}));
    EXPECT_TRUE(pair.humidity.empty());
    std::vector<PairRow> changed = rows;
    changed.pop_back();
    const auto refused = [&] { return support::thrown_by([&] { pair_of_rows(changed); }); };
    EXPECT_TRUE(refused().says("the pair has no row at temperature 60 degC, load 30 N"));
    changed.push_back(rows.front());
    EXPECT_TRUE(refused().says("the pair has two rows at temperature 20 degC, load 30 N"));
    changed.back().load.reset();
    EXPECT_TRUE(refused().says("some rows of the pair have no load"));
}

constexpr const char* seal =
    "temperature: 20, 60; static_friction: 1, 0.8; kinetic_friction: 0.6, 0.5; stribeck_velocity: 0.02, 0.01; "
    "stribeck_exponent: 2, 2; viscous_friction: 0, 0.1";

TEST(MaterialPair, HasNumbersOfTheLaw) {
    Case c;
    set(c, "contact.friction", "stribeck");
    set(c, "contact.pair", seal);
    set(c, "temperature.value", "50");
    EXPECT_NEAR(c.contact().stribeck_velocity, 0.0125, 1e-16);
    EXPECT_NEAR(c.contact().viscous_friction, 0.075, 1e-16);
    EXPECT_EQ(c.contact().stribeck_exponent, 2.0);
    EXPECT_TRUE(findings(c).empty());
    EXPECT_TRUE(
        support::thrown_by([&] { set(c, "contact.stribeck_velocity", "0.05"); }).says("it follows from contact.pair"));
    EXPECT_EQ(usual_range(c, "contact.viscous_friction"), std::nullopt);
    EXPECT_EQ(material_pair_text(parse_material_pair(seal)), seal);
}

TEST(MaterialPair, LeavesToTheCaseWhatItDoesNotHave) {
    Case c;
    set(c, "contact.friction", "stribeck");
    set(c, "contact.pair", "static_friction: 1; kinetic_friction: 0.6; stribeck_velocity: 0.02");
    set(c, "contact.viscous_friction", "0.3");
    EXPECT_EQ(c.contact().viscous_friction, 0.3);
    EXPECT_EQ(c.contact().stribeck_velocity, 0.02);
}

// nobody may believe that a number counts which the law does not have
TEST(MaterialPair, HasNoNumberThatTheLawLacks) {
    const Case c = of_pair("static_friction: 1; kinetic_friction: 0.6; stribeck_velocity: 0.02");
    const std::vector<Finding> found = findings(c);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].problem.what, "contact.pair has stribeck_velocity, which means nothing for this case");
    EXPECT_NE(found[0].problem.why.find("\"stribeck\""), std::string::npos);
}

TEST(MaterialPair, HasNumbersAtEveryPointThatALawMayHave) {
    const auto refused = [](const char* text) { return support::thrown_by([&] { parse_material_pair(text); }); };
    EXPECT_TRUE(refused("static_friction: 1; kinetic_friction: 0.6; stribeck_velocity: 0")
                    .says("contact.stribeck_velocity = 0 is out of range"));
    EXPECT_TRUE(refused("load: 1, 2; static_friction: 1, 1; kinetic_friction: 1, 1; rest_growth: 0.1")
                    .says("1 values of rest_growth at 2 points"));
    std::vector<PairRow> rows(2);
    for (PairRow& row : rows)
        row.static_friction = row.kinetic_friction = 0.5;
    rows[0].load = 10.0;
    rows[1].load = 20.0;
    rows[1].friction_slope = 0.1;
    EXPECT_TRUE(support::thrown_by([&] { pair_of_rows(rows); }).says("some rows of the pair have no friction_slope"));
    rows[0].friction_slope = -0.1;
    EXPECT_TRUE(support::thrown_by([&] {
                    pair_of_rows(rows);
                }).says("contact.friction_slope = -0.1 is out of range at load 10 N"));
    rows[0].friction_slope = 0.3;
    EXPECT_EQ(pair_of_rows(rows).friction_slope, (std::vector<double>{0.3, 0.1}));
}

}  // namespace
}  // namespace stridor::parameters
