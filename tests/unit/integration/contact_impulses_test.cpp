#include "stridor/integration/rules/contact_impulses.hpp"

#include "stridor/integration/rules/contact_mode_of.hpp"
#include "stridor/model/built/joints_on_plate.hpp"
#include "support/counter_random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace stridor::integration {
namespace {

constexpr std::size_t p = 3;

// joints of different angles on one plate: each impact moves the others
ModalStructure three_joints() {
    std::vector<model::PlateJoint> joints(p);
    joints[1].joint.incidence_angle = 40.0;
    joints[2].joint.incidence_angle = 110.0;
    joints[2].joint.mass = 0.05;
    for (model::PlateJoint& joint : joints)
        joint.contact.kinetic_friction = 0.3;
    return modal_structure(model::joints_on_plate(joints, {}));
}

Meeting random_meeting(support::CounterRandom& random) {
    Meeting meeting;
    for (std::size_t k = 0; k < p; ++k) {
        const bool was_closed = random.between(0.0, 1.0) < 0.5;
        meeting.gap_velocity.push_back(was_closed ? 0.0 : random.between(-1.0, 0.0));
        meeting.slip_velocity.push_back(random.between(-1.0, 1.0));
        meeting.touches.push_back(random.between(0.0, 1.0) < 0.8);
        meeting.mode.push_back(was_closed ? slip_mode(model::slip_of(meeting.slip_velocity[k])) : ContactMode::stick);
    }
    return meeting;
}

TEST(ContactImpulses, ObeyAllLawsAndTakeEnergy) {
    const ModalStructure structure = three_joints();
    support::CounterRandom random(7);
    for (int trial = 0; trial < 2000; ++trial) {
        const Meeting meeting = random_meeting(random);
        const auto found = contact_impulses(structure, meeting);
        ASSERT_TRUE(found) << "trial " << trial;
        double work = 0.0;
        for (std::size_t k = 0; k < p; ++k) {
            const double P_n = found->normal[k];
            const double P_t = found->tangential[k];
            if (!meeting.touches[k]) {
                EXPECT_EQ(P_n, 0.0);
                EXPECT_EQ(P_t, 0.0);
                continue;
            }
            EXPECT_GE(P_n, -1e-12);
            EXPECT_GE(found->gap_velocity[k], -1e-12);
            EXPECT_NEAR(P_n * found->gap_velocity[k], 0.0, 1e-12);
            const ModalContact& law = structure.contacts[k];
            if (found->mode[k] == ContactMode::stick) {
                EXPECT_EQ(found->slip_velocity[k], 0.0);
                EXPECT_LE(std::abs(P_t), stick_limit(law.friction, model::Slip::forward) * P_n + 1e-12);
            } else if (is_slip(found->mode[k])) {
                EXPECT_NEAR(P_t, slip_ratio(law.friction, way_of(found->mode[k])) * P_n, 1e-12);
                EXPECT_LE(P_t * found->slip_velocity[k], 1e-12);
            }
            work += 0.5 * P_n * (meeting.gap_velocity[k] + found->gap_velocity[k]) +
                    0.5 * P_t * (meeting.slip_velocity[k] + found->slip_velocity[k]);
        }
        EXPECT_LE(work, 1e-12);
    }
}

TEST(ContactImpulses, OfOneContactAreThoseOfTheLaw) {
    model::PlateJoint joint;
    joint.contact.kinetic_friction = 0.3;
    const ModalStructure structure = modal_structure(model::joints_on_plate(std::array{joint}, {}));
    support::CounterRandom random(3);
    // along and across the plate nothing couples: m_g = m1 m2/(m1 + m2), m_x = m1
    const model::ContactInertia inertia{0.1 * 0.4 / 0.5, 0.1, 0.0};
    for (int trial = 0; trial < 200; ++trial) {
        const model::Approach approach{random.between(-1.0, -0.01), random.between(-1.0, 1.0)};
        const model::Impulses wanted = impulses(model::Plastic{}, inertia, model::Coulomb{0.8, 0.3}, approach);
        const auto found = contact_impulses(
            structure, {{approach.gap_velocity}, {approach.slip_velocity}, {ContactMode::stick}, {true}});
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->normal[0], wanted.normal, 1e-14);
        EXPECT_NEAR(found->tangential[0], wanted.tangential, 1e-14);
        EXPECT_EQ(found->mode[0] == ContactMode::stick, wanted.stops);
    }
}

// contacts that stand for the same point cannot share an impulse
TEST(ContactImpulses, AreNotDeterminedWhereContactsDependOnEachOther) {
    ModalStructure structure = three_joints();
    structure.contacts.resize(2);
    structure.contacts[1] = structure.contacts[0];
    const Eigen::Matrix2d one = structure.compliance.topLeftCorner<2, 2>();
    structure.compliance.resize(4, 4);
    structure.compliance << one, one, one, one;
    EXPECT_FALSE(contact_impulses(structure,
                                  {{-1.0, -1.0}, {0.0, 0.0}, {ContactMode::stick, ContactMode::stick}, {true, true}}));
}

}  // namespace
}  // namespace stridor::integration
