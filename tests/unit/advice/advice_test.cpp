#include "stridor/advice/advice.hpp"

#include "stridor/advice/nearest_design.hpp"
#include "stridor/analysis/evidence.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "support/effort.hpp"
#include "support/error_text.hpp"
#include "support/property.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

namespace stridor::advice {
namespace {

using classification::Category;
using classification::Quiet;
using parameters::Case;
using parameters::PaperCase;
using support::thrown_by;

const Case squeal = parameters::paper_case(PaperCase::squeal);

// two periods of the drive instead of five where runs are slow
Case brief(Case c) {
    c.run.duration = c.run.window = support::effort(1.0, 0.4);
    return c;
}

// few parameters where runs are slow
std::vector<AskedRange> asked_ranges() {
    std::vector<AskedRange> few{{"contact.preload"}, {"contact.kinetic_friction"}};
    if (!support::is_checked_build) few.insert(few.end(), {{"joint.mass"}, {"joint.incidence_angle"}});
    return few;
}

const Advice& squeal_advice() {
    static const Advice advice = [] {
        AdviceOptions options;
        options.over = asked_ranges();
        return advise(squeal, options);
    }();
    return advice;
}

// the loudest categories of a case by phase over its starts, without anything of `sweep`
std::vector<Category> categories(Case c) {
    std::vector<Category> all;
    for (const parameters::Initial start :
         {parameters::Initial::rest, parameters::Initial::stuck, parameters::Initial::sliding}) {
        c.run.initial = start;
        const auto tallies = integration::simulate(c).record.phases;
        all.resize(tallies.size(), Category::none);
        for (std::size_t k = 0; k < tallies.size(); ++k) {
            const Category found = classification::classify(analysis::evidence(tallies[k], 0), c.verdict).category;
            if (classification::loudness(found) > classification::loudness(all[k])) all[k] = found;
        }
    }
    return all;
}

std::vector<Category> categories(const DesignVerdict& verdict) {
    std::vector<Category> all;
    for (const sweep::StartVerdict& phase : verdict.phases)
        all.push_back(phase.category);
    return all;
}

Case with(const Case& c, const std::string& key, double value) {
    Case changed = c;
    parameters::set_quantity(changed, *parameters::find_field(key), value);
    return changed;
}

TEST(Margins, AreWhereTheVerdictChanges) {
    const Advice& advice = squeal_advice();
    std::size_t changes = 0;
    for (const ParameterMargin& margin : advice.margins) {
        const DesignParameter& parameter = advice.space.parameters[margin.parameter];
        for (const ScanSide* side : {&margin.below, &margin.above}) {
            if (!side->change) continue;
            ++changes;
            EXPECT_EQ(categories(with(squeal, parameter.key, side->change->value)), categories(side->change->beyond));
            EXPECT_NE(categories(side->change->beyond), categories(advice.present)) << parameter.key;
            EXPECT_EQ(categories(with(squeal, parameter.key, side->change->before)), categories(advice.present))
                << parameter.key;
            EXPECT_LE(std::abs(share_of(parameter, side->change->before) - side->change->share),
                      scan_resolution * (1.0 + 1e-9));
        }
    }
    EXPECT_GE(changes, 2U);
}

// a grid's interval is 1/64 of the range; on both sides of the present value 0.002 comes first
TEST(Margins, AreScannedCloserAroundThePresentValue) {
    const Advice& advice = squeal_advice();
    std::size_t sides = 0;
    for (const ParameterMargin& margin : advice.margins) {
        const double origin = advice.space.origin[margin.parameter];
        double below = 1.0, above = 1.0;  // [1] distance of the nearest one
        for (const ScanPoint& point : margin.scan)
            if (point.share != origin) {
                double& nearest = point.share < origin ? below : above;
                nearest = std::min(nearest, std::abs(point.share - origin));
            }
        for (const auto& [distance, room] : {std::pair{below, origin}, {above, 1.0 - origin}}) {
            if (room < 0.002) continue;
            EXPECT_LE(distance, 0.002 + 1e-12) << margin.parameter;
            ++sides;
        }
    }
    EXPECT_GE(sides, 2 * advice.margins.size() - 1);
}

TEST(Margins, NameTheNearestQuietValue) {
    const Advice& advice = squeal_advice();
    const VerdictChange* quiet = nearest_quiet(advice.space, advice.margins[1]);
    ASSERT_NE(quiet, nullptr);
    EXPECT_NEAR(quiet->value, 0.4096, 3e-3);  // from rest alone 0.4137
    EXPECT_EQ(categories(with(squeal, "contact.kinetic_friction", quiet->value)),
              (std::vector{Category::none, Category::none}));
}

TEST(Margins, EndWhereValuesContradictEachOther) {
    const ParameterMargin& friction = squeal_advice().margins[1];
    EXPECT_EQ(friction.above.end, ScanEnd::invalid);
    EXPECT_NEAR(friction.above.last, 0.8, 1e-8);
    EXPECT_LE(friction.above.last, 0.8);
    EXPECT_NE(friction.above.reason.find("kinetic friction may not be larger"), std::string::npos);
    EXPECT_EQ(friction.below.end, ScanEnd::range);
    EXPECT_EQ(friction.below.last, 0.0);
}

TEST(Margins, ScanThroughThePresentValue) {
    for (const ParameterMargin& margin : squeal_advice().margins) {
        EXPECT_TRUE(std::is_sorted(margin.scan.begin(), margin.scan.end(),
                                   [](const auto& a, const auto& b) { return a.value < b.value; }));
        EXPECT_TRUE(std::any_of(margin.scan.begin(), margin.scan.end(),
                                [&](const ScanPoint& point) { return point.value == margin.value; }));
        EXPECT_GE(margin.scan.size(), 33U);
    }
}

TEST(Advice, NamesAChangeOfTheSquealThatIsQuiet) {
    const Advice& advice = squeal_advice();
    ASSERT_TRUE(advice.recommended);
    for (const DesignChange& change : advice.changes) {
        Case c = squeal;
        for (const ParameterChange& each : change.set) {
            EXPECT_EQ(each.from, parameters::get_quantity(
                                     squeal, *parameters::find_field(advice.space.parameters[each.parameter].key)));
            c = with(c, advice.space.parameters[each.parameter].key, each.to);
        }
        EXPECT_EQ(categories(c), (std::vector{Category::none, Category::none}));
        EXPECT_LE(change.set.size(), most_changed);
        EXPECT_GT(change.distance, 0.0);
    }
    EXPECT_TRUE(std::is_sorted(advice.changes.begin(), advice.changes.end(),
                               [](const auto& a, const auto& b) { return a.distance < b.distance; }));
    EXPECT_LE(advice.nearest->distance, advice.changes.front().distance);
}

TEST(Advice, LooksAtTheDesignItAdvisesAsIfItWereTheCase) {
    AdviceOptions options;
    options.over = {{"contact.kinetic_friction"}};
    options.tolerances = {{"contact.preload", 0.1, {}}};
    options.chance.samples = 64;
    const Advice advice = advise(brief(squeal), options);
    ASSERT_TRUE(advice.changed);
    const ParameterChange& set = advice.changes[*advice.recommended].set.front();
    const Case changed = with(brief(squeal), advice.space.parameters[set.parameter].key, set.to);
    EXPECT_EQ(headline(advice.changed->standing), headline(standing_of(changed, Look::around, options)));
    const Advice there = advise(changed, options);
    ASSERT_TRUE(advice.changed->chance);
    EXPECT_EQ(advice.changed->chance->noise.share, there.chance->noise.share);
    EXPECT_FALSE(advice.changed->chance->is_default);
    EXPECT_EQ(changed_words(*advice.changed).rfind(headline(there) + "; chance of noise within these tolerances ", 0),
              0U);
}

// a tolerance that the changed design cannot have takes nothing from the advice: the usual ones stand in
TEST(Advice, TakesUsualTolerancesWhereTheChangedDesignCannotHaveThose) {
    AdviceOptions options;
    options.over = {{"contact.kinetic_friction"}};
    options.tolerances = {{"contact.kinetic_friction", {}, 0.5}};  // from 0.4 down it would go below zero
    options.chance.samples = 16;
    const Advice advice = advise(brief(squeal), options);
    EXPECT_FALSE(advice.chance->is_default);
    ASSERT_TRUE(advice.changed);
    EXPECT_TRUE(advice.changed->chance->is_default);
}

TEST(Advice, IsTheSameForAnyNumberOfThreads) {
    AdviceOptions options;
    options.over = {{"contact.kinetic_friction"}, {"joint.incidence_angle", 60.0, 80.0}};
    options.tolerances = {{"preload", 0.1, {}}};
    options.chance.samples = 64;
    options.crew = crew::thread_crews(1);
    const Advice one = advise(brief(squeal), options);
    options.crew = crew::thread_crews(3);
    const Advice three = advise(brief(squeal), options);
    EXPECT_EQ(one.runs, three.runs);
    EXPECT_EQ(one.ranking, three.ranking);
    EXPECT_EQ(one.nearest->shares, three.nearest->shares);
    EXPECT_EQ(one.chance->noise.high, three.chance->noise.high);
    ASSERT_EQ(one.changes.size(), three.changes.size());
    for (std::size_t k = 0; k < one.changes.size(); ++k) {
        EXPECT_EQ(one.changes[k].distance, three.changes[k].distance);
        EXPECT_EQ(settings_of(one.space, one.changes[k]), settings_of(three.space, three.changes[k]));
    }
    for (std::size_t k = 0; k < one.margins.size(); ++k)
        EXPECT_EQ(one.margins[k].below.change->value, three.margins[k].below.change->value);
}

TEST(Advice, TellsHowFarAQuietDesignIsFromNoise) {
    AdviceOptions options;
    options.over = {{"contact.preload"}, {"contact.kinetic_friction"}};
    const Advice advice = advise(brief(parameters::paper_case(PaperCase::quiet)), options);
    EXPECT_TRUE(is_quiet(advice.present));
    EXPECT_TRUE(advice.changes.empty());
    EXPECT_FALSE(advice.recommended);
    ASSERT_TRUE(advice.nearest);
    EXPECT_FALSE(is_quiet(advice.nearest->verdict));
    ASSERT_FALSE(advice.ranking.empty());
    const VerdictChange* first = nearest_change(advice.space, advice.margins[advice.ranking.front()]);
    // as a whole it is no farther than along any one parameter, but for the resolution of rays
    EXPECT_LE(advice.nearest->distance,
              std::abs(first->share - advice.space.origin[advice.ranking.front()]) + ray_resolution);
}

TEST(Advice, PrefersAContactThatSlipsToOneThatSticks) {
    const Case creak = brief(parameters::paper_case(PaperCase::creak));
    AdviceOptions options;
    options.over = {{"drive.amplitude"}};
    const Advice stuck = advise(creak, options);
    ASSERT_EQ(stuck.changes.size(), 1U);
    EXPECT_TRUE(is_quiet(stuck.changes.front().verdict));
    EXPECT_FALSE(slips_quietly(stuck.changes.front().verdict));
    options.over.push_back({"contact.preload", 2.0, 4000.0});
    for (const DesignChange& change : advise(creak, options).changes)
        EXPECT_TRUE(slips_quietly(change.verdict));
}

TEST(Advice, StopsWhenAsked) {
    std::stop_source stop;
    stop.request_stop();
    AdviceOptions options;
    options.stop = stop.get_token();
    EXPECT_EQ(thrown_by([&] { advise(squeal, options); }).kind, ErrorKind::interrupted);
}

TEST(Advice, TellsItsProgress) {
    AdviceOptions options;
    options.over = {{"contact.kinetic_friction", 0.5, 0.7}};
    AdviceProgress last;
    options.progress = [&](const AdviceProgress& progress) {
        EXPECT_GE(progress.runs, last.runs);
        EXPECT_GE(progress.share, last.share);
        EXPECT_LE(progress.share, 1.0);
        last = progress;
    };
    EXPECT_EQ(advise(brief(squeal), options).runs, last.runs);
    EXPECT_GT(last.share, 0.5);
}

TEST(IsQuiet, IsNotWhatCouldNotBeComputedOrDecided) {
    const sweep::StartVerdict slides{sweep::Status::done, Category::none, Quiet::slides};
    const sweep::StartVerdict sticks{sweep::Status::done, Category::none, Quiet::sticks};
    EXPECT_TRUE(is_quiet({{slides, sticks}}));
    EXPECT_FALSE(slips_quietly({{slides, sticks}}));
    EXPECT_FALSE(is_quiet({{slides, {sweep::Status::done, Category::none, Quiet::locks}}}));
    for (const sweep::Status status :
         {sweep::Status::invalid, sweep::Status::step_limit, sweep::Status::diverged, sweep::Status::failed}) {
        const DesignVerdict verdict{{slides, {status, Category::none}}};
        EXPECT_FALSE(is_quiet(verdict));
        EXPECT_FALSE(is_noisy(verdict));
    }
    const DesignVerdict undecided{{{sweep::Status::done, Category::undecided}}};
    EXPECT_FALSE(is_quiet(undecided));
    EXPECT_FALSE(is_noisy(undecided));
    EXPECT_FALSE(is_quiet({}));
}

// the nearest point of a plane with intercepts d: x = (1/d) / sum(1/d²), at a distance of 1 / sqrt(sum(1/d²))
TEST(FlatHeading, PointsToTheNearestPointOfAPlane) {
    const std::vector<double> intercepts{0.2, -0.4, 0.0, 0.1};
    const std::vector<std::size_t> all{0, 1, 2, 3};
    const Heading heading = flat_heading(intercepts, all);
    double along = 0.0;
    double square = 0.0;
    for (std::size_t k = 0; k < heading.size(); ++k) {
        along += intercepts[k] != 0.0 ? heading[k] / intercepts[k] : 0.0;
        square += heading[k] * heading[k];
    }
    EXPECT_NEAR(std::sqrt(square) / along, 1.0 / std::sqrt(25.0 + 6.25 + 100.0), 1e-12);
    EXPECT_EQ(heading[2], 0.0);
    EXPECT_EQ(flat_heading(intercepts, std::vector<std::size_t>{1})[0], 0.0);
}

int significant_digits(double value) {
    for (int digits = 1; digits < 17; ++digits) {
        char text[40];
        std::snprintf(text, sizeof text, "%.*e", digits - 1, value);
        if (std::strtod(text, nullptr) == value) return digits;
    }
    return 17;
}

// who goes from a design towards another for their distance arrives, and nobody leaves the box
TEST(PointAlong, ArrivesAtTheOtherDesign) {
    const DesignSpace space = design_space(squeal);
    Shares other = space.origin;
    ASSERT_GE(other.size(), 2U);
    other[0] += other[0] < 0.5 ? 0.3 : -0.3;
    other[1] += other[1] < 0.5 ? 0.2 : -0.2;
    const Heading heading = heading_to(space, other);
    const double far = distance(space.origin, other);
    EXPECT_NEAR(far, std::hypot(0.3, 0.2), 1e-15);
    const Shares there = point_along(space, heading, far), halfway = point_along(space, heading, 0.5 * far);
    for (std::size_t k = 0; k < other.size(); ++k) {
        EXPECT_NEAR(there[k], other[k], 1e-15) << k;
        EXPECT_NEAR(halfway[k], 0.5 * (space.origin[k] + other[k]), 1e-15) << k;
    }
    for (const double share : point_along(space, heading, 100.0))
        EXPECT_TRUE(share >= 0.0 && share <= 1.0);
    EXPECT_EQ(point_along(space, heading, 100.0)[0], other[0] > space.origin[0] ? 1.0 : 0.0);
}

RC_GTEST_PROP(Roundest, LiesBetweenWithFewDigits, ()) {
    const double size = std::pow(10.0, *support::number_between(-5.0, 8.0));
    const double sign = *rc::gen::arbitrary<bool>() ? 1.0 : -1.0;
    const double near = sign * size;
    const double far = near * (1.0 + *support::number_between(-0.3, 0.3));
    const double rounded = roundest(near, far);
    RC_ASSERT(rounded >= std::min(near, far) && rounded <= std::max(near, far));
    // an interval of a share s of its value holds a number of at most 1 - log10(s) digits
    const double share = std::abs(far / near - 1.0);
    if (share > 1e-3) RC_ASSERT(significant_digits(rounded) <= 2 + static_cast<int>(-std::log10(share * 0.7)));
}

TEST(Roundest, TakesTheNearestOfTheRoundest) {
    EXPECT_EQ(roundest(0.4137, 0.38), 0.4);
    EXPECT_EQ(roundest(0.3937, 0.3837), 0.39);
    EXPECT_EQ(roundest(12.3, 19.0), 13.0);
    EXPECT_EQ(roundest(9.7, 31.0), 10.0);
    EXPECT_EQ(roundest(2.021e6, 2.09e6), 2.03e6);
    EXPECT_EQ(roundest(-0.13, -0.21), -0.2);
    EXPECT_EQ(roundest(0.1, -0.1), 0.0);
    EXPECT_EQ(roundest(7.0, 7.0), 7.0);
}

TEST(Recommended, IsAsSimpleAsCanBe) {
    const auto change = [](std::size_t parameters, double distance) {
        return DesignChange{std::vector<ParameterChange>(parameters), distance, {}, 1};
    };
    const std::vector<DesignChange> close{change(2, 0.095), change(1, 0.1)};
    EXPECT_EQ(recommended(close), &close[1]);
    const std::vector<DesignChange> far{change(2, 0.08), change(1, 0.1)};
    EXPECT_EQ(recommended(far), &far[0]);
    EXPECT_EQ(recommended({}), nullptr);
}

}  // namespace
}  // namespace stridor::advice
