#include "stridor/parameters/rules/engines.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace stridor::parameters {
namespace {

constexpr Method methods[] = {Method::exact, Method::taylor, Method::moreau, Method::massless, Method::beta_2};

// the row of a demand in the table of docs/methods/engines.md
std::string row_of(std::size_t demand) {
    std::string row = "| " + std::string(demand_names[demand]) + " |";
    for (const Method method : methods)
        row += refusal(method, {static_cast<Demand>(demand)}) ? " |" : " yes |";
    return row;
}

TEST(Engines, AreDescribedByTheirTable) {
    std::ifstream page(STRIDOR_SOURCE_DIR "/docs/methods/engines.md");
    std::string text;
    for (std::string line; std::getline(page, line);)
        text += line + "\n";
    for (std::size_t demand = 0; demand < demand_names.size(); ++demand)
        EXPECT_NE(text.find("\n" + row_of(demand) + "\n"), std::string::npos) << row_of(demand);
}

TEST(Engines, RefuseByNameWithAReasonAndAWayOut) {
    for (std::size_t demand = 0; demand < demand_names.size(); ++demand)
        for (const Method method : methods)
            if (const auto problem = refusal(method, {static_cast<Demand>(demand)}, "best")) {
                EXPECT_TRUE(problem->what.starts_with("the best engine ")) << problem->what;
                EXPECT_FALSE(problem->why.empty()) << problem->what;
                EXPECT_FALSE(problem->suggestion.empty()) << problem->what;
            }
}

TEST(Engines, FollowFromEngineAndFormulation) {
    Case c;
    EXPECT_EQ(methods_of(c), std::vector{Method::exact});
    c.joints.emplace_back();
    EXPECT_EQ(methods_of(c), std::vector{Method::taylor});
    c.run.engine = Engine::moreau;
    EXPECT_EQ(methods_of(c), std::vector{Method::moreau});
    c.run.formulation = Formulation::both;
    EXPECT_EQ(methods_of(c), (std::vector{Method::moreau, Method::massless}));
    c.run.engine = Engine::beta_2;
    EXPECT_EQ(methods_of(c), std::vector{Method::beta_2});
}

// what rests changes when a stick ends: Taylor's series take such a joint; without a stick nothing rests
TEST(Engines, SolveByDefaultWhatGrowsWithRest) {
    Case c;
    c.contact().rest = RestKind::logarithmic;
    EXPECT_EQ(methods_of(c), std::vector{Method::taylor});
    EXPECT_FALSE(refusal(Method::taylor, {Demand::growing_friction}));
    c.contact().friction = FrictionKind::tanh;
    EXPECT_FALSE(grows_with_rest(c.contact()));
    c.run.engine = Engine::automatic;
    EXPECT_EQ(methods_of(c), std::vector{Method::moreau});
}

TEST(Engines, AreChosenByWhatTheExactOneCannotSolve) {
    Case c;
    EXPECT_FALSE(why_not_exact(c));
    c.run.engine = Engine::automatic;
    EXPECT_EQ(engine_of(c), Engine::exact);
    EXPECT_EQ(methods_of(c), std::vector{Method::exact});
    c.contact().impact = ImpactKind::restitution;
    EXPECT_EQ(engine_of(c), Engine::exact);
    c.contact().impact = ImpactKind::plastic;
    c.contact().friction = FrictionKind::stribeck;
    EXPECT_EQ(methods_of(c), std::vector{Method::taylor});
    c.joints.emplace_back();
    c.joints.back().contact.friction = FrictionKind::stribeck;
    c.joints.back().contact.stribeck_exponent = 1.5;
    EXPECT_EQ(engine_of(c), Engine::moreau);
    EXPECT_EQ(methods_of(c), std::vector{Method::moreau});
    ASSERT_TRUE(why_not_exact(c));
    EXPECT_EQ(why_not_exact(c)->what, "the exact engine has no power series of this law of friction");
}

}  // namespace
}  // namespace stridor::parameters
