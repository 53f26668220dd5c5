// The beam by its modes is the beam of the textbook; how it moves is in tests/verification/beam_test.cpp.

#include "stridor/model/built/cantilever.hpp"

#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stridor::model {
namespace {

constexpr double pi = 3.14159265358979323846;

// A force at the tip bends by F L^3 / (3 E I) and compresses by F L / (E A). In series: with n modes the missing
// share of the bending is the sum of 12 / (beta_k L)^4 beyond, about 12 / (3 pi^4 (n - 1)^3); of the compression the
// first mode has 8 / pi^2.
TEST(Cantilever, YieldsAtItsTipAsItsStiffnessesSay) {
    const Cantilever beam;
    constexpr int modes = 30;
    const Structure structure = cantilever(beam, modes);
    const ContactPoint& tip = structure.contacts.front();
    ASSERT_EQ(dofs_of(structure), modes + 1);
    const double cosine = 0.5;  // of 60 degrees
    const double sine = std::sqrt(0.75);
    const double bent = std::pow(beam.length, 3) / (3.0 * beam.bending_stiffness);
    const double compressed = 8.0 / (pi * pi) * beam.length / beam.axial_stiffness;
    const auto moved = [&](const Eigen::VectorXd& along, const Eigen::VectorXd& force) {
        return along.dot(force.cwiseQuotient(structure.stiffness.diagonal()));
    };
    const double lost = 12.0 / (3.0 * std::pow(pi, 4) * std::pow(modes - 1, 3)) * bent;
    const double normal = cosine * cosine * bent + sine * sine * compressed;
    const double tangent = sine * sine * bent + cosine * cosine * compressed;
    const double coupled = sine * cosine * (compressed - bent);
    EXPECT_NEAR(moved(tip.normal, tip.normal), normal, 2.0 * lost);
    EXPECT_NEAR(moved(tip.tangent, tip.tangent), tangent, 2.0 * lost);
    EXPECT_NEAR(moved(tip.normal, tip.tangent), coupled, 2.0 * lost);
    // pressed on the surface by the preload
    EXPECT_NEAR(moved(tip.normal, structure.load), -beam.preload * normal, 2.0 * lost * beam.preload);
}

TEST(Cantilever, DampsEachModeAlike) {
    Cantilever beam;
    beam.damping_ratio = 0.03;
    const Structure structure = cantilever(beam, 4);
    for (Eigen::Index k = 0; k < 5; ++k) {
        const double critical = 2.0 * std::sqrt(structure.stiffness(k, k) * structure.mass(k, k));
        EXPECT_NEAR(structure.damping(k, k), 0.03 * critical, 1e-12 * critical) << k;
    }
    EXPECT_EQ(structure.stiffness(2, 2), std::pow(bending_frequency(beam, 3), 2));
}

// the modes have the mean square 1/m, whatever their number: the trapezoidal rule over 4000 steps is exact to 1e-4
TEST(Cantilever, HasTheShapesOfItsModes) {
    const Cantilever beam;
    constexpr int modes = 12, steps = 4000;
    const Structure structure = cantilever(beam, modes);
    const ContactPoint& tip = structure.contacts.front();
    const BeamShape end = cantilever_shape(beam, modes, 1.0), clamp = cantilever_shape(beam, modes, 0.0);
    const double size = 2.0 / std::sqrt(beam.mass_per_length * beam.length);
    EXPECT_LT((end.along - tip.tangent).norm(), 1e-11 * size);
    EXPECT_LT((end.across - tip.normal).norm(), 1e-11 * size);
    EXPECT_LT(clamp.along.norm() + clamp.across.norm(), 1e-11 * size);
    Eigen::VectorXd squares = Eigen::VectorXd::Zero(modes + 1);
    for (int k = 0; k <= steps; ++k) {
        const BeamShape shape = cantilever_shape(beam, modes, static_cast<double>(k) / steps);
        const double part = (k == 0 || k == steps ? 0.5 : 1.0) / steps;
        squares += part * (shape.along.cwiseAbs2() + shape.across.cwiseAbs2());
    }
    for (int k = 0; k <= modes; ++k)
        EXPECT_NEAR(squares(k) * beam.mass_per_length * beam.length, 1.0, 1e-3) << k;
}

TEST(Cantilever, BendsWithManyModes) {
    const Structure structure = cantilever({}, 900);
    EXPECT_TRUE(structure.stiffness.allFinite());
    const double quarter_turns = 2.0 * 900.0 - 1.0;  // of the last mode, next to a beam without ends
    EXPECT_NEAR(bending_frequency({}, 900) / bending_frequency({}, 450), std::pow(quarter_turns / 899.0, 2), 1e-9);
}

TEST(Cantilever, BendsWithOneModeAtLeast) {
    const auto thrown = support::thrown_by([] { cantilever({}, 0); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("0 modes")) << thrown.message;
}

}  // namespace
}  // namespace stridor::model
