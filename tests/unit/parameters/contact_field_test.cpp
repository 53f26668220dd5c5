#include "stridor/parameters/fields/contact_field.hpp"

#include "stridor/parameters/system.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <set>
#include <string_view>

namespace stridor::parameters {
namespace {

TEST(ContactFields, HaveAKeyEachAndNothingUsualIsMissing) {
    const OwnContact usual;
    std::set<std::string_view> keys;
    for (const ContactField& field : contact_fields()) {
        EXPECT_TRUE(keys.insert(field.key).second) << field.key;
        EXPECT_FALSE(field.sentence.empty());
        EXPECT_TRUE(is_usual(usual, field)) << field.key;
        EXPECT_EQ(&contact_field(field.key), &field);
        if (field.only_beside.empty()) continue;
        EXPECT_EQ(contact_field(field.only_beside).key, field.only_beside);
    }
    EXPECT_EQ(keys.size(), first_contact_fields + 2);  // and rest and friction state at the start
}

TEST(ContactFields, TakeThePlaceOfTheCasesNumbers) {
    auto own = std::make_shared<OwnStructure>();
    own->contacts.resize(2);
    own->contacts[1].static_friction = 0.9;
    own->contacts[1].kinetic_friction = 0.0;
    own->contacts[1].preload_share = 2.0;
    Case c;
    c.own_structure = own;
    EXPECT_EQ(contact_of(c, 0).static_friction, c.contact().static_friction);
    EXPECT_EQ(contact_of(c, 0).preload, 0.0);
    EXPECT_EQ(contact_of(c, 1).static_friction, 0.9);
    EXPECT_EQ(contact_of(c, 1).kinetic_friction, 0.0);
    EXPECT_EQ(contact_of(c, 1).preload, c.contact().preload);
}

// it names what is kept in stores and libraries
TEST(OwnStructure, HasTheHashThatItHadBefore) {
    OwnStructure own;
    own.mass = {1, 0, 0, 2};
    own.stiffness = {3, -1, -1, 4};
    own.contacts.push_back({.name = "tip", .normal = {0, 1}, .tangent = {-1, 0}, .initial_gap = -1e-3});
    own.contacts.push_back({.name = "pad",
                            .normal = {1, 1},
                            .tangent = {1, 0},
                            .second_tangent = {0, 1},
                            .interface = "edge",
                            .static_friction = 0.7,
                            .kinetic_friction = 0.1,
                            .preload_share = 2.0,
                            .drive_share = 0.5,
                            .second_drive_share = 0.25,
                            .position = std::array{1.0, 2.0, 3.0}});
    EXPECT_EQ(content_hash(own), "874727d21cfb432e");
}

}  // namespace
}  // namespace stridor::parameters
