#include "stridor/parameters/tables/friction_table.hpp"

#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/rules/check.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

namespace stridor::parameters {
namespace {

TEST(FrictionTable, IsReadFromRowsWithUnitsAndWrittenInSi) {
    const FrictionTable table = parse_friction_table("0: 0.8, 10 mm/s: 0.7,0.1 m/s: 60 %");
    EXPECT_EQ(table.speeds, (std::vector<double>{0.0, 0.01, 0.1}));
    EXPECT_EQ(table.coefficients, (std::vector<double>{0.8, 0.7, 0.6}));
    EXPECT_EQ(friction_table_text(table), "0: 0.8, 0.01: 0.7, 0.1: 0.6");
    EXPECT_EQ(parse_friction_table(friction_table_text(table)).speeds, table.speeds);
}

TEST(FrictionTable, WithoutAColonIsAFileThatIsNotOpened) {
    const FrictionTable table = parse_friction_table(" measured.csv ");
    EXPECT_EQ(table.file, "measured.csv");
    EXPECT_EQ(friction_table_text(table), "measured.csv");
}

TEST(FrictionTable, ThatIsNoFunctionIsRefusedWithItsRow) {
    const auto refused = [](const char* text) { return support::thrown_by([&] { parse_friction_table(text); }); };
    EXPECT_TRUE(refused("0: 0.8, 0.1: 0.6, 0.1: 0.5").says("row 3 of the table of friction has 0.1 m/s after 0.1 m/s"));
    EXPECT_TRUE(refused("0.2: 0.8, 0.1: 0.6").says("row 2 of the table of friction has 0.1 m/s after 0.2 m/s"));
    EXPECT_TRUE(refused("0: 0.8, 0.1: -0.6").says("row 2 of the table of friction has a coefficient of -0.6"));
    EXPECT_TRUE(refused("-1: 0.8, 0.1: 0.6").says("row 1 of the table of friction has a speed of -1 m/s"));
    EXPECT_TRUE(refused("0: 0.8").says("the table of friction has 1 row"));
    EXPECT_TRUE(refused("0: 0.8, 0.1").says("row 2 of the table of friction is \"0.1\""));
    EXPECT_TRUE(refused("0: 0.8, 0.1: 1: 2").says("row 2 of the table of friction is"));
    EXPECT_TRUE(refused("0: 0.8, 0.1 kg: 0.6").says("0.1 kg"));
    EXPECT_TRUE(refused(" ").says("the table of friction is empty"));
}

Case measured(const char* rows) {
    Case c;
    c.contact().friction = FrictionKind::table;
    c.run.engine = Engine::beta_2;
    c.drive.kind = DriveKind::constant;
    set_from_text(c, *find_field("contact.friction_table"), rows);
    return c;
}

TEST(FrictionTable, MustReachWhatTheSurfaceMoves) {
    EXPECT_TRUE(findings(measured("0: 0.8, 0.1: 0.6")).empty());
    const std::vector<Finding> found = findings(measured("0: 0.8, 0.05: 0.6"));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].key, "contact.friction_table");
    EXPECT_EQ(found[0].problem.what, "contact.friction_table ends at 0.05 m/s");
}

TEST(FrictionTable, MayNotExceedWhatEndsAStick) {
    const std::vector<Finding> found = findings(measured("0: 0.8, 0.1: 0.9"));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].problem.what, "row 2 of contact.friction_table, 0.9, exceeds mu_s = 0.8");
}

TEST(FrictionTable, DecidesResultsByItsRows) {
    EXPECT_NE(canonical_text(measured("0: 0.8, 0.1: 0.6")), canonical_text(measured("0: 0.8, 0.1: 0.7")));
    EXPECT_EQ(canonical_text(measured("0: 0.8, 0.1: 0.6")), canonical_text(measured("0: 0.8, 100 mm/s: 0.6")));
}

}  // namespace
}  // namespace stridor::parameters
