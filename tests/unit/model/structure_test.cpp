#include "stridor/model/structure.hpp"

#include "support/error_text.hpp"

#include <gtest/gtest.h>

namespace stridor::model {
namespace {

using support::Thrown;
using support::thrown_by;

TEST(Structure, BeginsWithZerosOfItsSize) {
    const Structure structure = structure_of_size(4, 2);
    EXPECT_EQ(dofs_of(structure), 4);
    EXPECT_EQ(structure.mass, Eigen::MatrixXd::Zero(4, 4));
    EXPECT_EQ(structure.damping, Eigen::MatrixXd::Zero(4, 4));
    EXPECT_EQ(structure.stiffness, Eigen::MatrixXd::Zero(4, 4));
    EXPECT_EQ(structure.load, Eigen::VectorXd::Zero(4));
    ASSERT_EQ(structure.contacts.size(), 2U);
    EXPECT_EQ(structure.contacts[1].normal, Eigen::VectorXd::Zero(4));
    EXPECT_EQ(structure.contacts[1].tangent, Eigen::VectorXd::Zero(4));
    EXPECT_EQ(structure.contacts[1].drive_share, 1.0);
}

TEST(OnlyContact, IsTheOneThatIsClosedAndFullyDriven) {
    const Structure structure = structure_of_size(3);
    EXPECT_EQ(&only_contact(structure, "a solver"), &structure.contacts.front());
}

TEST(OnlyContact, IsRefusedByTheNameOfWhoCannotSolveIt) {
    const auto refusal = [](const Structure& structure) {
        const Thrown thrown = thrown_by([&] { only_contact(structure, "the slow engine"); });
        EXPECT_EQ(thrown.kind, ErrorKind::input);
        EXPECT_TRUE(thrown.says("the slow engine")) << thrown.message;
        return thrown.message;
    };
    const auto says = [](const std::string& message, const char* words) {
        return message.find(words) != std::string::npos;
    };
    EXPECT_TRUE(says(refusal(structure_of_size(3, 0)), "0 contacts"));
    EXPECT_TRUE(says(refusal(structure_of_size(3, 2)), "2 contacts"));
    Structure open = structure_of_size(3);
    open.contacts.front().initial_gap = 0.002;
    EXPECT_TRUE(says(refusal(open), "0.002 m"));
    Structure shared = structure_of_size(3);
    shared.contacts.front().drive_share = 0.5;
    EXPECT_TRUE(says(refusal(shared), "share of the drive: 0.5"));
}

}  // namespace
}  // namespace stridor::model
