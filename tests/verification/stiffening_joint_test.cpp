// The paper's joint on springs that stiffen: held against the exact engine where they are straight, against a structure
// of its matrices with the same springs, and against its own small motions.

#include "stridor/analysis/sliding_stability.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/model/built/case_structure.hpp"
#include "stridor/model/linear/linearised.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/parameters/rules/engines.hpp"
#include "support/effort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace stridor {
namespace {

using parameters::Case;
using parameters::Joint;
using parameters::Stiffening;

constexpr double degree = 3.14159265358979323846 / 180.0;

// squeals by mode coupling: going alone, 50 ms
Case driven_joint() {
    Case c = parameters::paper_case(parameters::PaperCase::squeal);
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = 0.1;
    c.run.initial = parameters::Initial::stuck;
    c.run.early_ending = parameters::EarlyEnding::never;
    c.run.duration = c.run.window = 0.05;
    return c;
}

record::ContactHistory states_of_joint(const Case& c) {
    const integration::Motion motion = integration::simulate(c, record::Request{record::KeepHistory::yes, {}});
    EXPECT_EQ(motion.outcome.reason, integration::Reason::completed);
    EXPECT_LT(std::abs(motion.energy.relative_residual()), 1e-11);
    return motion.record.histories.front();
}

void expect_same_instants(const record::ContactHistory& found, const record::ContactHistory& expected,
                          double tolerance) {
    ASSERT_GT(expected.size(), 20U);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
        EXPECT_EQ(found[k].state, expected[k].state) << k;
        EXPECT_NEAR(found[k].from, expected[k].from, tolerance) << k;
    }
}

TEST(StiffeningJoint, OnAStraightTableIsTheStifferJoint) {
    Case c = driven_joint();
    const double k = 2e6;  // [N/m]
    c.joint().axial_stiffness -= k;
    c.joint().stiffening = Stiffening::table;
    c.joint().axial_force = {"", {-1e-4, -2e-5, 0.0, 3e-6, 1e-4}, {}};
    for (const double e : c.joint().axial_force.deflections)
        c.joint().axial_force.forces.push_back(k * e);
    ASSERT_EQ(parameters::methods_of(c), std::vector{parameters::Method::taylor});
    const Case stiffer = driven_joint();
    ASSERT_EQ(parameters::methods_of(stiffer), std::vector{parameters::Method::exact});
    expect_same_instants(states_of_joint(c), states_of_joint(stiffer), 1e-12);
}

// M, C, K of the joint without its springs, which stand in a list; they bear sin and cos of its angle of the preload
std::shared_ptr<const parameters::OwnStructure> structure_of_joint(const Case& c) {
    Case linear = c;
    linear.joint().stiffening = Stiffening::none;
    const model::Structure joint = model::structure_of(linear);
    const auto numbers = [](const Eigen::MatrixXd& m) { return std::vector<double>(m.data(), m.data() + m.size()); };
    parameters::OwnStructure own;
    own.row = {"x1", "y1", "y2"};
    own.mass = numbers(joint.mass), own.stiffness = numbers(joint.stiffness), own.damping = numbers(joint.damping);
    own.contacts.resize(1);
    own.contacts[0].normal = {0.0, 1.0, -1.0};
    own.contacts[0].tangent = {1.0, 0.0, 0.0};
    own.contacts[0].preload_share = 1.0;
    const double cosine = std::cos(c.joint().incidence_angle * degree);
    const double sine = std::sin(c.joint().incidence_angle * degree);
    // the linear part stands in the springs, so that both bear the preload
    const auto add = [&](std::vector<double> direction, double stiffness, double cubic, double share) {
        parameters::OwnSpring spring;
        spring.name = "spring" + std::to_string(own.springs.size());
        spring.direction = std::move(direction);
        spring.stiffness = stiffness;
        spring.cubic = cubic;
        spring.preload_share = share;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                own.stiffness[3 * i + j] -= stiffness * spring.direction[i] * spring.direction[j];
        own.springs.push_back(std::move(spring));
    };
    add({cosine, sine, 0.0}, c.joint().axial_stiffness, c.joint().axial_cubic, sine);
    add({-sine, cosine, 0.0}, c.joint().flexural_stiffness, c.joint().flexural_cubic, cosine);
    return std::make_shared<const parameters::OwnStructure>(std::move(own));
}

