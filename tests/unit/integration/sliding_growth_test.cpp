#include "stridor/integration/proofs/sliding_growth.hpp"

#include "stridor/model/built/case_structure.hpp"
#include "stridor/parameters/case.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stridor::integration {
namespace {

using model::ContactState;
using record::Future;

// what is told of the paper's joint at mu_d, whose modes flutter from 0.449 on, after a run that slipped for a share
record::Outlook told_of(double kinetic_friction, double slip_share, Future future) {
    parameters::Case c;
    c.contact().kinetic_friction = kinetic_friction;
    const model::Structure structure = model::structure_of(c);
    record::Tally tally;
    tally.vibration.assign(3, {1e-12, 0.0});
    tally.vibration_time = 1.0;
    record::ContactTally& contact = tally.contacts.front();
    contact.judged_time[model::index_of(ContactState::slip)] = slip_share;
    contact.judged_time[model::index_of(ContactState::stick)] = 1.0 - slip_share;
    contact.ending.outlook.future = future;
    std::vector<record::Tally> phases{tally};
    tell_growth(structure, {.surface_velocity = 0.1, .end = 2.0, .least_slip = 0.98}, phases);
    return phases.front().contacts.front().ending.outlook;
}

TEST(SlidingGrowth, IsToldOfASlidingThatGrowsAndLasted) {
    const record::Outlook outlook = told_of(0.6, 1.0, Future::unknown);
    EXPECT_GT(outlook.growth, 0.0);
    EXPECT_GT(outlook.grown, 2.0);
    EXPECT_TRUE(std::isnan(told_of(0.3, 1.0, Future::unknown).growth));
}

// what is proven stays proven, and a contact that stuck for long is no slider
TEST(SlidingGrowth, IsNotToldOfWhatIsProvenOrSticks) {
    EXPECT_TRUE(std::isnan(told_of(0.6, 1.0, Future::slides).growth));
    EXPECT_TRUE(std::isnan(told_of(0.6, 1.0, Future::sticks).growth));
    EXPECT_TRUE(std::isnan(told_of(0.6, 0.6, Future::unknown).growth));
}

}  // namespace
}  // namespace stridor::integration
