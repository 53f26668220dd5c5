#include "stridor/parameters/tables/temperature_table.hpp"

#include "stridor/base/error.hpp"
#include "stridor/parameters/fields/field_name.hpp"
#include "stridor/parameters/rules/check.hpp"
#include "stridor/parameters/tables/damping_ratio.hpp"
#include "support/error_text.hpp"
#include "support/property.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace stridor::parameters {
namespace {

using Texts = std::vector<std::string>;

void set_text(Case& c, std::string_view name, std::string_view text) {
    set_from_text(c, field_named(name), text);
}

TemperatureColumn column(std::string_view name, const Texts& texts) {
    return read_temperature_column(field_named(name), texts);
}

// a lip that softens as it gets warm, with more friction
Case lip() {
    Case c;
    set_temperature_table(c, read_temperature_nodes(Texts{"-30 degC", "23 degC", "80 degC"}),
                          {column("mu_d", {"0.25", "0.5", "0.75"}), column("k1i", {"60 N/mm", "25 N/mm", "12 N/mm"})});
    return c;
}

void expect_refused(const support::Thrown& thrown, const char* words) {
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says(words)) << thrown.message;
}

TEST(TemperatureTable, GivesItsOwnNumbersAtTheNodes) {
    Case c = lip();
    const std::vector<std::pair<const char*, double>> nodes{{"-30", 60e3}, {"23 degC", 25e3}, {"80 °C", 12e3}};
    for (const auto& [temperature, stiffness] : nodes) {
        set_text(c, "temperature", temperature);
        EXPECT_EQ(c.joint().axial_stiffness, stiffness) << temperature;
    }
    EXPECT_EQ(c.contact().kinetic_friction, 0.75);
    EXPECT_EQ(c.joint().flexural_stiffness, Case{}.joint().flexural_stiffness);
}

TEST(TemperatureTable, IsLinearBetweenTwoNodes) {
    Case c = lip();
    set_text(c, "theta", "-3.5");  // half way from -30 to 23, exact in binary
    EXPECT_EQ(c.joint().axial_stiffness, 42.5e3);
    EXPECT_EQ(c.contact().kinetic_friction, 0.375);
    set_text(c, "theta", "37.25");  // a quarter of the way from 23 to 80
    EXPECT_EQ(c.joint().axial_stiffness, 21.75e3);
}

RC_GTEST_PROP(TemperatureTable, StaysBetweenTheNumbersOfItsNodes, ()) {
    Case c = lip();
    const double temperature = 25.0 + 55.0 * *support::signed_fraction();
    set_quantity(c, field_named("temperature"), temperature);
    const bool is_cold = temperature <= 23.0;
    RC_ASSERT(c.joint().axial_stiffness <= (is_cold ? 60e3 : 25e3));
    RC_ASSERT(c.joint().axial_stiffness >= (is_cold ? 25e3 : 12e3));
}

TEST(TemperatureTable, KnowsNothingOutsideOfItself) {
    for (const char* text : {"-30.1", "80.1 degC", "1e9"})
        expect_refused(support::thrown_by([&] {
                           Case c = lip();
                           set_text(c, "temperature", text);
                       }),
                       "between -30 and 80 degC");
    // without a table there is nothing outside
    Case c;
    set_text(c, "temperature", "500");
    EXPECT_EQ(c.temperature.value, 500.0);
}

TEST(TemperatureTable, AloneSetsWhatFollowsIt) {
    for (const char* name : {"joint.axial_stiffness", "k1i", "mu_d"})
        expect_refused(support::thrown_by([&] {
                           Case c = lip();
                           set_text(c, name, "0.5");
                       }),
                       "cannot be set (it follows the temperature by a table)");
    expect_refused(support::thrown_by([] {
                       Case c = lip();
                       set_quantity(c, field_named("k1i"), 3e4);
                   }),
                   "joint.axial_stiffness");
    Case c = lip();
    set_text(c, "k1j", "3 N/mm");
    EXPECT_EQ(c.joint().flexural_stiffness, 3e3);
}

TEST(TemperatureTable, TakesDampingRatiosAlong) {
    Case c = lip();
    set_text(c, "c1i", "15 %");
    set_text(c, "temperature", "23");
    EXPECT_EQ(c.joint().axial_damping, 2.0 * 0.15 * std::sqrt(25e3 * c.joint().mass));
    set_text(c, "temperature", "80");
    EXPECT_EQ(c.joint().axial_damping, 2.0 * 0.15 * std::sqrt(12e3 * c.joint().mass));
}