TEST(StiffeningJoint, IsTheStructureWithItsSprings) {
    Case c = driven_joint();
    c.joint().stiffening = Stiffening::cubic;
    c.joint().axial_cubic = 4e17;  // [N/m³] some 15 % of the axial stiffness at rest
    c.joint().flexural_cubic = 5e15;
    c.run.duration = c.run.window = 0.04;  // [s] rounding grows from event to event
    const record::ContactHistory states = states_of_joint(c);
    Case same = c;
    same.own_structure = structure_of_joint(c);
    expect_same_instants(states, states_of_joint(same), 1e-11);
}

Case pressed_cubic_joint(double preload) {
    Case c = driven_joint();
    c.contact().preload = preload;
    c.joint().stiffening = Stiffening::cubic;
    c.joint().axial_cubic = 4e17;
    return c;
}

// k e + k3 e³ = F sin a at rest; its tangent decides the small motions
TEST(StiffeningJoint, IsStifferTheMoreItIsPressed) {
    double before = 0.0;
    for (const double preload : {5.0, 20.0, 80.0}) {
        const Case c = pressed_cubic_joint(preload);
        const model::Structure structure = model::structure_of(c);
        ASSERT_EQ(structure.springs.size(), 1U);
        const double e = structure.springs.front().rest, k = c.joint().axial_stiffness, k3 = c.joint().axial_cubic;
        const double borne = preload * std::sin(c.joint().incidence_angle * degree);
        EXPECT_NEAR(k * e + k3 * e * e * e, borne, 1e-12 * borne);
        Case tangent = c;
        tangent.joint().stiffening = Stiffening::none;
        tangent.joint().axial_stiffness = k + 3.0 * k3 * e * e;
        const model::Structure small = model::linearised_at_rest(structure), linear = model::structure_of(tangent);
        EXPECT_LT((small.stiffness - linear.stiffness).norm(), 1e-12 * linear.stiffness.norm());
        EXPECT_LT((small.load - linear.load).norm(), 1e-12 * linear.load.norm());
        EXPECT_GT(e, before);
        before = e;
    }
}

double growth_of_joint(double preload) {
    const model::Structure structure = model::structure_of(pressed_cubic_joint(preload));
    return analysis::sliding_stability(structure, parameters::Direction::going).growth;
}

// [1/s] from the largest velocities of a small motion about steady sliding, early and late
double simulated_growth_of_joint(double preload) {
    const double duration = support::effort(4.0, 1.0);  // [s]
    Case c = pressed_cubic_joint(preload);
    c.run.initial = parameters::Initial::sliding;
    c.run.perturbation = 1e-6;
    c.run.duration = c.run.window = duration;
    const integration::Motion motion =
        integration::simulate(c, record::Request{record::KeepHistory::no, {0.0, duration, 1e-5}});
    EXPECT_EQ(motion.outcome.reason, integration::Reason::completed);
    const std::vector<double>& velocity = motion.record.trace.velocity[0];
    const auto largest = [&](double from, double to) {
        const auto at = [&](double share) {
            return velocity.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(velocity.size()));
        };
        const auto less = [](double a, double b) { return std::abs(a) < std::abs(b); };
        return std::abs(*std::max_element(at(from), at(to), less));
    };
    return std::log(largest(0.8, 0.9) / largest(0.5, 0.6)) / (0.3 * duration);
}

// its modes couple where it is pressed little; pressed more it is stiffer along its axis, and they part
TEST(StiffeningJoint, PartsItsModesWhereItIsPressed) {
    EXPECT_GT(growth_of_joint(20.0), 400.0);
    EXPECT_LT(growth_of_joint(200.0), 0.0);
    for (const double preload : {60.0, 300.0}) {
        const double growth = growth_of_joint(preload);
        EXPECT_NEAR(simulated_growth_of_joint(preload), growth, 0.03 * std::abs(growth)) << preload;
    }
}

}  // namespace
}  // namespace stridor
