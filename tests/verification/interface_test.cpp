// What an interface of several contacts does as a whole: loads against equilibrium, heat against the energy balance,
// the strip of rubber against its prototype.

#include "stridor/classification/interface_rules.hpp"
#include "stridor/model/built/chain_on_belt.hpp"
#include "support/effort.hpp"
#include "support/many_contacts.hpp"
#include "support/structures/rubber_strip.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace stridor {
namespace {

using integration::Motion;
using support::run_taylor;

// one interface, whose vibration is that of its contact points
void measure_contacts(model::Structure& structure) {
    const auto count = static_cast<Eigen::Index>(structure.contacts.size());
    structure.measured.resize(2 * count, model::dofs_of(structure));
    for (Eigen::Index k = 0; k < count; ++k) {
        model::ContactPoint& contact = structure.contacts[static_cast<std::size_t>(k)];
        contact.interface = 0;
        structure.measured.row(2 * k) = contact.tangent.transpose();
        structure.measured.row(2 * k + 1) = contact.normal.transpose();
        structure.body.insert(structure.body.end(), {static_cast<int>(k), static_cast<int>(k)});
    }
}

TEST(Interface, OfAChainCarriesItsWeight) {
    const model::ChainBlock block{.preload = 1.0, .friction = model::Coulomb{1.0, 0.5}};
    const model::ChainBlock heavy{.preload = 1.5, .friction = model::Coulomb{1.0, 0.5}};
    model::Structure structure = model::chain_on_belt({block, heavy}, 0.5);
    for (model::ContactPoint& contact : structure.contacts)
        contact.interface = 0;
    const integration::InitialState start{Eigen::VectorXd::Zero(4), Eigen::VectorXd::Zero(4)};
    const Motion motion = run_taylor(structure, 0.1, start, {400.0, 400.0});
    const record::Tally& tally = motion.record.phases.front();
    const analysis::Interface whole = analysis::interface_of(tally, 0);
    EXPECT_NEAR(whole.loads[0].normal_force, 1.0, 1e-12);
    EXPECT_NEAR(whole.loads[1].normal_force, 1.5, 1e-12);
    EXPECT_NEAR(whole.loads[1].share, 0.6, 1e-12);
    EXPECT_NEAR(std::accumulate(whole.rates.begin(), whole.rates.end(), 0.0), 1.0, 1e-12);
    // where the interface sticks both blocks do, where it does partly one of them
    const double stuck = tally.contacts[0].judged_time[1] + tally.contacts[1].judged_time[1];
    EXPECT_NEAR(2.0 * whole.rates[0] + whole.rates[1], stuck / tally.vibration_time, 1e-12);
}

TEST(Interface, TurnsIntoHeatWhatTheEnergyBalanceSays) {
    const model::ChainBlock block{.friction = model::Coulomb{1.0, 0.5}};
    const model::Structure structure = model::chain_on_belt({block, block, block}, 1.2);
    integration::InitialState start{Eigen::VectorXd::Zero(6), Eigen::VectorXd::Zero(6)};
    start.displacement(0) = 0.3;
    parameters::Case c = support::watched_case(0.1, {200.0, 200.0});
    c.verdict.start = 0.0;
    record::Recorder recorder(record::schedule(c), {}, 6, 3, 0, {0, 0, 0});
    const Motion motion =
        integration::integrate_taylor(structure, c.drive, start, {parameters::EarlyEnding::never}, std::move(recorder));
    double loss = 0.0;
    for (const record::ContactTally& contact : motion.record.phases.front().contacts)
        loss += contact.load.friction_loss;
    EXPECT_NEAR(loss, motion.energy.friction_loss, 1e-12 * loss);
}

TEST(Interface, OfTheStripSticksAsTheSumOfItsNodesSays) {
    support::RubberStrip strip = support::read_strip(STRIDOR_SOURCE_DIR "/tests/fixtures/structures/strip_s1.txt");
    measure_contacts(strip.structure);
    const Motion motion = run_taylor(strip.structure, strip.velocity, strip.start, support::strip_watched);
    const classification::InterfaceVerdict verdict =
        classification::classify_interface(motion.record.phases.front(), 0, {});
    const double scatter = support::effort(0.02, 0.1);
    EXPECT_NEAR(verdict.figures.rates[0], 0.44, scatter);  // all five stick
    EXPECT_LT(verdict.figures.rates[3], 1e-4);
    EXPECT_NEAR(verdict.free_together, 0.38, scatter);  // its nodes slip one by one
    EXPECT_EQ(verdict.whole.category, classification::Category::squeak);
    // the belt passes below nodes that stay where they are; they slip at mu_d, 0.5, while N is below its mean
    for (const analysis::CarriedLoad& load : verdict.figures.loads) {
        const double steady = 0.5 * load.normal_force * strip.velocity;
        EXPECT_LT(load.friction_power, steady);
        EXPECT_GT(load.friction_power, 0.8 * steady);
    }
}

}  // namespace
}  // namespace stridor
