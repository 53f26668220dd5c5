// Sliding that its own eigenvalues call unstable is never quiet because it slides, whoever computes it.

#include "stridor/analysis/sliding_stability.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/classification/interface_rules.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/model/built/case_structure.hpp"
#include "support/effort.hpp"
#include "support/random_structures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace stridor {
namespace {

using classification::Category;
using classification::Quiet;
using classification::Verdict;
using integration::Motion;
using parameters::Case;
using parameters::Engine;

// a stiff thin lip on a plate whose sliding grows with 0.43 1/s
Case slow_flutter() {
    Case c;
    c.joint() = {.mass = 0.003194984866379582,
                 .axial_stiffness = 356509.2506029938,
                 .flexural_stiffness = 16345.72687093736,
                 .axial_damping = 0.9509559175789475,
                 .flexural_damping = 0.5379136942492496,
                 .incidence_angle = 92.564633316569};
    c.plate = {.mass = 0.8218200848946559, .stiffness = 141153.64250004108, .damping = 10.950046038028646};
    c.contact().preload = 12.099162342109164;
    c.contact().static_friction = 0.5986406453844396;
    c.contact().kinetic_friction = 0.3815892717615782;
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = -0.4755835122063232;
    c.run.duration = 1.0;
    c.run.window = 0.5;
    return c;
}

Verdict verdict(const Case& c, const Motion& motion) {
    return classification::classify_phases(motion.record.phases, c.verdict).front();
}

// [s] when the sliding ends that lasts through the first second
double end_of_sliding(Case c) {
    c.run.duration = 2.5;
    record::Request request;
    request.history = record::KeepHistory::yes;
    const Motion motion = integration::simulate(c, request);
    for (const record::ContactInterval& interval : motion.record.histories.front())
        if (interval.state == model::ContactState::slip && interval.to > 1.0) return interval.to;
    return 0.0;
}

TEST(SlowFlutter, IsUndecidedUntilItHasGrownWhateverTheEngine) {
    const double ends = end_of_sliding(slow_flutter());
    EXPECT_GT(ends, 1.2);
    for (const Engine engine : {Engine::exact, Engine::beta_2, Engine::moreau}) {
        Case c = slow_flutter();
        c.run.engine = engine;
        c.run.step = 2e-6;
        const Motion motion = integration::simulate(c);
        const Verdict early = verdict(c, motion);
        EXPECT_EQ(early.evidence.judged_rates.slip, 1.0);
        EXPECT_EQ(early.category, Category::undecided);
        const record::Outlook& outlook = motion.record.phases.front().contacts.front().ending.outlook;
        EXPECT_NEAR(outlook.growth, 0.430, 5e-4);
        EXPECT_NEAR(outlook.grown, ends, 0.1);
        c.run.duration = 3.0;  // at 2 s it is on its way from one cycle to another
        c.run.window = 1.0;
        EXPECT_EQ(verdict(c, integration::simulate(c)).category, Category::squeal);
    }
}

TEST(SlowFlutter, OfSeveralJointsIsUndecided) {
    Case c = slow_flutter();
    // two halves of it move as the whole
    for (double* each : {&c.joint().mass, &c.joint().axial_stiffness, &c.joint().flexural_stiffness,
                         &c.joint().axial_damping, &c.joint().flexural_damping, &c.contact().preload})
        *each *= 0.5;
    c.joints.push_back(c.joints.front());
    c.joints[1].name = "other";
    const Motion motion = integration::simulate(c);
    EXPECT_EQ(verdict(c, motion).category, Category::undecided);
    EXPECT_NEAR(motion.record.phases.front().contacts.back().ending.outlook.growth, 0.430, 5e-4);
}

// all that slide, though some of them will not go on so
TEST(Growth, OfAnyStructureIsNeverQuietBecauseItSlides) {
    int unstable = 0, stable = 0;
    for (std::uint64_t number = 0; number < support::effort<std::uint64_t>(400, 20); ++number) {
        Case c = support::random_structure(number);
        c.contact().kinetic_friction = c.contact().static_friction;  // nothing jumps: some slide for long
        c.run.initial = parameters::Initial::rest;
        c.run.duration = 0.03;
        c.run.window = 0.015;
        c.run.engine = number % 4 == 0 ? Engine::moreau : Engine::exact;
        c.run.step = 2e-6;
        const Motion motion = integration::simulate(c);
        if (!integration::has_result(motion.outcome)) continue;
        const record::Tally& phase = motion.record.phases.front();
        const bool all_slide = std::all_of(phase.contacts.begin(), phase.contacts.end(), [](const auto& contact) {
            return contact.judged_time[model::index_of(model::ContactState::slip)] > 0.0 &&
                   contact.judged_time[model::index_of(model::ContactState::stick)] == 0.0 &&
                   contact.judged_time[model::index_of(model::ContactState::separation)] == 0.0;
        });
        if (!all_slide) continue;
        const analysis::SlidingStability stability =
            analysis::sliding_stability(model::structure_of(c), parameters::steady_direction(c.drive));
        const bool is_stable = stability.kind == analysis::StabilityKind::stable && stability.open.empty();
        (is_stable ? stable : unstable) += 1;
        const classification::PhaseVerdicts verdicts = classification::classify_all(phase, c.verdict);
        EXPECT_EQ(verdicts.whole.category == Category::none, is_stable) << number;
        for (const auto& each : verdicts.contacts) {
            const bool is_quiet = each && each->quiet == Quiet::slides;
            EXPECT_FALSE(is_quiet && !is_stable) << number;
        }
    }
    EXPECT_GT(unstable, support::effort(5, 0));
    EXPECT_GT(stable, support::effort(50, 1));
}

}  // namespace
}  // namespace stridor
