// Friction that differs each way: where only one way is ever slipped, its coefficients are Coulomb's, bit for bit.

#include "stridor/integration/exact/exact.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/model/built/mass_on_belt.hpp"
#include "support/belt_run.hpp"

#include <gtest/gtest.h>

namespace stridor {
namespace {

// a belt at `velocity` [m/s], started stuck: the mass slips against it and is caught again, never overtakes it
record::ContactHistory rubbed(double velocity, const model::FrictionLaw& law) {
    parameters::Case c;
    c.drive = support::constant_drive(velocity);
    c.run.duration = c.run.window = 1.0;
    model::Structure belt = model::mass_on_belt({1.0, 1e4, 2.0, 100.0, {}});
    belt.contacts[0].friction = law;
    return integration::integrate_exact(belt, c.drive, {parameters::Initial::stuck, 0.0}, {},
                                        record::Recorder(record::schedule(c), {record::KeepHistory::yes, {}}, 2))
        .record.histories.front();
}

void expect_same(const record::ContactHistory& a, const record::ContactHistory& b) {
    ASSERT_GT(a.size(), 10U);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
        EXPECT_EQ(a[k].state, b[k].state) << k;
        EXPECT_EQ(a[k].from, b[k].from) << k;
    }
}

TEST(Directional, IsCoulombsWhereOneWayIsSlipped) {
    const model::Coulomb rough{0.8, 0.3};
    const model::Directional stroked{{0.5, 0.8}, {0.1, 0.3}};  // rough backward, smooth forward
    expect_same(rubbed(0.1, stroked), rubbed(0.1, rough));
    expect_same(rubbed(-0.1, stroked), rubbed(-0.1, model::Coulomb{0.5, 0.1}));
}

TEST(Directional, MirrorsWithItsCoefficients) {
    const model::Directional here{{0.5, 0.8}, {0.1, 0.3}};
    const model::Directional there{{0.8, 0.5}, {0.3, 0.1}};
    expect_same(rubbed(0.1, here), rubbed(-0.1, there));
}

// of the paper's system, both engines: with equal coefficients nothing changes
TEST(Directional, WithTheSameCoefficientsBothWaysIsCoulombs) {
    for (const parameters::Engine engine : {parameters::Engine::exact, parameters::Engine::beta_2}) {
        parameters::Case c;
        c.run.engine = engine;
        c.run.duration = c.run.window = 0.05;
        c.drive = support::constant_drive(0.1);
        const record::Request request{record::KeepHistory::yes, {}};
        const auto coulomb = integration::simulate(c, request).record.histories.front();
        c.contact().friction = parameters::FrictionKind::directional;
        c.contact().static_friction_coming = c.contact().static_friction;
        c.contact().kinetic_friction_coming = c.contact().kinetic_friction;
        expect_same(integration::simulate(c, request).record.histories.front(), coulomb);
        c.contact().kinetic_friction_coming = 0.1;
        EXPECT_NE(integration::simulate(c, request).record.histories.front().size(), coulomb.size());
    }
}

}  // namespace
}  // namespace stridor