TEST(TemperatureTable, HoldsDampingRatiosItself) {
    Case c;
    set_temperature_table(c, {0.0, 50.0},
                          {column("k2y", {"4 N/mm", "1 N/mm"}), column("c2y", {"50 %", "loss factor 0.5"})});
    set_text(c, "temperature", "25");
    EXPECT_EQ(c.plate.stiffness, 2500.0);
    EXPECT_EQ(value_text(c, field_named("c2y")), "damping ratio 0.375");
    EXPECT_EQ(c.plate.damping, 2.0 * 0.375 * std::sqrt(2500.0 * c.plate.mass));
    set_text(c, "plate.mass", "9 kg");
    EXPECT_EQ(c.plate.damping, 2.0 * 0.375 * std::sqrt(2500.0 * 9.0));
    expect_refused(support::thrown_by([] { column("c2y", {"50 %", "3 N*s/m"}); }), "share of critical");
}

TEST(TemperatureTable, RefusesNodesThatDoNotRise) {
    expect_refused(support::thrown_by([] { read_temperature_nodes(Texts{"23", "-30"}); }), "-30 follows 23");
    expect_refused(support::thrown_by([] { read_temperature_nodes(Texts{"23", "23 degC"}); }), "does not rise");
    expect_refused(support::thrown_by([] { read_temperature_nodes(Texts{"23"}); }), "too few temperatures: 1");
    expect_refused(support::thrown_by([] { read_temperature_nodes({}); }), "too few temperatures: 0");
    expect_refused(support::thrown_by([] { read_temperature_nodes(Texts{"-300", "20"}); }), "between -273.15");
    expect_refused(support::thrown_by([] { read_temperature_nodes(Texts{"23 N", "30"}); }), "a temperature (degC)");
}

TEST(TemperatureTable, RefusesColumnsThatDoNotFit) {
    const auto refused = [](std::vector<TemperatureColumn> columns, const char* words) {
        expect_refused(support::thrown_by([&] {
                           Case c;
                           set_temperature_table(c, {0.0, 50.0}, std::move(columns));
                       }),
                       words);
    };
    refused({column("k1i", {"1", "2", "3"})}, "joint.axial_stiffness has 3 values over 2 temperatures");
    refused({column("k1i", {"1"})}, "has 1 values over 2 temperatures");
    refused({column("k1i", {"1", "2"}), column("k1i", {"2", "1"})}, "stands twice");
    refused({}, "nothing follows the temperature");
    expect_refused(support::thrown_by([] { column("k1i", {"1", "0"}); }), "joint.axial_stiffness = 0 is out of range");
    expect_refused(support::thrown_by([] { column("k1i", {"1 N", "2"}); }), "a stiffness (N/m)");
}

TEST(TemperatureTable, MovesATemperatureIntoItself) {
    Case c;  // 23 degC
    set_temperature_table(c, {-40.0, 0.0}, {column("k1i", {"3", "2"})});
    EXPECT_EQ(c.temperature.value, 0.0);
    EXPECT_EQ(c.joint().axial_stiffness, 2.0);
}

// cases that run alike over all temperatures, and no others
TEST(TemperatureTable, StandsWholeInTheCanonicalText) {
    const std::string text = canonical_text(lip());
    EXPECT_NE(text.find("temperature.value = 23 degC\n"), std::string::npos) << text;
    EXPECT_NE(text.find("temperature.at = -30 degC, 23 degC, 80 degC\n"
                        "temperature.joint.axial_stiffness = 60000 N/m, 25000 N/m, 12000 N/m\n"
                        "temperature.contact.kinetic_friction = 0.25, 0.5, 0.75\n"),
              std::string::npos)
        << text;
    EXPECT_EQ(text.find("\njoint.axial_stiffness"), std::string::npos);
    Case same = lip();
    set_temperature_table(same, lip().temperature.at, {lip().temperature.columns[1], lip().temperature.columns[0]});
    EXPECT_EQ(canonical_text(same), text);
    Case number = lip();
    number.temperature = {};
    EXPECT_NE(canonical_text(number), text);
    EXPECT_EQ(canonical_text(number).find("temperature"), std::string::npos);
}

TEST(TemperatureTable, HoldsTheNumbersOfALaw) {
    Case c;
    set_text(c, "friction", "stribeck");
    set_temperature_table(c, {0.0, 50.0}, {column("v_s", {"40 mm/s", "20 mm/s"}), column("k_v", {"0", "0.5 s/m"})});
    EXPECT_TRUE(findings(c).empty());
    set_text(c, "temperature", "25");
    EXPECT_EQ(c.contact().stribeck_velocity, 0.03);
    EXPECT_EQ(c.contact().viscous_friction, 0.25);
    // of another law they mean nothing
    set_text(c, "friction", "coulomb");
    ASSERT_EQ(findings(c).size(), 2U);
    EXPECT_EQ(findings(c)[0].problem.what,
              "contact.stribeck_velocity follows the temperature, and means nothing for this case");
}

TEST(TemperatureTable, ListsItsKeysAsTheFieldTableDoes) {
    const auto keys = keys_over_temperature();
    std::size_t next = 0;
    for (const Field& field : fields())
        if (next < keys.size() && key_of(field) == keys[next]) ++next;
    EXPECT_EQ(next, keys.size()) << "in the order of the field table";
}

}  // namespace
}  // namespace stridor::parameters
