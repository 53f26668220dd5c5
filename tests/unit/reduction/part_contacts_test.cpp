#include "stridor/reduction/part_contacts.hpp"

#include "stridor/reduction/craig_bampton.hpp"
#include "support/structures/lattice_part.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stridor::reduction {
namespace {

using support::lattice_part;
using support::LatticeSupport;

PartContacts contacts_of(const ElasticPart& part) {
    const std::optional<PartContacts> contacts = part_contacts(part, named_rows(part, "FOOT"), 3);
    EXPECT_TRUE(contacts.has_value());
    return contacts.value_or(PartContacts{});
}

// consistent mass couples neighbours in the mesh, and more when it is reduced; lumped contact inertia does not
TEST(PartContacts, ShareInertiaUnlessItIsLumped) {
    const ElasticPart part = lattice_part({5, 3, 4}, LatticeSupport::top_held);
    const PartContacts meshed = contacts_of(part);
    EXPECT_EQ(meshed.rows, 45);
    EXPECT_GT(meshed.shared_inertia, 0.01);

    ReductionRequest request{.boundary = named_rows(part, "FOOT"), .modes = 12};
    request.inertia = BoundaryInertia::consistent;
    const std::vector<base::Problem> found = doubts(contacts_of(craig_bampton(part, request).part), 0.8);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NE(found[0].suggestion.find("--inertia lumped"), std::string::npos);
    request.inertia = BoundaryInertia::lumped;
    const PartContacts lumped = contacts_of(craig_bampton(part, request).part);
    EXPECT_LT(lumped.shared_inertia, 1e-9);
    EXPECT_TRUE(doubts(lumped, 0.8).empty());
}

// one node, whose mass couples its normal and its tangent: mu = 1/0.8
TEST(PartContacts, TellTheFrictionOfPainleve) {
    ElasticPart part;
    part.labels = {{"1", 1}, {"1", 3}};
    part.mass.resize(2, 2);
    part.mass.insert(0, 0) = part.mass.insert(1, 1) = 1.0;
    part.mass.insert(0, 1) = part.mass.insert(1, 0) = 0.8;
    part.stiffness = part.mass;
    const PartContacts contacts = part_contacts(part, {0, 1}, 3).value();
    ASSERT_TRUE(contacts.painleve_friction);
    EXPECT_NEAR(*contacts.painleve_friction, 1.25, 1e-14);
    EXPECT_EQ(describe(contacts.weakest), "1.3");
    EXPECT_TRUE(doubts(contacts, 1.2).empty());
    ASSERT_EQ(doubts(contacts, 1.3).size(), 1U);
    EXPECT_EQ(doubts(contacts, 1.3)[0].what, "1.3 is a configuration of Painleve from a friction of 1.25 on");
    EXPECT_FALSE(part_contacts(part, {0, 1}, 0).value().painleve_friction);
}

TEST(PartContacts, AreNotKnownWhereAMotionHasNoMass) {
    ElasticPart part = lattice_part({3, 3, 3}, LatticeSupport::top_held);
    for (Eigen::Index column = 0; column < part.mass.outerSize(); ++column)
        for (SparseMatrix::InnerIterator entry(part.mass, column); entry; ++entry)
            if (entry.row() == 0 || column == 0) entry.valueRef() = 0.0;
    EXPECT_FALSE(part_contacts(part, named_rows(part, "FOOT"), 3).has_value());
}

}  // namespace
}  // namespace stridor::reduction
