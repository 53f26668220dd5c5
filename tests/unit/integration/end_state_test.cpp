#include "stridor/integration/run/end_state.hpp"

#include "stridor/integration/simulate.hpp"
#include "support/constant_case.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace stridor::integration {
namespace {

using parameters::Case;
using support::short_case;
using support::thrown_by;

TEST(EndState, IsRefusedByAnotherStructure) {
    EndState state = run_to_end(short_case()).state;
    Case c = short_case();
    c.run.duration = 0.04;
    state.displacement.pop_back();
    const auto thrown = thrown_by([&] { go_on(c, state); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("none of this case")) << thrown.message;
}

// whatever numbers a file has, nothing is read beyond them and no state is made of them that there is not
TEST(EndState, IsRefusedWithADamagedMemory) {
    Case c = short_case();
    for (const parameters::Engine engine :
         {parameters::Engine::exact, parameters::Engine::beta_2, parameters::Engine::moreau}) {
        c.run.engine = engine;
        c.run.step = 1e-5;
        c.run.duration = 0.02;
        const EndState state = run_to_end(c).state;
        c.run.duration = 0.04;
        EXPECT_NO_THROW(go_on(c, state));
        EndState shorter = state;
        shorter.memory.front().pop_back();
        EXPECT_TRUE(thrown_by([&] { go_on(c, shorter); }).says("none of this case and engine"));
        EndState longer = state;
        longer.memory.front().push_back(0.0);
        EXPECT_TRUE(thrown_by([&] { go_on(c, longer); }).says("none of this case and engine"));
        EndState none = state;
        none.memory.clear();
        EXPECT_TRUE(thrown_by([&] { go_on(c, none); }).says("none of this case and engine"));
    }
    c.run.engine = parameters::Engine::exact;
    c.run.duration = 0.02;
    EndState wild = run_to_end(c).state;
    wild.memory.front().front() = 1e300;  // what the contact does
    c.run.duration = 0.04;
    EXPECT_TRUE(thrown_by([&] { go_on(c, wild); }).says("none of this case and engine"));
}

TEST(EndState, LiesBeforeTheWindowThatIsJudged) {
    Case c = short_case();
    const EndState state = run_to_end(c).state;
    EXPECT_TRUE(thrown_by([&] { go_on(c, state); }).says("is not beyond the end state"));
    c.run.duration = 0.04;
    c.run.window = 0.03;
    const auto thrown = thrown_by([&] { go_on(c, state); });
    EXPECT_TRUE(thrown.says("the window begins before the end state")) << thrown.message;
    EXPECT_TRUE(thrown.says("at most 0.02 s")) << thrown.message;
}

}  // namespace
}  // namespace stridor::integration
