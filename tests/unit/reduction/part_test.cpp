#include "stridor/reduction/part.hpp"

#include "stridor/reduction/lowest_modes.hpp"
#include "support/error_text.hpp"
#include "support/structures/lattice_part.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace stridor::reduction {
namespace {

using support::chain_part;
using support::lattice_part;
using support::LatticeSupport;
using support::thrown_by;

void expect_refusal(const ElasticPart& part, const std::string& sentence) {
    const auto thrown = thrown_by([&] { expect_sound(part); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says(sentence)) << thrown.message;
}

TEST(ElasticPart, OfSoundMatricesIsTaken) {
    EXPECT_NO_THROW(expect_sound(chain_part(4, 1.0, 1.0)));
    EXPECT_NO_THROW(expect_sound(lattice_part({3, 3, 3}, LatticeSupport::free)));
}

TEST(ElasticPart, WithRowsOfNoMassIsTaken) {
    ElasticPart part = chain_part(5, 1e3, 0.1);
    part.mass.coeffRef(2, 2) = 0.0;
    EXPECT_NO_THROW(expect_sound(part));
}

// products of its numbers leave double precision, the matrix does not
TEST(ElasticPart, OfVeryLargeNumbersIsLookedAt) {
    ElasticPart part = chain_part(4, 1e200, 1e200);
    EXPECT_NO_THROW(expect_sound(part));
    part.stiffness.coeffRef(0, 1) *= 2.0;
    expect_refusal(part, "the stiffness is not symmetric");
}

TEST(ElasticPart, WithoutRowsIsRefused) {
    expect_refusal({}, "the part has no row");
}

TEST(ElasticPart, WithALabelTwiceIsRefused) {
    ElasticPart part = chain_part(4, 1.0, 1.0);
    part.labels[3] = part.labels[1];
    expect_refusal(part, "the label 2.1 stands for two rows");
}

TEST(ElasticPart, WithARowWithoutLabelIsRefused) {
    ElasticPart part = chain_part(4, 1.0, 1.0);
    part.labels[2] = {};
    expect_refusal(part, "row 3 has no label");
    part.labels.pop_back();
    expect_refusal(part, "there are 3 labels for 4 rows");
}

TEST(ElasticPart, WithMatricesOfTwoModelsIsRefused) {
    ElasticPart part = chain_part(4, 1.0, 1.0);
    part.mass = chain_part(3, 1.0, 1.0).mass;
    expect_refusal(part, "the stiffness has 4 rows, the mass 3");
    part.mass = chain_part(4, 1.0, 1.0).mass;
    part.damping = chain_part(3, 1.0, 1.0).mass;
    expect_refusal(part, "the stiffness has 4 rows, the damping 3");
}

TEST(ElasticPart, WithAnUnsymmetricMatrixIsRefusedAtItsPlace) {
    ElasticPart part = chain_part(4, 1.0, 1.0);
    part.stiffness.coeffRef(1, 2) *= 1.0 + 1e-11;  // the last digits of a file
    EXPECT_NO_THROW(expect_sound(part));
    part.stiffness.coeffRef(1, 2) *= 1.0 + 1e-8;
    expect_refusal(part, "the stiffness is not symmetric (at ");
    part = chain_part(4, 1.0, 1.0);
    part.mass.coeffRef(0, 3) = 0.01;  // nothing stands across the diagonal
    expect_refusal(part, "the mass is not symmetric");
}

TEST(ElasticPart, WithWhatIsNoNumberIsRefused) {
    ElasticPart part = chain_part(4, 1.0, 1.0);
    part.stiffness.coeffRef(1, 1) = std::numeric_limits<double>::quiet_NaN();
    expect_refusal(part, "the stiffness holds nan at 2.1, 2.1");
}

TEST(ElasticPart, WithNegativeMassIsRefused) {
    ElasticPart part = chain_part(4, 1.0, 1.0);
    part.mass.coeffRef(1, 1) = -1.0;
    expect_refusal(part, "row 2.1 has -1 on its diagonal");
    part.mass.coeffRef(1, 1) = 1.0;
    part.mass.coeffRef(0, 1) = part.mass.coeffRef(1, 0) = 1.5;  // indefinite, with a positive diagonal
    expect_refusal(part, "the mass is negative for some motion (1 of its pivots are negative)");
}

TEST(ElasticPart, WithoutMassIsRefused) {
    ElasticPart part = chain_part(4, 1.0, 0.0);
    expect_refusal(part, "the part has no mass");
}

TEST(ElasticPart, WithALooseRowIsRefused) {
    ElasticPart part = chain_part(4, 1.0, 1.0);
    part.stiffness.coeffRef(3, 3) = part.stiffness.coeffRef(2, 3) = part.stiffness.coeffRef(3, 2) = 0.0;
    part.mass.coeffRef(3, 3) = 0.0;
    expect_refusal(part, "row 4.1 has neither stiffness nor mass");
}

// the same steel written in other units has the same frequencies and energies
TEST(ElasticPart, InOtherUnitsIsTheSameInSi) {
    const ElasticPart si = lattice_part({3, 2, 2}, LatticeSupport::top_held);
    for (const UnitSystem& units : unit_systems()) {
        ElasticPart foreign = si;
        foreign.stiffness *= units.time * units.time / units.mass;
        foreign.mass *= 1.0 / units.mass;
        foreign.damping = units.time / units.mass * si.mass;
        for (auto& [node, position] : foreign.positions)
            position /= units.length;
        const ElasticPart back = in_si(foreign, units);
        EXPECT_LT((back.stiffness - si.stiffness).norm(), 1e-14 * si.stiffness.norm()) << units.name;
        EXPECT_LT((back.mass - si.mass).norm(), 1e-14 * si.mass.norm()) << units.name;
        EXPECT_LT((back.damping - si.mass).norm(), 1e-14 * si.mass.norm()) << units.name;
        EXPECT_LT((back.positions.at("101") - si.positions.at("101")).norm(), 1e-17) << units.name;
    }
    EXPECT_TRUE(thrown_by([] { unit_system("inch"); }).says("\"inch\" is no system of units"));
}

// a beam element in mm and t: N, N*mm and radians
TEST(ElasticPart, KeepsTheRadiansOfRotations) {
    ElasticPart part = chain_part(2, 12.0, 1.0);
    part.labels = {{"1", 2}, {"1", 6}};
    part.stiffness.coeffRef(1, 1) = 4e6;                                  // [N*mm] of a rotation
    part.stiffness.coeffRef(0, 1) = part.stiffness.coeffRef(1, 0) = 6e3;  // [N]
    const ElasticPart si = in_si(part, unit_system("mm-t-s"));
    EXPECT_DOUBLE_EQ(si.stiffness.coeff(0, 0), 24e3);  // [N/m]
    EXPECT_DOUBLE_EQ(si.stiffness.coeff(0, 1), 6e3);   // [N]
    EXPECT_DOUBLE_EQ(si.stiffness.coeff(1, 1), 4e3);   // [N*m]
    EXPECT_DOUBLE_EQ(si.mass.coeff(0, 0), 1e3);        // [kg]
    EXPECT_DOUBLE_EQ(si.mass.coeff(1, 1), 1e-3);       // [kg*m^2]
}

TEST(NamedRows, AreASetItsComponentsANodeOrARow) {
    const ElasticPart part = lattice_part({2, 2, 2}, LatticeSupport::free);
    EXPECT_EQ(named_rows(part, "foot").size(), 12U);
    EXPECT_EQ(named_rows(part, "FOOT:13").size(), 8U);
    EXPECT_EQ(named_rows(part, "107"), (std::vector<Eigen::Index>{21, 22, 23}));
    EXPECT_EQ(named_rows(part, "107:2"), (std::vector<Eigen::Index>{22}));
    EXPECT_EQ(named_rows(part, "107.2"), (std::vector<Eigen::Index>{22}));
}

TEST(NamedRows, OfSeveralNamesStandOnce) {
    const ElasticPart part = chain_part(4, 1.0, 1.0);
    const std::vector<std::string> names{"3", "1.1", "3.1", "2"};
    EXPECT_EQ(named_rows(part, names), (std::vector<Eigen::Index>{2, 0, 1}));
}

TEST(NamedRows, RefuseWhatIsNotThere) {
    ElasticPart part = lattice_part({2, 2, 2}, LatticeSupport::free);
    EXPECT_TRUE(thrown_by([&] { named_rows(part, "HEAD"); }).says("its node sets are FOOT"));
    EXPECT_TRUE(thrown_by([&] { named_rows(part, "999"); }).says("\"999\" is no set, node or row"));
    EXPECT_TRUE(thrown_by([&] { named_rows(part, "FOOT:7"); }).says("names no components"));
    EXPECT_TRUE(thrown_by([&] { named_rows(part, "FOOT:6"); }).says("node 100 has no row for component 6"));
    part.positions["55"] = {0.0, 0.0, 0.0};
    EXPECT_TRUE(thrown_by([&] { named_rows(part, "55"); }).says("node 55 has no row (a support"));
}

}  // namespace
}  // namespace stridor::reduction
