#include "stridor/parameters/paper_cases.hpp"

#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/rules/check.hpp"

#include <gtest/gtest.h>

#include <string>

namespace stridor::parameters {
namespace {

constexpr PaperCase all_paper_cases[] = {PaperCase::squeal, PaperCase::squeak, PaperCase::creak, PaperCase::quiet};

// what all columns of Table 1 share, as printed there
TEST(PaperCase, SharesTheConstantsOfTable1) {
    for (const PaperCase which : all_paper_cases) {
        const Case c = paper_case(which);
        EXPECT_EQ(c.joint().mass, 0.1);
        EXPECT_EQ(c.plate.mass, 0.4);
        EXPECT_EQ(c.joint().axial_stiffness, 1e7);
        EXPECT_EQ(c.joint().flexural_stiffness, 1e6);
        EXPECT_EQ(c.plate.stiffness, 1e6);
        EXPECT_EQ(c.joint().axial_damping, 1.0);
        EXPECT_EQ(c.joint().flexural_damping, 1.0);
        EXPECT_EQ(c.plate.damping, 1.0);
        EXPECT_EQ(c.joint().incidence_angle, 70.0);
        EXPECT_EQ(c.contact().static_friction, 0.8);
        EXPECT_EQ(c.drive.amplitude, 4e-3);
        EXPECT_EQ(c.drive.frequency, 5.0);
        EXPECT_EQ(c.drive.kind, DriveKind::sinusoidal);
        EXPECT_EQ(c.run.step, 1e-7);
        EXPECT_TRUE(findings(c).empty());
    }
}

TEST(PaperCase, DiffersInFrictionAndPreload) {
    const auto expect = [](PaperCase which, double kinetic_friction, double preload) {
        EXPECT_EQ(paper_case(which).contact().kinetic_friction, kinetic_friction);
        EXPECT_EQ(paper_case(which).contact().preload, preload);
    };
    expect(PaperCase::quiet, 0.2, 20.0);
    expect(PaperCase::squeal, 0.6, 20.0);
    expect(PaperCase::squeak, 0.2, 200.0);
    expect(PaperCase::creak, 0.2, 2000.0);
}

TEST(PaperCase, IsTitledByItsName) {
    for (const PaperCase which : {PaperCase::squeal, PaperCase::squeak, PaperCase::creak})
        EXPECT_TRUE(paper_case(which).title.starts_with(paper_case_names[static_cast<std::size_t>(which)]));
}

// the defaults of a case are the squeal column
TEST(PaperCase, SquealIsTheDefault) {
    Case c = paper_case(PaperCase::squeal);
    c.run.step = Case{}.run.step;
    EXPECT_EQ(canonical_text(c), canonical_text(Case{}));
}

}  // namespace
}  // namespace stridor::parameters
