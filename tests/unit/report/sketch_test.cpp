#include "stridor/report/sketch.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <string>

namespace stridor::report {
namespace {

TEST(Sketch, NamesWhatTheCaseSays) {
    parameters::Case c;
    c.joint.incidence_angle = 35.0;
    c.contact.preload = 12.5;
    c.contact.kinetic_friction = 0.45;
    const std::string svg = sketch_svg(c);
    for (const char* text : {"35°", "12.5 N", "0.45", ">k<", ">c<", ">m<", ">V<"})
        EXPECT_NE(svg.find(text), std::string::npos) << text;
}

TEST(Sketch, StaysWithinItsFrameAtEveryAngle) {
    const std::regex place("translate\\((-?[0-9.]+) (-?[0-9.]+)\\)");
    for (int angle = -360; angle <= 360; angle += 5) {
        parameters::Case c;
        c.joint.incidence_angle = angle;
        const std::string svg = sketch_svg(c);
        EXPECT_EQ(svg.find("nan"), std::string::npos) << angle;
        EXPECT_EQ(svg.find("inf"), std::string::npos) << angle;
        int supports = 0;
        for (std::sregex_iterator it(svg.begin(), svg.end(), place), end; it != end; ++it, ++supports) {
            EXPECT_GE(std::stod((*it)[1]), 0.0) << angle;
            EXPECT_LE(std::stod((*it)[1]), 340.0) << angle;
            EXPECT_LE(std::stod((*it)[2]), 170.1) << "no support of the joint hangs in the plate, " << angle;
        }
        EXPECT_EQ(supports, 3) << angle;
    }
}

}  // namespace
}  // namespace stridor::report
