#include "stridor/model/laws/friction.hpp"
#include "support/property.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stridor::model {
namespace {

using parameters::Interpolation;
using support::number_between;
using support::whole_between;

FrictionLaw table(std::vector<double> speeds, std::vector<double> coefficients, Interpolation interpolation) {
    parameters::Contact contact;
    contact.friction = parameters::FrictionKind::table;
    contact.static_friction = 1.0;
    contact.friction_table = {"", std::move(speeds), std::move(coefficients)};
    contact.interpolation = interpolation;
    return friction_law(contact);
}

double mu(const FrictionLaw& law, double speed) {
    return slip_ratio(law, Slip::backward, -speed);
}

TEST(Measured, GoesThroughItsRowsAndHoldsAtItsEnds) {
    const std::vector<double> speeds{0.01, 0.02, 0.1, 0.5}, rows{0.8, 0.7, 0.4, 0.45};
    for (const Interpolation interpolation : {Interpolation::cubic, Interpolation::linear}) {
        const FrictionLaw law = table(speeds, rows, interpolation);
        for (std::size_t k = 0; k < rows.size(); ++k)
            EXPECT_NEAR(mu(law, speeds[k]), rows[k], 1e-15);
        EXPECT_EQ(mu(law, 0.0), 0.8);
        EXPECT_EQ(mu(law, 7.0), 0.45);
        EXPECT_EQ(slip_ratio_slope(law, Slip::backward, -7.0), 0.0);
        EXPECT_EQ(stick_limit(law, Slip::forward), 1.0);
    }
    EXPECT_NEAR(mu(table(speeds, rows, Interpolation::linear), 0.06), 0.55, 1e-15);
}

TEST(Measured, OfAParabolaIsNearIt) {
    std::vector<double> speeds, rows;
    for (int k = 0; k <= 20; ++k) {
        speeds.push_back(0.05 * k);
        rows.push_back(0.9 - 0.3 * speeds.back() - 0.2 * speeds.back() * speeds.back());
    }
    const FrictionLaw law = table(speeds, rows, Interpolation::cubic);
    for (double w = 0.0; w <= 1.0; w += 0.003)
        EXPECT_NEAR(mu(law, w), 0.9 - 0.3 * w - 0.2 * w * w, 2e-4);
}

// no peak or valley that is not measured, and a slope without jumps
RC_GTEST_PROP(Measured, IsMonotoneBetweenItsRows, ()) {
    std::vector<double> speeds{0.0}, rows{*number_between(0.0, 1.0)};
    for (int k = *whole_between(2, 8); k > 0; --k) {
        speeds.push_back(speeds.back() + *number_between(0.001, 1.0));
        rows.push_back(*number_between(0.0, 1.0));
    }
    const FrictionLaw law = table(speeds, rows, Interpolation::cubic);
    for (std::size_t k = 0; k + 1 < speeds.size(); ++k) {
        const auto [least, most] = std::minmax(rows[k], rows[k + 1]);
        double before = rows[k];
        for (int part = 1; part <= 40; ++part) {
            const double value = mu(law, speeds[k] + (speeds[k + 1] - speeds[k]) * part / 40.0);
            RC_ASSERT(value >= least - 1e-12);
            RC_ASSERT(value <= most + 1e-12);
            RC_ASSERT((value - before) * (rows[k + 1] - rows[k]) >= -1e-12);
            before = value;
        }
    }
}

}  // namespace
}  // namespace stridor::model
