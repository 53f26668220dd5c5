// The law of friction on the page: its points set what they say, and the curve goes through where they are taken.

#include "stridor/explorer/api.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace stridor::explorer {
namespace {

using nlohmann::json;

json law_of(const std::vector<std::string>& set, bool visited = false, const std::string& preset = "squeal") {
    World world;
    world.presets = paper_presets();
    HttpRequest request;
    request.method = "POST";
    request.path = "/api/friction";
    request.body = json{{"preset", preset}, {"set", set}, {"visited", visited}}.dump();
    const Response response = answer(world, request, {});
    EXPECT_EQ(response.status, 200) << response.body;
    return json::parse(response.body);
}

// between the points of the curve as straight lines
double friction_at(const json& law, const json& curve, double speed) {
    const auto speeds = law["speeds"].get<std::vector<double>>();
    const auto values = curve["friction"].get<std::vector<double>>();
    const auto after = std::upper_bound(speeds.begin() + 1, speeds.end() - 1, speed) - speeds.begin();
    const auto k = static_cast<std::size_t>(after);
    const double share = (speed - speeds[k - 1]) / (speeds[k] - speeds[k - 1]);
    return values[k - 1] + share * (values[k] - values[k - 1]);
}

const json& curve_of(const json& law, const json& grip) {
    for (const json& curve : law["curves"])
        if (curve["way"] == grip["way"]) return curve;
    return law["curves"][0];
}

struct Law {
    const char* name;
    std::vector<std::string> set;
};
std::ostream& operator<<(std::ostream& out, const Law& law) {
    return out << law.name;
}

class GripsOf : public testing::TestWithParam<Law> {};

// a point that is taken elsewhere lies there: at the limit of the stick, or on the curve of the slip
TEST_P(GripsOf, LieWhereTheyAreTaken) {
    const json law = law_of(GetParam().set);
    ASSERT_GE(law["grips"].size(), 2U);
    for (const json& grip : law["grips"]) {
        const bool along_speed = grip["along"] == "speed";
        const double low = grip["low"];
        const double high = grip["high"].is_null() ? 2.0 * grip[along_speed ? "speed" : "friction"].get<double>()
                                                   : grip["high"].get<double>();
        for (const double share : {0.3, 0.8}) {
            const double taken = low + share * (high - low);
            const double value = grip["origin"].get<double>() + grip["rate"].get<double>() * taken;
            std::vector<std::string> set = GetParam().set;
            set.push_back(grip["key"].get<std::string>() + "=" + std::to_string(value));
            const json moved = law_of(set);
            const double speed = along_speed ? taken : grip["speed"].get<double>();
            const json& curve = curve_of(moved, grip);
            const bool is_limit = !curve["limit"].is_null() &&
                                  grip["key"].get<std::string>().find("static_friction") != std::string::npos;
            if (along_speed) {
                // what is moved is where the curve has this height
                EXPECT_NEAR(friction_at(moved, curve, speed), grip["friction"].get<double>(), 2e-2) << grip;
            } else {
                EXPECT_NEAR(is_limit ? curve["limit"].get<double>() : friction_at(moved, curve, speed), taken, 2e-3)
                    << grip;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Laws, GripsOf,
    testing::Values(
        Law{"Coulomb", {}},
        Law{"Directional",
            {"contact.friction=directional", "contact.static_friction_coming=0.5",
             "contact.kinetic_friction_coming=0.2"}},
        Law{"Linear", {"contact.friction=linear", "contact.friction_slope=0.3"}},
        Law{"Stribeck", {"contact.friction=stribeck", "contact.stribeck_velocity=0.05"}},
        Law{"Viscous", {"contact.friction=stribeck", "contact.stribeck_velocity=0.05", "contact.viscous_friction=0.4"}},
        Law{"Regularised",
            {"contact.friction=tanh", "contact.regularisation=0.01", "run.engine=moreau", "run.step=1e-5"}},
        Law{"LuGre",
            {"contact.friction=lugre", "contact.stribeck_velocity=0.05", "contact.bristle_stiffness=1e5",
             "contact.bristle_damping=0"}},
        Law{"Rational", {"contact.friction=stribeck-rational", "contact.stribeck_velocity=0.02"}}),
    [](const testing::TestParamInfo<Law>& info) { return info.param.name; });

// whoever creeps has no stick that could hold up to anything
TEST(FrictionAnswer, HasNoStickOfALawThatCreeps) {
    EXPECT_EQ(law_of({})["curves"][0]["limit"], 0.8);
    EXPECT_TRUE(law_of({"contact.friction=tanh", "contact.regularisation=0.01", "run.engine=moreau",
                        "run.step=1e-5"})["curves"][0]["limit"]
                    .is_null());
    const json aged =
        law_of({"contact.friction=dieterich", "contact.direct_effect=0.01", "contact.evolution_effect=0.015",
                "contact.slip_length=1e-5", "contact.reference_velocity=1e-3"});
    EXPECT_TRUE(aged["curves"][0]["limit"].is_null());
    EXPECT_EQ(aged["grips"].size(), 1U);
    EXPECT_NEAR(aged["grips"][0]["friction"].get<double>(), 0.6, 1e-6);
}

TEST(FrictionAnswer, HasTheRowsOfATable) {
    const json law = law_of({"contact.friction=table", "contact.friction_table=0: 0.8, 0.01: 0.5, 0.2: 0.6"});
    ASSERT_EQ(law["rows"].size(), 3U);
    EXPECT_EQ(law["rows"][1], (json{{"speed", 0.01}, {"friction", 0.5}}));
    EXPECT_EQ(law["grips"].size(), 0U);
    EXPECT_EQ(law["speeds"].back(), 0.2);
}

TEST(FrictionAnswer, TellsTheSpeedsAtWhichTheCaseSlips) {
    EXPECT_TRUE(law_of({})["visited"].is_null());
    // steady sliding at the speed of the plate
    const json steady = law_of(
        {"drive.kind=constant", "drive.velocity=-0.1", "run.initial=sliding", "run.perturbation=0"}, true, "quiet");
    EXPECT_NEAR(steady["visited"]["from"].get<double>(), 0.1, 1e-9);
    EXPECT_NEAR(steady["visited"]["to"].get<double>(), 0.1, 1e-9);
    const json squeal = law_of({}, true);
    EXPECT_EQ(squeal["visited"]["from"], 0.0);
    EXPECT_GT(squeal["visited"]["to"], 0.1);
    EXPECT_GE(squeal["speeds"].back().get<double>(), squeal["visited"]["to"].get<double>());
}

}  // namespace
}  // namespace stridor::explorer
