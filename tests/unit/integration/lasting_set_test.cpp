#include "stridor/integration/proofs/lasting_set.hpp"

#include "stridor/integration/proofs/lyapunov.hpp"
#include "stridor/integration/series/taylor_block.hpp"
#include "stridor/model/built/chain_on_belt.hpp"
#include "support/many_contacts.hpp"
#include "support/property.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace stridor::integration {
namespace {

using Eigen::MatrixXd;
using record::Future;

TEST(Lyapunov, SolvesItsEquation) {
    MatrixXd a(4, 4);
    a << -1, 2, 0, 1, -2, -1, 0.5, 0, 0, 0, -0.1, 3, 1, 0, -3, -0.1;
    MatrixXd q(4, 4);
    q << 2, 1, 0, 0, 1, 3, 0, 1, 0, 0, 1, 0, 0, 1, 0, 4;
    const MatrixXd x = Lyapunov(a).solve(q);
    EXPECT_LT((a.transpose() * x + x * a + q).norm(), 1e-12);
    EXPECT_EQ(x, x.transpose());
}

// of a damped oscillator the integral of x'^2 from x = 1 on is k / (2 c)
TEST(Lyapunov, GivesTheEnergyThatADashpotTakes) {
    constexpr double k = 4.0, c = 0.1;
    MatrixXd a(2, 2), q = MatrixXd::Zero(2, 2);
    a << 0, 1, -k, -c;
    q(1, 1) = 1.0;
    EXPECT_NEAR(Lyapunov(a).solve(q)(0, 0), k / (2.0 * c), 1e-12);
}

// --- a chain of two blocks on a belt: springs 1, coupled by 1/2, mu_s = 1, mu_d = 1/2, N = 1

struct Chain {
    ModalStructure modal;
    std::vector<double> q, v;
};

Chain chain(double damping, const Eigen::VectorXd& u, const Eigen::VectorXd& rate) {
    const model::ChainBlock block{.damping = damping, .friction = model::Coulomb{1.0, 0.5}};
    const model::Structure structure = model::chain_on_belt({block, block}, 0.5);
    Chain chain{modal_structure(structure), {}, {}};
    const Eigen::VectorXd q = modal(chain.modal, structure, u), v = modal(chain.modal, structure, rate);
    chain.q.assign(q.data(), q.data() + q.size());
    chain.v.assign(v.data(), v.data() + v.size());
    return chain;
}

constexpr auto backward = ContactMode::slip_backward;

TEST(LastingSet, SlipsForEverWhereVibrationCannotReachTheBelt) {
    const Eigen::Vector4d rest(0.5, 0.0, 0.5, 0.0);  // pulled by mu_d N
    const Eigen::Vector4d disturbed(0.51, 0.0, 0.5, 0.0);
    const Chain still = chain(0.2, rest, Eigen::Vector4d::Zero());
    const auto silence = LastingSet(still.modal, {backward, backward}, 0.1).silence(still.q, still.v, 3.0);
    ASSERT_TRUE(silence.has_value());
    EXPECT_DOUBLE_EQ(silence->time, 3.0);
    EXPECT_NEAR(silence->normal_force, 1.0, 1e-12);
    EXPECT_NEAR(silence->slip_velocity, 0.1, 1e-12);
    const Chain near = chain(0.2, disturbed, Eigen::Vector4d::Zero());
    const auto less = LastingSet(near.modal, {backward, backward}, 0.1).silence(near.q, near.v, 3.0);
    ASSERT_TRUE(less.has_value());
    EXPECT_LT(less->slip_velocity, 0.1);
    const Chain far = chain(0.2, 2.0 * rest, Eigen::Vector4d::Zero());
    EXPECT_FALSE(LastingSet(far.modal, {backward, backward}, 0.1).silence(far.q, far.v, 3.0).has_value());
    const Chain undamped = chain(0.0, rest, Eigen::Vector4d::Zero());
    EXPECT_FALSE(LastingSet(undamped.modal, {backward, backward}, 0.1).silence(undamped.q, undamped.v, 0).has_value());
}

// stuck at x both springs pull with k x: they slip at k (x + V t) = mu_s N
TEST(LastingSet, KnowsWhenTheBeltWillPullAStuckBlockLoose) {
    const Eigen::Vector4d u(0.2, 0.0, 0.2, 0.0), rate(0.1, 0.0, 0.1, 0.0);
    const Chain stuck = chain(0.0, u, rate);
    const LastingSet set(stuck.modal, {ContactMode::stick, ContactMode::stick}, 0.1);
    for (const record::Outlook& outlook : set.outlooks(stuck.q, stuck.v, 5.0, {{4.0, 4.0}})) {
        EXPECT_EQ(outlook.future, Future::releases);
        EXPECT_NEAR(outlook.release, 5.0 + (1.0 - 0.2) / 0.1, 1e-9);
        EXPECT_NEAR(outlook.drag.to, 1.0, 1e-12);  // a spring along the belt presses nobody
        EXPECT_NEAR(outlook.drag.way, 0.1, 1e-12);
        EXPECT_EQ(outlook.drag.slope, 0.0);
    }
    EXPECT_FALSE(set.silence(stuck.q, stuck.v, 5.0).has_value());
}

TEST(LastingSet, KnowsNothingOfContactsThatAreOpen) {
    const Chain open = chain(0.2, Eigen::Vector4d(0.0, 1.0, 0.0, 1.0), Eigen::Vector4d::Zero());
    for (const record::Outlook& outlook : LastingSet(open.modal, {ContactMode::open, ContactMode::open}, 0.1)
                                              .outlooks(open.q, open.v, 0.0, {{0.0, 0.0}}))
        EXPECT_EQ(outlook.future, Future::unknown);
}

TEST(LastingSet, OfABeltThatStandsStillSticksForEver) {
    const Eigen::Vector4d u(0.2, 0.0, 0.3, 0.0);
    const Chain stuck = chain(0.0, u, Eigen::Vector4d::Zero());
    for (const record::Outlook& outlook : LastingSet(stuck.modal, {ContactMode::stick, ContactMode::stick}, 0.0)
                                              .outlooks(stuck.q, stuck.v, 0.0, {{0.0, 0.0}}))
        EXPECT_EQ(outlook.future, Future::sticks);
}

// the integrals that are passed at once against blocks of the motion
TEST(LastingSet, PassesTimeAsTheMotionDoes) {
    const Eigen::Vector4d u(0.52, 0.0, 0.49, 0.0);
    Chain slips = chain(0.1, u, Eigen::Vector4d(0.01, 0.0, -0.02, 0.0));
    const std::vector<ContactMode> modes{backward, backward};
    LastingSet set(slips.modal, modes, 0.1);
    const LastingSet::Passed passed = set.pass(slips.q, slips.v, 7.0);
    TaylorBlock block(slips.modal, 0.01);
    ASSERT_TRUE(block.choose(modes));
    double square = 0.0;
    for (int k = 0; k < 700; ++k) {
        block.expand(slips.q, slips.v, {}, SurfaceSeries{0.1});
        std::vector<double> v(slips.v.size());
        const auto at = [&](double theta) {
            std::vector<double> q(v.size());
            block.state_at(theta, q, v);
            const double speed = slips.modal.shapes.row(0).dot(Eigen::Map<const Eigen::RowVectorXd>(v.data(), 4));
            return speed * speed;
        };
        square += 0.01 / 6.0 * (at(0.0) + 4.0 * at(0.5) + at(1.0));
        block.state_at(1.0, slips.q, slips.v);
    }
    for (std::size_t j = 0; j < 4; ++j) {
        EXPECT_NEAR(passed.q(static_cast<Eigen::Index>(j)), slips.q[j], 1e-11);
        EXPECT_NEAR(passed.v(static_cast<Eigen::Index>(j)), slips.v[j], 1e-11);
    }
    EXPECT_NEAR(passed.square_time(0), square, 1e-9 * square);
    for (const record::Load& load : passed.loads) {
        EXPECT_NEAR(load.normal_impulse, 7.0, 1e-9);
        EXPECT_NEAR(load.friction_loss, 0.5 * 0.1 * 7.0, 0.5 * 0.05);  // the belt's way and that of the block
    }
}

}  // namespace
}  // namespace stridor::integration
