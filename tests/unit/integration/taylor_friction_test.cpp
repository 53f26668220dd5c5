// Friction that changes with the slip velocity, by Taylor series.

#include "stridor/integration/exact/exact.hpp"
#include "stridor/integration/series/taylor.hpp"
#include "stridor/model/built/mass_on_belt.hpp"
#include "support/many_contacts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace stridor::integration {
namespace {

using parameters::Initial;
using support::plate_joint;

constexpr double drive_velocity = 0.1257;  // [m/s] the largest of Table 1

// the same coefficients, by a law that may change with the slip velocity
model::Structure with_changing_laws(model::Structure structure) {
    for (model::ContactPoint& contact : structure.contacts) {
        const auto& coulomb = std::get<model::Coulomb>(contact.friction);
        contact.friction = model::Linear{coulomb.static_coefficient, coulomb.kinetic_coefficient, 0.0};
    }
    return structure;
}

Motion run(const model::Structure& structure, double velocity, double duration, const Taylor& settings) {
    const parameters::Case c = support::watched_case(velocity, {duration, duration});
    record::Request request;
    request.history = record::KeepHistory::yes;
    return integrate_taylor(structure, c.drive, initial_state(structure, {Initial::stuck, 0.0}, velocity), settings,
                            record::Recorder(record::schedule(c), request, model::dofs_of(structure),
                                             static_cast<int>(structure.contacts.size()), model::channels_of(structure),
                                             model::interfaces_of(structure)));
}

constexpr Taylor to_the_end{parameters::EarlyEnding::never};

// [s] largest difference of their events, which are of the same kinds
double largest_shift(const Motion& a, const Motion& b) {
    double most = 0.0;
    for (std::size_t k = 0; k < a.record.histories.size(); ++k) {
        const record::ContactHistory& here = a.record.histories[k];
        const record::ContactHistory& there = b.record.histories[k];
        EXPECT_EQ(here.size(), there.size());
        for (std::size_t n = 0; n < std::min(here.size(), there.size()); ++n) {
            EXPECT_EQ(here[n].state, there[n].state) << "event " << n;
            most = std::max(most, std::abs(here[n].from - there[n].from));
        }
    }
    return most;
}

TEST(TaylorFriction, OfConstantCoefficientsHasTheEventsOfTheExactEngine) {
    for (const double preload : {200.0, 1000.0, 2000.0}) {
        const model::Structure coulomb = model::joints_on_plate(std::array{plate_joint(preload, 0.2)}, {});
        const parameters::Case c = support::watched_case(-drive_velocity, {0.05, 0.05});
        record::Request request;
        request.history = record::KeepHistory::yes;
        const Motion exact = integrate_exact(coulomb, c.drive, {Initial::stuck, 0.0}, {},
                                             record::Recorder(record::schedule(c), request, model::dofs_of(coulomb)));
        const Motion motion = run(with_changing_laws(coulomb), -drive_velocity, 0.05, to_the_end);
        EXPECT_GT(motion.record.histories.front().size(), 10U);
        EXPECT_LT(largest_shift(motion, exact), 1e-12) << preload;
    }
}

TEST(TaylorFriction, OfConstantCoefficientsHasTheEventsOfSeveralContacts) {
    const model::Structure coulomb = support::plate_of({plate_joint(200.0, 0.2), plate_joint(150.0, 0.3, 75.0)});
    const Motion wanted = run(coulomb, -drive_velocity, 0.02, to_the_end);
    const Motion motion = run(with_changing_laws(coulomb), -drive_velocity, 0.02, to_the_end);
    EXPECT_GT(motion.record.histories.front().size(), 10U);
    EXPECT_LT(largest_shift(motion, wanted), 1e-12);
}

// fewer terms take shorter blocks, to the same motion
TEST(TaylorFriction, MovesAlikeByAnyOrder) {
    model::Structure belt = model::mass_on_belt({1.0, 1.0, 0.0, 1.0, {}});
    belt.contacts[0].friction = model::Linear{1.0, 1.0, 0.8};
    const Motion finest = run(belt, 0.2, 40.0, to_the_end);
    EXPECT_EQ(finest.outcome.reason, Reason::completed);
    EXPECT_GT(finest.record.histories.front().size(), 5U);
    for (const int order : {10, 14, 18, 22})
        EXPECT_LT(largest_shift(run(belt, 0.2, 40.0, {parameters::EarlyEnding::never, order}), finest), 1e-12) << order;
}

// beyond mu_d/s nothing rubs: the law has a corner there
TEST(TaylorFriction, PassesACornerOfItsLaw) {
    model::Structure belt = model::mass_on_belt({1.0, 1.0, 0.0, 1.0, {}});
    belt.contacts[0].friction = model::Linear{1.0, 0.5, 2.0};  // none from 0.25 m/s on
    const Motion motion = run(belt, 0.2, 40.0, to_the_end);
    EXPECT_EQ(motion.outcome.reason, Reason::completed);
    EXPECT_LT(std::abs(motion.energy.relative_residual()), 1e-13);
    EXPECT_GT(motion.energy.friction_loss, 0.0);
    EXPECT_GT(motion.record.histories.front().size(), 5U);
}

TEST(TaylorFriction, RepeatsItselfButIsNotProvenToSlideForEver) {
    model::Structure belt = model::mass_on_belt({1.0, 1.0, 0.0, 1.0, {}});
    belt.contacts[0].friction = model::Linear{1.0, 1.0, 0.8};
    const Motion cycle = run(belt, 0.2, 200.0, {});
    EXPECT_EQ(cycle.outcome.reason, Reason::settled);
    EXPECT_TRUE(cycle.cycle.has_value());
    belt.damping(0, 0) = 2.0;  // beyond s N: it slides for ever, which nobody proves
    const Motion slide = run(belt, 0.5, 200.0, {});
    EXPECT_EQ(slide.outcome.reason, Reason::completed);
    EXPECT_FALSE(slide.silence.has_value());
}

}  // namespace
}  // namespace stridor::integration
