#include "stridor/integration/failure.hpp"

#include "stridor/integration/simulate.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace stridor::integration {
namespace {

using parameters::Case;

Motion ended(Reason reason) {
    Motion motion;
    motion.outcome = {reason, 0.25};
    return motion;
}

TEST(Failure, IsNothingForARunWithAResult) {
    EXPECT_FALSE(failure(Case{}, ended(Reason::completed)).has_value());
    EXPECT_FALSE(failure(Case{}, ended(Reason::settled)).has_value());
}

TEST(Failure, SaysOfEachOtherOutcomeSomethingElse) {
    std::set<std::string> sentences;
    for (const Reason reason :
         {Reason::diverged, Reason::step_limit, Reason::cancelled, Reason::chattering, Reason::unbalanced}) {
        const std::optional<Error> error = failure(Case{}, ended(reason));
        ASSERT_TRUE(error.has_value());
        EXPECT_FALSE(error->problem().why.empty());
        EXPECT_FALSE(error->problem().suggestion.empty());
        sentences.insert(error->what());
    }
    EXPECT_EQ(sentences.size(), 5U);
}

TEST(Failure, SaysWhereTheMotionEnded) {
    EXPECT_EQ(failure(Case{}, ended(Reason::diverged))->problem().what,
              "the motion left double precision at 0.25 s of 1 s");
    EXPECT_EQ(failure(Case{}, ended(Reason::diverged))->kind(), ErrorKind::numerical);
    EXPECT_EQ(failure(Case{}, ended(Reason::cancelled))->kind(), ErrorKind::interrupted);
}

TEST(Failure, NamesAStepThatIsStable) {
    Case c;
    c.run.engine = parameters::Engine::beta_2;
    c.run.step = 3e-4;
    const std::optional<Error> error = failure(c, simulate(c));
    ASSERT_TRUE(error.has_value());
    EXPECT_EQ(error->kind(), ErrorKind::input);
    EXPECT_EQ(std::string(error->what()),
              "run.step = 3e-04 s is beyond the stability limit 0.0002 s (the highest open mode would grow without "
              "bound). Use at most 2e-05 s; 1e-06 s or less for rates you quote.");
    EXPECT_EQ(std::string(beyond_step_limit(c).what()), error->what());
}

TEST(Failure, NamesAStepThatMoreauTakes) {
    Case c;
    c.run.engine = parameters::Engine::moreau;
    c.run.step = 1.6e-4;
    const std::optional<Error> error = failure(c, simulate(c));
    ASSERT_TRUE(error.has_value());
    EXPECT_NE(std::string(error->what()).find("run.step = 0.00016 s is beyond the limit 0.0001571 s"),
              std::string::npos)
        << error->what();
}

}  // namespace
}  // namespace stridor::integration
