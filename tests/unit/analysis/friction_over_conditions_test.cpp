#include "friction_fit_support.hpp"
#include "stridor/analysis/friction/over_conditions.hpp"
#include "support/counter_random.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace stridor::analysis {
namespace {

struct StribeckNumbers {
    double mu_s = 0.5, mu_d = 0.3, v_s = 0.02, delta = 1.0;
};

// 40 means at each of eight speeds, with noise of 0.3 % of the preload
FrictionAtTemperature measured_at(double temperature, const StribeckNumbers& law, std::uint64_t seed,
                                  std::size_t speeds = 8) {
    support::CounterRandom random(seed);
    FrictionAtTemperature measured{temperature, {}};
    for (std::size_t k = 0; k < speeds; ++k)
        for (std::size_t n = 0; n < 40; ++n) {
            FrictionPoint point;
            const double speed = 0.002 * std::pow(1.8, static_cast<double>(k));
            point.speeds.fill(speed);
            const double left = std::exp(-std::pow(speed / law.v_s, law.delta));
            point.friction = law.mu_d + (law.mu_s - law.mu_d) * left + 0.003 * normal(random);
            point.run = static_cast<std::size_t>(10.0 * temperature) + k;
            measured.data.points.push_back(point);
        }
    return measured;
}

// rubber that rubs less in the heat, and falls sooner
const std::vector<std::pair<double, StribeckNumbers>> softening{
    {60.0, {0.40, 0.25, 0.015}}, {-10.0, {0.70, 0.40, 0.040}}, {23.0, {0.50, 0.30, 0.020}}};

TEST(FrictionOverTemperature, FindsTheNumbersOfEachTemperature) {
    std::vector<FrictionAtTemperature> runs;
    for (const auto& [temperature, law] : softening)
        runs.push_back(measured_at(temperature, law, static_cast<std::uint64_t>(temperature + 100.0)));
    const FrictionOverConditions over = friction_over_temperature(std::move(runs));
    ASSERT_EQ(over.temperatures, (std::vector{-10.0, 23.0, 60.0}));
    ASSERT_EQ(fitted_names[over.whole.laws[over.whole.best].kind], "stribeck");
    EXPECT_EQ(words_of(over).find("The data bear stribeck."), 0U) << words_of(over);
    EXPECT_NE(words_of(over).find("It changes with the temperature."), std::string::npos) << words_of(over);
    for (std::size_t k = 0; k < 3; ++k) {
        const FittedLaw& law = law_at(over, over.whole.best, k);
        parameters::Contact truth;
        for (const auto& [temperature, numbers] : softening)
            if (temperature == over.temperatures[k]) {
                truth.static_friction = numbers.mu_s;
                truth.kinetic_friction = numbers.mu_d;
                truth.stribeck_velocity = numbers.v_s;
            }
        for (const FittedNumber& number : law.numbers) {
            if (number.field->symbol == "delta") continue;
            // an interval of 95 %, and half as much again
            const double value = true_value(truth, number.field->symbol), half = 0.5 * (number.to - number.from);
            EXPECT_NEAR(number.value, value, 1.5 * half) << number.field->symbol << over.temperatures[k];
            EXPECT_LT(half, 0.1 * value) << number.field->symbol;
        }
    }
}

TEST(FrictionOverTemperature, HasOneDeltaForAll) {
    // the Gaussian curve is plain at 20 degC; at 60 degC there is so little fall that either would do
    const FrictionOverConditions over = friction_over_temperature(
        {measured_at(20.0, {0.5, 0.3, 0.02, 2.0}, 1), measured_at(60.0, {0.302, 0.3, 0.02}, 2)});
    for (std::size_t k = 0; k < 2; ++k)
        EXPECT_EQ(law_at(over, law_called(over.whole, "stribeck"), k).contact.stribeck_exponent, 2.0);
}

TEST(FrictionOverTemperature, SaysWhereTheTemperatureChangesNothing) {
    const FrictionOverConditions over =
        friction_over_temperature({measured_at(0.0, {}, 1), measured_at(20.0, {}, 2), measured_at(40.0, {}, 3)});
    EXPECT_LT(over.gain, telling_difference);
    EXPECT_NE(words_of(over).find("Nothing shows that it changes with the temperature."), std::string::npos);
}

TEST(FrictionOverTemperature, RefusesOneTemperatureAndNamesTheOneThatIsShort) {
    EXPECT_TRUE(support::thrown_by([] {
                    friction_over_temperature({measured_at(20.0, {}, 1)});
                }).says("all runs are of one temperature"));
    EXPECT_TRUE(support::thrown_by([] {
                    friction_over_temperature({measured_at(20.0, {}, 1), {60.0, {}}});
                }).says("at 60 degC the runs give 0 independent means"));
}

// with fewer speeds than numbers at one temperature the law is fitted at none
TEST(FrictionOverTemperature, SaysAtWhichTemperatureALawIsNotFitted) {
    const FrictionOverConditions over =
        friction_over_temperature({measured_at(20.0, {}, 1), measured_at(60.0, {}, 2, 2)});
    EXPECT_TRUE(support::thrown_by([&] {
                    law_called(over.whole, "stribeck");
                }).says("at 60 degC its 3 numbers need as many speeds of slip; the runs have 2"));
}

}  // namespace
}  // namespace stridor::analysis
