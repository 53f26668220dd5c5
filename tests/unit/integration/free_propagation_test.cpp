#include "stridor/integration/steps/free_propagation.hpp"

#include "stridor/model/structure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace stridor::integration {
namespace {

// one mass of 2 kg on a spring and a dashpot, with a load
model::Structure oscillator(double stiffness, double damping) {
    model::Structure structure = model::structure_of_size(1);
    structure.mass(0, 0) = 2.0;
    structure.stiffness(0, 0) = stiffness;
    structure.damping(0, 0) = damping;
    structure.load(0) = 3.0;
    structure.contacts.clear();
    return structure;
}

struct Place {
    double u, v;
};

Place after_a_step(const model::Structure& structure, double step, double u, double v, double force) {
    const ModalStructure modal = modal_structure(structure);
    const FreePropagation propagation(modal, step);
    const double shape = modal.shapes(0, 0);
    std::vector<double> q{u / shape}, rate{v / shape};
    propagation.advance(q, rate);
    propagation.push({shape * force}, q, rate);
    return {shape * q[0], shape * rate[0]};
}

TEST(FreePropagation, IsThatOfADampedOscillatorForStepsOfAnySize) {
    constexpr double stiffness = 800.0, damping = 4.0, force = 5.0;  // w0 = 20 1/s, decay 1 1/s
    const double omega = std::sqrt(399.0);
    for (const double step : {1e-6, 0.01, 0.3, 2.0}) {
        const double rest = (3.0 + force) / stiffness;
        const double u0 = 0.02 - rest, v0 = 0.7;
        const double decay = std::exp(-step), c = std::cos(omega * step), s = std::sin(omega * step);
        const Place found = after_a_step(oscillator(stiffness, damping), step, 0.02, 0.7, force);
        EXPECT_NEAR(found.u, rest + decay * (u0 * c + (v0 + u0) / omega * s), 1e-15);
        EXPECT_NEAR(found.v, decay * (v0 * c - (400.0 * u0 + v0) / omega * s), 1e-14);
    }
}

TEST(FreePropagation, IsThatOfAFreeMassWithoutSpring) {
    const Place found = after_a_step(oscillator(0.0, 0.0), 0.1, 0.5, 2.0, 1.0);
    EXPECT_NEAR(found.u, 0.5 + 2.0 * 0.1 + 0.5 * 2.0 * 0.01, 1e-15);  // (3 + 1) N on 2 kg
    EXPECT_NEAR(found.v, 2.0 + 2.0 * 0.1, 1e-15);
}

// a damping that couples modes takes the other way of computing
TEST(FreePropagation, IsTheSameWhetherModesAreCoupledOrNot) {
    model::Structure structure = model::structure_of_size(2);
    structure.mass = Eigen::Vector2d(1.0, 2.0).asDiagonal();
    structure.stiffness << 300.0, -100.0, -100.0, 200.0;
    structure.damping = 0.01 * structure.stiffness;
    structure.load << 1.0, -2.0;
    structure.contacts.front().normal << 0.0, 1.0;
    structure.contacts.front().tangent << 1.0, 0.0;
    const ModalStructure by_mode = modal_structure(structure);
    ASSERT_TRUE(by_mode.is_damped_by_mode());
    ModalStructure whole = by_mode;
    whole.damping = {by_mode.damping[0], 0.0, 0.0, by_mode.damping[1]};
    const FreePropagation one(by_mode, 0.05), other(whole, 0.05);
    std::vector<double> q{0.1, -0.2}, v{1.0, 0.5}, q_other = q, v_other = v;
    one.advance(q, v);
    one.push({0.3, 0.4}, q, v);
    other.advance(q_other, v_other);
    other.push({0.3, 0.4}, q_other, v_other);
    for (std::size_t j = 0; j < 2; ++j) {
        EXPECT_NEAR(q[j], q_other[j], 1e-15);
        EXPECT_NEAR(v[j], v_other[j], 1e-14);
    }
    EXPECT_LT((one.response() - other.response()).cwiseAbs().maxCoeff(), 1e-16);
}

// for short steps a contact force acts on inertia alone
TEST(FreePropagation, RespondsWithTheComplianceOfMassTimesTheStep) {
    model::Structure structure = model::structure_of_size(2);
    structure.mass << 1.0, 0.3, 0.3, 2.0;
    structure.stiffness = 100.0 * Eigen::Matrix2d::Identity();
    structure.contacts.front().normal << 0.0, 1.0;
    structure.contacts.front().tangent << 1.0, 0.0;
    const ModalStructure modal = modal_structure(structure);
    constexpr double step = 1e-5;
    // (w h)²/6 of 100/0.9 1/s²
    EXPECT_LT((FreePropagation(modal, step).response() / step - modal.compliance).cwiseAbs().maxCoeff(), 1e-7);
}

}  // namespace
}  // namespace stridor::integration
