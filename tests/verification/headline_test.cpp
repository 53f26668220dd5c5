// No headline calls quiet what makes noise within 1 % of one of its quantities, either way, from any start.
//
// Random designs around each ready part get their headline as report, advice and page get it, and are then run again,
// without anything of `advice`. STRIDOR_DESIGNS says how many around each part: 1000 take hours.

#include "stridor/advice/advice.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/integration/failure.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/fields/usual_range.hpp"
#include "stridor/parameters/rules/check.hpp"
#include "stridor/sweep/ready_charts.hpp"
#include "support/counter_random.hpp"
#include "support/effort.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace stridor {
namespace {

using classification::Category;
using parameters::Case;
using support::CounterRandom;

std::size_t designs_asked_for() {
    const char* const asked = std::getenv("STRIDOR_DESIGNS");
    return asked != nullptr ? std::stoul(asked) : support::effort<std::size_t>(20, 1);
}

// half to twice of what has a logarithm, angles within 15 deg, the rest within a half of itself
void vary(Case& c, const std::string& key, CounterRandom& random) {
    const double value = parameters::get_quantity(c, key);
    const bool is_angle = parameters::unit_of(key) == "deg";
    const double changed = is_angle ? value + random.between(-15.0, 15.0) : value * random.decades(0.5, 2.0);
    try {
        parameters::set_quantity(c, key, changed);
    } catch (const Error&) {
        // out of the field's range: it stays
    }
}

Case random_design(const Case& part, CounterRandom& random) {
    while (true) {
        Case c = part;
        for (const std::string& key : parameters::design_keys(c))
            vary(c, key, random);
        if (parameters::findings(c).empty()) return c;
    }
}

bool is_noisy(const Case& c) {
    try {
        const integration::Motion motion = integration::simulate(c);
        if (integration::failure(c, motion)) return false;
        for (const classification::Verdict& verdict : classification::classify_phases(motion.record.phases, c.verdict))
            if (verdict.category != Category::none && verdict.category != Category::undecided) return true;
    } catch (const Error&) {
        // a start that there is not
    }
    return false;
}

// is any run of a case noisy: either way, from any of three starts?
bool is_noisy_somehow(Case c) {
    for (const double way : {1.0, -1.0}) {
        const bool is_constant = c.drive.kind == parameters::DriveKind::constant;
        if (!is_constant && way < 0.0) break;
        if (is_constant) c.drive.velocity = way * std::abs(c.drive.velocity);
        for (const parameters::Initial start :
             {parameters::Initial::rest, parameters::Initial::stuck, parameters::Initial::sliding}) {
            c.run.initial = start;
            if (is_noisy(c)) return true;
        }
    }
    return false;
}

// the first change of one quantity within 1 % that makes noise; empty if none of those tried does
std::string noisy_neighbour(const Case& c, CounterRandom& random) {
    constexpr int tried = 2;  // of each quantity
    if (is_noisy_somehow(c)) return "itself";
    for (const std::string& key : parameters::design_keys(c))
        for (int k = 0; k < tried; ++k) {
            Case changed = c;
            const double share = random.between(-0.01, 0.01);
            parameters::set_quantity(changed, key, (1.0 + share) * parameters::get_quantity(c, key));
            if (parameters::findings(changed).empty() && is_noisy_somehow(changed))
                return key + " " + std::to_string(100.0 * share) + " %";
        }
    return "";
}

TEST(Headline, CallsNothingQuietThatMakesNoiseWithinOnePercent) {
    for (const sweep::ReadyChart& part : sweep::ready_charts()) {
        std::size_t quiet = 0, barely = 0, wrong = 0;
        for (std::size_t k = 0; k < designs_asked_for(); ++k) {
            CounterRandom random(k);
            const Case c = random_design(part.study.base, random);
            const advice::DesignStanding design = advice::standing_of(c, advice::Look::around);
            const advice::Standing standing = advice::standing(design.present, design.near);
            if (standing == advice::Standing::barely_quiet) ++barely;
            if (standing != advice::Standing::quiet) continue;
            ++quiet;
            const std::string noisy = noisy_neighbour(c, random);
            if (!noisy.empty()) ++wrong;
            EXPECT_EQ(noisy, "") << part.name << ", design " << k << ": " << advice::headline(design);
        }
        std::cout << part.name << ": " << designs_asked_for() << " designs, " << quiet << " quiet, " << barely
                  << " only just, " << wrong << " called quiet with noise within 1 %" << std::endl;
    }
}

}  // namespace
}  // namespace stridor
