// The exact engine on cases far from sensible: it ends, with numbers, in the laws of the model, having missed no event.

#include "stridor/base/error.hpp"
#include "stridor/integration/cost.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/parameters/rules/check.hpp"
#include "support/effort.hpp"
#include "support/oracles/figure_laws.hpp"
#include "support/oracles/motion_laws.hpp"
#include "support/patience.hpp"
#include "support/runs.hpp"
#include "support/shrink.hpp"
#include "support/wild_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace stridor {
namespace {

using integration::Motion;
using integration::Reason;
using parameters::Case;

// as users run it: to the end, or to a proof
std::string failure_of_plain_run(const Case& c) {
    return support::complaint_of_run(c, 2.0);
}

// in the last hundredth of its time, or in the one and a half periods that a window must hold
Case with_short_window(Case c) {
    c.run.window *= 0.01;
    if (c.drive.kind == parameters::DriveKind::sinusoidal)
        c.run.window = std::min(c.run.duration, std::max(c.run.window, 1.5 / c.drive.frequency));
    return c;
}

// with the paper's time stepping, a fiftieth of its stable step
Case with_steps(Case c) {
    c.run.engine = parameters::Engine::beta_2;
    c.contact().impact = parameters::ImpactKind::plastic;
    c.run.step = std::min(0.02 * integration::cost(c).step_limit, 1e-3 * c.run.duration);
    return c;
}

// ten samples in the shortest time in which anything happens
Motion densely_sampled(const Case& c) {
    const double interval = 0.1 / support::fastest_rate(c);
    return integration::simulate(c, {record::KeepHistory::yes, {0.0, c.run.duration, interval}});
}

// friction that feeds a motion (sprag-slip) makes it grow until its energy is no number any more
bool has_outgrown_numbers(const Motion& motion) {
    double largest = 0.0;
    for (const auto& velocity : motion.record.trace.velocity)
        for (const double v : velocity)
            largest = std::max(largest, std::abs(v));
    return !(largest < 1e130);
}

std::string failure_of(const Case& c) {
    try {
        const Motion motion = densely_sampled(c);
        const Reason reason = motion.outcome.reason;
        if (reason == Reason::diverged && has_outgrown_numbers(motion)) return {};
        // a bounce that loses nothing under a growing force comes ever faster, and never rests
        const bool bounces_for_ever =
            c.contact().impact == parameters::ImpactKind::restitution && c.contact().restitution == 1.0;
        if (reason == Reason::chattering && bounces_for_ever) return {};
        if (reason != Reason::completed && reason != Reason::settled)
            return std::string(integration::reason_names[static_cast<std::size_t>(reason)]) + " at " +
                   std::to_string(motion.outcome.time / c.run.duration) + " of the run";
        // a drive that stands still is refused before it is run, and has no figures; the laws it keeps
        const bool has_figures = parameters::findings(c).empty();
        const std::string broken = has_figures ? support::broken_figure(c, motion) : std::string();
        if (!broken.empty()) return broken;
        return support::broken_law(c, motion);
    } catch (const Error& error) {
        // a sliding start may have no equilibrium, or no direction
        if (c.run.initial == parameters::Initial::sliding) return {};
        return error.what();
    }
}

TEST(ExactFuzz, KeepsTheLawsOfTheModelInWildCases) {
    long failures = 0;
    const support::Runs runs = support::runs(support::effort(2000, 100));
    for (std::uint64_t number = runs.first; number < runs.first + runs.count; ++number) {
        const Case c = support::wild_case(number);
        const std::string failure = failure_of(c);
        if (failure.empty()) continue;
        const Case plain = support::shrunk(c, [](const Case& each) { return !failure_of(each).empty(); });
        ADD_FAILURE() << "wild case " << number << ": " << failure << "\nfails as well: " << support::command_of(plain)
                      << "\nwith: " << failure_of(plain);
        ++failures;
        ASSERT_LT(failures, 50);
    }
}

// rates add up to 1, peaks lie above their root mean square, balances close, whatever the window
TEST(ExactFuzz, GivesFiguresThatAgreeInWildCases) {
    long failures = 0;
    const support::Runs runs = support::runs(support::effort(2000, 100));
    for (std::uint64_t number = runs.first; number < runs.first + runs.count; ++number)
        for (Case (*change)(Case) : {+[](Case c) { return c; }, with_short_window, with_steps}) {
            const Case c = change(support::wild_case(number));
            const auto fails = [](const Case& each) { return !failure_of_plain_run(each).empty(); };
            if (!parameters::findings(c).empty() || !fails(c)) continue;
            const Case plain = support::shrunk(c, fails);
            ADD_FAILURE() << "wild case " << number << ": " << failure_of_plain_run(c)
                          << "\nfails as well: " << support::command_of(plain)
                          << "\nwith: " << failure_of_plain_run(plain);
            ++failures;
            ASSERT_LT(failures, 50);
        }
}

// what is written of a failure is no more than it takes
TEST(Shrinking, KeepsWhatTheFailureNeeds) {
    const auto fails = [](const Case& c) {
        return c.contact().preload > 123.4 && c.run.initial != parameters::Initial::rest;
    };
    int shrunk_cases = 0;
    for (std::uint64_t number = 0; number < 200; ++number) {
        const Case c = support::wild_case(number);
        if (!fails(c)) continue;
        ++shrunk_cases;
        const Case plain = support::shrunk(c, fails);
        EXPECT_TRUE(fails(plain));
        Case squeal = parameters::paper_case(parameters::PaperCase::squeal);
        squeal.contact().preload = plain.contact().preload;
        squeal.run.initial = plain.run.initial;
        squeal.run.perturbation = plain.run.perturbation;
        EXPECT_EQ(parameters::canonical_text(plain), parameters::canonical_text(squeal)) << number;
        EXPECT_NE(support::command_of(plain).find("--set contact.preload="), std::string::npos);
    }
    EXPECT_GT(shrunk_cases, 10);
}

}  // namespace
}  // namespace stridor
