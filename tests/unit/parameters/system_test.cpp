#include "stridor/parameters/system.hpp"

#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/start.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace stridor::parameters {
namespace {

// two rows, the first of which rubs along the difference of both
Case own_case() {
    OwnStructure own;
    own.origin = "two blocks";
    own.row = {"a", "b"};
    own.mass = own.stiffness = {1.0, 0.0, 0.0, 1.0};
    OwnContact contact;
    contact.name = "lip";
    contact.normal = {0.0, 1.0};
    contact.tangent = {1.0, -1.0};
    contact.drive_share = 0.5;
    contact.preload_share = 1.0;
    own.contacts = {contact};
    Case c;
    c.own_structure = std::make_shared<const OwnStructure>(std::move(own));
    return c;
}

TEST(System, IsOneJointTwoJointsOrAStructure) {
    const Case joint, lips = two_lips(), own = own_case();
    EXPECT_EQ(coordinate_names(joint), (std::vector<std::string>{"x1", "y1", "y2"}));
    EXPECT_EQ(coordinate_names(lips),
              (std::vector<std::string>{"x_upper", "y_upper", "x_lower", "y_lower", "y_plate"}));
    EXPECT_EQ(coordinate_names(own), (std::vector<std::string>{"a", "b"}));
    for (const Case* c : {&joint, &lips, &own})
        EXPECT_EQ(coordinate_names(*c).size(), coordinate_count(*c));
    EXPECT_EQ(channel_count(joint), 3U);
    EXPECT_EQ(channel_count(lips), 5U);
    EXPECT_EQ(channel_count(own), 2U);
    EXPECT_TRUE(has_plate(joint) && has_plate(lips) && !has_plate(own));
    EXPECT_TRUE(has_one_joint(joint) && !has_one_joint(lips) && !has_one_joint(own));
    EXPECT_EQ(told_name(joint, 0), "");
    EXPECT_EQ(told_name(lips, 1), "lower");
    EXPECT_EQ(told_name(own, 0), "lip");
    EXPECT_EQ(origin_of(joint), "joint on a plate");
    EXPECT_EQ(origin_of(lips), "2 joints on a plate");
    EXPECT_EQ(origin_of(own), "two blocks");
}

TEST(System, SaysWhatMovesTheRubbingPoint) {
    using Weights = std::vector<double>;
    EXPECT_EQ(point_weights({}, 0, PointAxis::sliding), (Weights{1.0, 0.0, 0.0}));
    EXPECT_EQ(point_weights({}, 0, PointAxis::normal), (Weights{0.0, 1.0, 0.0}));
    EXPECT_EQ(point_weights(two_lips(), 1, PointAxis::normal), (Weights{0.0, 0.0, 0.0, 1.0, 0.0}));
    EXPECT_EQ(point_weights(own_case(), 0, PointAxis::sliding), (Weights{1.0, -1.0}));
    EXPECT_EQ(drive_share_at({}, 0), 1.0);
    EXPECT_EQ(drive_share_at(own_case(), 0), 0.5);
}

TEST(System, HasAKeyForEachJointOnlyWhereThereAreSeveral) {
    const Case joint, lips = two_lips();
    const Field &mass = *find_field("joint.mass"), &drive = *find_field("drive.velocity");
    EXPECT_EQ(key_at(joint, mass), "joint.mass");
    EXPECT_EQ(key_at({lips, 1}, mass), "joint.lower.mass");
    EXPECT_EQ(key_at({lips, 1}, drive), "drive.velocity");
    EXPECT_TRUE(has_key_of_joint(lips, mass) && !has_key_of_joint(lips, drive) && !has_key_of_joint(joint, mass));
}

TEST(System, SharesItsFrictionWhereAContactHadItsOwn) {
    Case c = own_case();
    OwnStructure own = *c.own_structure;
    own.contacts.front().kinetic_friction = 0.1;
    c.own_structure = std::make_shared<const OwnStructure>(std::move(own));
    EXPECT_EQ(contact_of(c, 0).kinetic_friction, 0.1);
    share_friction(c);
    EXPECT_EQ(contact_of(c, 0).kinetic_friction, c.contact().kinetic_friction);
    Case joint;
    share_friction(joint);  // has none
    EXPECT_EQ(contact_of(joint, 0).kinetic_friction, Case{}.contact().kinetic_friction);
}

// what a run ended with is where the next one begins
TEST(CaseStart, IsWhatWasSet) {
    const CaseStart lips_start{{1e-3, 0.0, 2e-3, 5e-4, 0.0},
                               {0.1, 0.0, -0.2, 0.3, 0.0},
                               {ContactStart::stick, ContactStart::separation},
                               {0.0, 0.25},
                               {2.0, 0.0}};
    Case lips = two_lips();
    set_start(lips, lips_start);
    EXPECT_EQ(lips.run.initial, Initial::given);
    const CaseStart read = start_of(lips, 0.1);
    EXPECT_EQ(read.displacement, lips_start.displacement);
    EXPECT_EQ(read.velocity, lips_start.velocity);
    EXPECT_EQ(read.friction_states, lips_start.friction_states);
    EXPECT_EQ(read.contacts.front(), ContactStart::stick);
    EXPECT_EQ(lips.joints[0].contact.rested, 2.0);
    // a joint that sticks moves with its surface, whatever its number was
    EXPECT_EQ(start_of(lips, -0.4).velocity.front(), -0.4);

    Case own = own_case();
    EXPECT_EQ(start_of(own, 1.0).displacement, (std::vector<double>{0.0, 0.0}));
    const CaseStart own_start{{1e-3, 2e-3}, {0.1, 0.2}, {ContactStart::slip}, {0.5}, {1.5}};
    set_start(own, own_start);
    EXPECT_EQ(start_of(own, 1.0).displacement, own_start.displacement);
    EXPECT_EQ(start_of(own, 1.0).velocity, own_start.velocity);
    EXPECT_EQ(start_of(own, 1.0).friction_states, own_start.friction_states);
    EXPECT_EQ(own.own_structure->contacts.front().rested, 1.5);
}

}  // namespace
}  // namespace stridor::parameters
