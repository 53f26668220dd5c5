#include "contract/impact_contract.hpp"

#include <cmath>
#include <vector>

namespace stridor::contract {
namespace {

using model::Approach;
using model::ContactInertia;
using model::Coulomb;
using model::FrictionLaw;
using model::Impulses;

struct Meeting {
    ContactInertia inertia;
    FrictionLaw friction;
    Approach approach;
};

// with and without coupling (short of Painleve), rough and smooth, slow and fast, slipping both ways and not at all
std::vector<Meeting> meetings() {
    std::vector<Meeting> all;
    for (const double coupling : {-0.5, 0.0, 0.5})
        for (const FrictionLaw& friction : {FrictionLaw(Coulomb{0.8, 0.6}), FrictionLaw(Coulomb{0.0, 0.0})})
            for (const double closing : {-1e-6, -0.3})
                for (const double w : {-2.0, -1e-9, 0.0, 1e-9, 2.0})
                    all.push_back({{0.08, 0.1, coupling}, friction, {closing, w}});
    return all;
}

// P_n and P_t act on g' and on the tangential velocity: see ContactInertia
double gap_velocity_after(const Meeting& m, const Impulses& P) {
    return m.approach.gap_velocity + (P.normal + m.inertia.coupling * P.tangential) / m.inertia.normal;
}
double slip_velocity_after(const Meeting& m, const Impulses& P) {
    return m.approach.slip_velocity + P.tangential / m.inertia.tangential;
}

// all that is compared is a handful of products: some roundings of the larger of the two velocities
double rounding(const Meeting& m) {
    return 1e-14 * (std::abs(m.approach.gap_velocity) + std::abs(m.approach.slip_velocity));
}

TEST_P(ImpactContract, NeverLetsTheSurfacesPassThroughEachOther) {
    for (const Meeting& m : meetings()) {
        const Impulses P = impulses(GetParam().law, m.inertia, m.friction, m.approach);
        EXPECT_GE(gap_velocity_after(m, P), -rounding(m));
    }
}

TEST_P(ImpactContract, TurnsTheGapVelocityByItsRestitution) {
    for (const Meeting& m : meetings()) {
        const Impulses P = impulses(GetParam().law, m.inertia, m.friction, m.approach);
        EXPECT_GE(P.restitution, 0.0);
        EXPECT_LT(P.restitution, 1.0);
        EXPECT_NEAR(gap_velocity_after(m, P), -P.restitution * m.approach.gap_velocity, rounding(m));
    }
}

TEST_P(ImpactContract, Pushes) {
    for (const Meeting& m : meetings())
        EXPECT_GT(impulses(GetParam().law, m.inertia, m.friction, m.approach).normal, 0.0);
}

TEST_P(ImpactContract, NeverTurnsTheSlipRound) {
    for (const Meeting& m : meetings()) {
        const Impulses P = impulses(GetParam().law, m.inertia, m.friction, m.approach);
        const double after = slip_velocity_after(m, P);
        EXPECT_GE(after * m.approach.slip_velocity, -rounding(m) * std::abs(m.approach.slip_velocity));
        EXPECT_NEAR(P.stops ? after : 0.0, 0.0, rounding(m));
    }
}

TEST_P(ImpactContract, KeepsToTheFrictionCone) {
    for (const Meeting& m : meetings()) {
        const Impulses P = impulses(GetParam().law, m.inertia, m.friction, m.approach);
        const double limit = stick_limit(m.friction, model::slip_against(P.tangential)) * P.normal;
        EXPECT_LE(std::abs(P.tangential), limit * (1.0 + 1e-14));
    }
}

// the energy of the gap and of the slip, each with its mass: what an impact takes is no gain
TEST_P(ImpactContract, NeverAddsEnergy) {
    for (const Meeting& m : meetings()) {
        const Impulses P = impulses(GetParam().law, m.inertia, m.friction, m.approach);
        const auto energy = [&](double gap_velocity, double slip_velocity) {
            return 0.5 * m.inertia.normal * gap_velocity * gap_velocity +
                   0.5 * m.inertia.tangential * slip_velocity * slip_velocity;
        };
        const double before = energy(m.approach.gap_velocity, m.approach.slip_velocity);
        EXPECT_LE(energy(gap_velocity_after(m, P), slip_velocity_after(m, P)), before * (1.0 + 1e-14));
    }
}

// (F, V) scaled by a power of two scales every velocity, bit for bit
TEST_P(ImpactContract, IsHomogeneous) {
    for (const Meeting& m : meetings()) {
        const Impulses one = impulses(GetParam().law, m.inertia, m.friction, m.approach);
        const Impulses twice = impulses(GetParam().law, m.inertia, m.friction,
                                        {2.0 * m.approach.gap_velocity, 2.0 * m.approach.slip_velocity});
        EXPECT_EQ(twice.normal, 2.0 * one.normal);
        EXPECT_EQ(twice.tangential, 2.0 * one.tangential);
        EXPECT_EQ(twice.stops, one.stops);
    }
}

INSTANTIATE_TEST_SUITE_P(Laws, ImpactContract,
                         testing::Values(ImpactUnderTest{"plastic", model::Plastic{}},
                                         ImpactUnderTest{"normal_only", model::NormalOnly{}},
                                         ImpactUnderTest{"restitution_half", model::Restitution{0.5}},
                                         ImpactUnderTest{"restitution_none", model::Restitution{0.0}}),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace stridor::contract
