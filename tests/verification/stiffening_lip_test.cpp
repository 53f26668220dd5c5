// A lip that stiffens as it is pressed (`stridor init seal-lip`): the two preloads between which its modes couple, by
// the eigenvalues of steady sliding and by the motion.

#include "stridor/analysis/sliding_stability.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/integration/run/end_state.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/io/case/ready_files.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/model/built/case_structure.hpp"
#include "support/effort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace stridor {
namespace {

using parameters::Case;
using parameters::Direction;

Case pressed_lip(double preload) {
    static const Case ready = io::read_study(io::TomlSource{io::ready_file("seal-lip"), "seal-lip", {}}).base;
    Case c = ready;
    c.contact().preload = preload;
    return c;
}

double growth_at(double preload) {
    return analysis::sliding_stability(model::structure_of(pressed_lip(preload)), Direction::going).growth;
}

// [N] where the growth changes its sign
double critical_preload(double stable, double growing) {
    for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (stable + growing);
        (growth_at(middle) > 0.0 ? growing : stable) = middle;
    }
    return 0.5 * (stable + growing);
}

// [1/s] growth of a small disturbance of the sliding rest, from its largest velocities early and late
double simulated_growth(double preload) {
    const double duration = support::effort(16.0, 4.0);  // [s]
    Case c = pressed_lip(preload);
    c.run.duration = c.run.window = duration;
    const analysis::SteadySliding sliding = analysis::steady_sliding(model::structure_of(c), Direction::going);
    const Eigen::VectorXd& rest = sliding.found.equilibrium.displacement;
    auto own = std::make_shared<parameters::OwnStructure>(*c.own_structure);
    own->initial_displacement.assign(rest.begin(), rest.end());
    own->initial_displacement[0] += 1e-7;  // [m] along the surface: the gap stays closed
    c.own_structure = own;
    c.run.initial = parameters::Initial::given;
    record::Request request;
    request.trace = {0.0, duration, 2e-4};
    const integration::Motion motion = integration::simulate(c, request);
    EXPECT_EQ(motion.outcome.reason, integration::Reason::completed);
    const auto& trace = motion.record.trace;
    const auto largest = [&](double from, double to) {
        double most = 0.0;
        for (std::size_t k = 0; k < trace.time.size(); ++k)
            if (trace.time[k] >= from * duration && trace.time[k] < to * duration)
                most = std::max(most, std::abs(trace.velocity[0][k]));
        return most;
    };
    return std::log(largest(0.8, 1.0) / largest(0.3, 0.5)) / (0.5 * duration);
}

TEST(StiffeningLip, GrowsBetweenTwoPreloadsAsTheMotionDoes) {
    const double low = critical_preload(1.0, 6.0), high = critical_preload(20.0, 6.0);
    EXPECT_NEAR(low, 3.0266, 1e-3);
    EXPECT_NEAR(high, 9.1614, 1e-3);
    for (const double inside : {low * 1.001, high * 0.999}) {
        EXPECT_GT(growth_at(inside), 0.0);
        EXPECT_NEAR(simulated_growth(inside), growth_at(inside), 0.02 * growth_at(inside)) << inside;
    }
    for (const double outside : {low * 0.999, high * 1.001}) {
        EXPECT_LT(growth_at(outside), 0.0);
        EXPECT_NEAR(simulated_growth(outside), growth_at(outside), -0.02 * growth_at(outside)) << outside;
    }
}

// a linear lip has one answer at every preload: the band is of its stiffening
TEST(StiffeningLip, SquealsInTheBandAlone) {
    using classification::Category;
    for (const auto& [preload, category] :
         {std::pair(2.0, Category::none), std::pair(4.0, Category::squeal), std::pair(6.0, Category::squeal),
          std::pair(8.0, Category::squeal), std::pair(20.0, Category::none), std::pair(40.0, Category::none)}) {
        const Case c = pressed_lip(preload);
        const integration::Motion motion = integration::simulate(c);
        EXPECT_EQ(classification::classify_phases(motion.record.phases, c.verdict).front().category, category)
            << preload;
    }
    for (const double linear : {2.0, 6.0, 20.0}) {
        Case c = pressed_lip(linear);
        auto own = std::make_shared<parameters::OwnStructure>(*c.own_structure);
        own->springs[0].table = {};
        own->springs[0].stiffness = 12e3;  // [N/m] in the band
        c.own_structure = own;
        EXPECT_GT(analysis::sliding_stability(model::structure_of(c), Direction::going).growth, 0.0) << linear;
    }
}

TEST(StiffeningLip, GoesOnFromItsEndBitForBit) {
    Case whole = pressed_lip(6.0);
    whole.run.early_ending = parameters::EarlyEnding::never;
    whole.run.duration = 0.4;
    whole.run.window = 0.2;
    Case half = whole;
    half.run.duration = 0.2;
    const record::Request request{record::KeepHistory::yes, {0.0, whole.run.duration, 1e-4}};
    const record::Trace told = integration::simulate(whole, request).record.trace;
    const record::Trace later = integration::go_on(whole, integration::run_to_end(half).state, request).record.trace;
    ASSERT_GT(later.time.size(), 1000U);
    const std::size_t before = told.time.size() - later.time.size();
    for (std::size_t k = 0; k < later.time.size(); ++k)
        for (std::size_t row = 0; row < 3; ++row)
            ASSERT_EQ(later.displacement[row][k], told.displacement[row][before + k]) << later.time[k];
}

}  // namespace
}  // namespace stridor
