#include "stridor/integration/failure.hpp"

#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/own_structure.hpp"

#include <gtest/gtest.h>

#include <memory>
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
    for (const Reason reason : {Reason::diverged, Reason::step_limit, Reason::cancelled, Reason::chattering,
                                Reason::unbalanced, Reason::no_forces, Reason::painleve}) {
        const std::optional<Error> error = failure(Case{}, ended(reason));
        ASSERT_TRUE(error.has_value());
        EXPECT_FALSE(error->problem().why.empty());
        EXPECT_FALSE(error->problem().suggestion.empty());
        sentences.insert(error->what());
    }
    EXPECT_EQ(sentences.size(), 7U);
}

TEST(Failure, SaysWhereTheMotionEnded) {
    EXPECT_EQ(failure(Case{}, ended(Reason::diverged))->problem().what,
              "the motion left double precision at 0.25 s of 1 s");
    EXPECT_EQ(failure(Case{}, ended(Reason::diverged))->kind(), ErrorKind::numerical);
    EXPECT_EQ(failure(Case{}, ended(Reason::cancelled))->kind(), ErrorKind::interrupted);
}

TEST(Failure, SaysWhatEachContactDidWhereNoForcesObeyTheLaws) {
    Motion motion = ended(Reason::painleve);
    motion.last_set = {model::ContactState::slip};
    EXPECT_EQ(failure(Case{}, motion)->problem().what,
              "no forces obey all laws of contact at 0.25 s of 1 s; the contact slips");
    auto own = std::make_shared<parameters::OwnStructure>();
    own->contacts.resize(14);
    for (std::size_t k = 0; k < own->contacts.size(); ++k)
        own->contacts[k].name = std::string(1, static_cast<char>('a' + k));
    Case c;
    c.own_structure = own;
    motion.last_set = {model::ContactState::stick, model::ContactState::separation};
    EXPECT_EQ(failure(c, motion)->problem().what,
              "no forces obey all laws of contact at 0.25 s of 1 s; a sticks, b is separated");
    motion.pressed = {0, 2};
    EXPECT_EQ(failure(c, motion)->problem().why,
              "friction presses a and c together without end: a Painleve configuration");
    motion.outcome.reason = Reason::chattering;
    motion.last_set.resize(14, model::ContactState::slip);
    EXPECT_EQ(
        failure(c, motion)->problem().what,
        "events pile up without end at 0.25 s of 1 s; a sticks, b is separated, c slips, d slips, e slips, f slips, g "
        "slips, h slips, i slips, j slips, k slips, l slips, and 2 contacts more");
}

TEST(Failure, NamesAStepThatIsStable) {
    Case c;
    c.run.engine = parameters::Engine::beta_2;
    c.run.step = 3e-4;
    const std::optional<Error> error = failure(c, simulate(c));
    ASSERT_TRUE(error.has_value());
    EXPECT_EQ(error->kind(), ErrorKind::input);
    EXPECT_EQ(
        std::string(error->what()),
        "run.step = 3e-04 s is beyond the stability limit 0.0001 s (at twice the step, with which it is compared, "
        "the highest open mode would grow without bound). Use at most 1e-05 s; 1e-06 s or less for rates you "
        "quote.");
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
