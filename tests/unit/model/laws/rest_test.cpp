#include "stridor/model/laws/rest.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace stridor::model {
namespace {

using parameters::RestKind;

const RestGrowth laws[] = {
    {RestKind::logarithmic, 0.05, 0.5, 1.0}, {RestKind::kato, 0.3, 4.0, 0.36}, {RestKind::kato, 0.3, 4.0, 1.0}};
constexpr double times[] = {1e-12, 1e-6, 1e-3, 0.1, 1.0, 7.0, 1e3, 1e9};  // [s]

TEST(Rest, HasItsClosedForms) {
    for (const RestGrowth& rest : laws)
        for (const double t : times) {
            const double ratio = t / rest.time;
            const double wanted = rest.kind == RestKind::kato ? -0.3 * std::expm1(-std::pow(ratio, rest.exponent))
                                                              : 0.05 * std::log1p(ratio);
            EXPECT_NEAR(grown(rest, t), wanted, 1e-15 * (1.0 + std::abs(std::log(ratio)))) << t;
        }
}

TEST(Rest, BeginsWithNothingAndRisesEverMoreSlowly) {
    for (const RestGrowth& rest : laws) {
        EXPECT_EQ(grown(rest, 0.0), 0.0);
        for (const double t : times) {
            EXPECT_GE(grown(rest, t), 0.0);
            EXPECT_GE(grown(rest, 1.1 * t), grown(rest, t));
            EXPECT_GE(grown(rest, t), 0.5 * (grown(rest, 0.5 * t) + grown(rest, 1.5 * t)) - 1e-16);
        }
    }
}

TEST(Rest, IsFiniteWhateverItsTime) {
    for (RestGrowth rest : laws)
        for (const double time : {std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max()}) {
            rest.time = time;
            EXPECT_TRUE(std::isfinite(grown(rest, 1.0)));
        }
}

TEST(Rest, IsThatOfACaseThatCanStick) {
    parameters::Contact contact;
    EXPECT_FALSE(grows(rest_growth(contact)));
    contact.rest = RestKind::kato;
    contact.rest_growth = 0.3;
    contact.rest_time = 4.0;
    contact.rest_exponent = 0.36;
    contact.rested = 2.0;
    EXPECT_EQ(rest_growth(contact), (RestGrowth{RestKind::kato, 0.3, 4.0, 0.36, 2.0}));
    contact.friction = parameters::FrictionKind::tanh;
    EXPECT_FALSE(grows(rest_growth(contact)));
}

}  // namespace
}  // namespace stridor::model
