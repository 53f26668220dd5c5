#include "stridor/sound/parabola.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

using stridor::sound::parabola_summit;
using stridor::sound::Summit;

namespace {

RC_GTEST_PROP(Parabola, HasItsSummitWhereItIs, ()) {
    const double place = *rc::gen::inRange(-500, 501) * 1e-3;
    const double height = *rc::gen::inRange(-1000, 1001) * 1e-2;
    const double bend = *rc::gen::inRange(1, 1000) * 1e-2;
    const auto value = [&](double x) { return height - bend * (x - place) * (x - place); };
    const Summit summit = parabola_summit(value(-1.0), value(0.0), value(1.0));
    RC_ASSERT(std::abs(summit.place - place) < 1e-9);
    RC_ASSERT(std::abs(summit.height - height) < 1e-9);
}

TEST(Parabola, IsTheMiddleValueWhereNothingBendsDown) {
    for (const Summit summit : {parabola_summit(1.0, 1.0, 1.0), parabola_summit(2.0, 1.0, 3.0)}) {
        EXPECT_EQ(summit.place, 0.0);
        EXPECT_EQ(summit.height, 1.0);
    }
}

TEST(Parabola, StaysWithinHalfAStep) {
    EXPECT_EQ(parabola_summit(0.0, 1.0, 1.9).place, 0.5);
}

}  // namespace
