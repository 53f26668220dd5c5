#include "stridor/parameters/rules/resolution.hpp"

#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/paper_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace stridor::parameters {
namespace {

std::vector<std::string> keys_found(const Case& c) {
    std::vector<std::string> keys;
    for (const Finding& finding : findings(c))
        keys.push_back(finding.key);
    return keys;
}

Case constant_squeal() {
    Case c = paper_case(PaperCase::squeal);
    c.drive.kind = DriveKind::constant;
    return c;
}

bool names(const Case& c, const std::string& key) {
    const std::vector<std::string> keys = keys_found(c);
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

// products of four of a case's numbers stay numbers
TEST(Resolution, RefusesNumbersWhoseProductsAreNone) {
    for (const Field& field : fields()) {
        const auto* quantity = std::get_if<Quantity>(&field.kind);
        Case c = paper_case(PaperCase::squeal);
        if (quantity == nullptr || !field.belongs(c)) continue;
        for (const double value : {1e300, 1e-300}) {
            Case changed = c;
            quantity->set(changed, value);
            const bool is_bounded = quantity->range.high < 1e300 && value > 1.0;
            const bool is_plain = (quantity->unit == "1" || quantity->unit == "deg") && value < 1.0;
            if (is_bounded || is_plain) continue;
            EXPECT_TRUE(names(changed, key_of(field))) << key_of(field) << " " << value;
        }
    }
}

// eps T Omega/2 of a step is all that is known of an instant
TEST(Resolution, RefusesRatesFarBeyondTheDuration) {
    Case c = constant_squeal();
    c.plate.damping = 1e30;
    EXPECT_EQ(keys_found(c), std::vector<std::string>{"plate.damping"});
    c.plate.damping = 1.0;
    c.run.duration = 1e9;
    EXPECT_EQ(keys_found(c), std::vector<std::string>{"run.duration"});
    // a million seconds of Table 1 are 1e10 of its fastest time
    c.run.duration = 1e6;
    EXPECT_TRUE(findings(c).empty());
    c.contact().static_friction = c.contact().kinetic_friction = 1e12;
    EXPECT_EQ(keys_found(c), std::vector<std::string>{"contact.kinetic_friction"});
    c.contact() = {};
    // beta_2 has its own limits: the step
    c.run.engine = Engine::beta_2;
    c.run.duration = 1.0;
    c.plate.damping = 1e30;
    EXPECT_TRUE(findings(c).empty());
}

TEST(Resolution, RefusesWhatDrownsInTheRoundingOfItsNeighbour) {
    Case c = paper_case(PaperCase::squeal);
    c.joint().flexural_stiffness = 1e-6;
    EXPECT_EQ(keys_found(c), std::vector<std::string>{"joint.axial_stiffness"});
    c = paper_case(PaperCase::squeal);
    c.plate.mass = 1e12;
    EXPECT_EQ(keys_found(c), std::vector<std::string>{"plate.mass"});
    c = paper_case(PaperCase::squeal);
    c.contact().static_friction = 2e12;
    EXPECT_EQ(keys_found(c), std::vector<std::string>{"contact.static_friction"});
}

// 1 MHz for a minute took 3.5 GiB, 1e9 Hz more than there is
TEST(Resolution, RefusesMoreReversalsThanFitIntoMemory) {
    Case c = paper_case(PaperCase::squeal);
    c.drive.frequency = 1e6;
    c.run.duration = c.run.window = 60.0;
    EXPECT_EQ(keys_found(c), std::vector<std::string>{"drive.frequency"});
    c.drive.frequency = 1e9;
    EXPECT_EQ(keys_found(c), std::vector<std::string>{"drive.frequency"});
    c.drive.frequency = 1600.0;
    EXPECT_TRUE(findings(c).empty());
}

TEST(Resolution, RefusesASampledDriveThatStandsStillOrTrembles) {
    Case c = paper_case(PaperCase::squeal);
    c.drive.kind = DriveKind::sampled;
    c.drive.times = {0.0, 1.0, 2.0, 3.0};
    c.drive.velocities = {0.0, 0.0, 0.1, 0.1};
    EXPECT_EQ(keys_found(c), std::vector<std::string>{"drive.file"});
    c.run.duration = 1.5;  // it moves from 1 s on
    EXPECT_TRUE(findings(c).empty());
    c.drive.times.clear();
    c.drive.velocities.clear();
    for (int k = 0; k <= 300000; ++k) {
        c.drive.times.push_back(1e-5 * k);
        c.drive.velocities.push_back(k % 2 == 0 ? 0.1 : -0.1);
    }
    EXPECT_EQ(keys_found(c), std::vector<std::string>{"drive.file"});
}

TEST(Resolution, RefusesAWindowThatIsNoTime) {
    Case c = constant_squeal();
    c.run.window = 1e-12;
    EXPECT_EQ(keys_found(c), std::vector<std::string>{"run.window"});
    c.run.window = 1e-6;
    EXPECT_TRUE(findings(c).empty());
}

// shares of a phase that leave a thousand-millionth of it
TEST(Resolution, RefusesCutsThatLeaveNextToNothing) {
    Case c = paper_case(PaperCase::squeal);
    c.verdict.settling = std::nextafter(1.0, 0.0);
    c.verdict.reversal = 0.0;
    EXPECT_EQ(keys_found(c), std::vector<std::string>{"verdict.settling"});
}

TEST(Resolution, RefusesAStepAsLongAsWhatIsJudged) {
    Case c = constant_squeal();
    c.run.engine = Engine::beta_2;
    c.run.step = 1e-6;
    c.run.window = 5e-6;
    EXPECT_EQ(keys_found(c), std::vector<std::string>{"run.step"});
    c.run.step = 1e-7;
    EXPECT_TRUE(findings(c).empty());
}

}  // namespace
}  // namespace stridor::parameters
