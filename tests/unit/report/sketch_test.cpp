#include "stridor/report/sketch.hpp"

#include "stridor/parameters/joints.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <string>
#include <vector>

namespace stridor::report {
namespace {

TEST(Sketch, NamesWhatTheCaseSays) {
    parameters::Case c;
    c.joint().incidence_angle = 35.0;
    c.contact().preload = 12.5;
    c.contact().kinetic_friction = 0.45;
    const std::string svg = sketch_svg(c);
    for (const char* text : {"35°", "12.5 N", "0.45", ">k<", ">c<", ">m<", ">V<"})
        EXPECT_NE(svg.find(text), std::string::npos) << text;
}

TEST(Sketch, StaysWithinItsFrameAtEveryAngle) {
    const std::regex place("translate\\((-?[0-9.]+) (-?[0-9.]+)\\)");
    for (int angle = -360; angle <= 360; angle += 5) {
        parameters::Case c;
        c.joint().incidence_angle = angle;
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

// Seen at 45 degrees: "F = 20 N" on "k1i".
TEST(Sketch, KeepsItsLabelsApartAtEveryAngle) {
    struct Label {
        double left, right, y;
    };
    const std::regex text("<text x=\"(-?[0-9.]+)\" y=\"(-?[0-9.]+)\">(.*?)</text>");
    const std::regex tag("<[^>]*>");
    for (int angle = -360; angle <= 360; angle += 5) {
        parameters::Case c;
        c.joint().incidence_angle = angle;
        const std::string svg = sketch_svg(c);
        std::vector<Label> labels;
        for (std::sregex_iterator it(svg.begin(), svg.end(), text), end; it != end; ++it) {
            const double left = std::stod((*it)[1]);
            const double length = 5.5 * static_cast<double>(std::regex_replace((*it)[3].str(), tag, "").size());
            labels.push_back({left, left + length, std::stod((*it)[2])});
        }
        ASSERT_EQ(labels.size(), 15U) << angle;
        for (std::size_t i = 0; i < labels.size(); ++i) {
            EXPECT_GE(labels[i].left, 0.0) << angle;
            EXPECT_LE(labels[i].right, 340.0) << angle;
            EXPECT_GE(labels[i].y, 9.0) << angle;
            for (std::size_t k = 0; k < i; ++k)
                EXPECT_TRUE(labels[i].right <= labels[k].left || labels[k].right <= labels[i].left ||
                            std::abs(labels[i].y - labels[k].y) >= 10.0)
                    << angle << " degrees: labels " << k << " and " << i;
        }
    }
}

// Seen in a browser: "V = 0.12 m/"
TEST(Sketch, KeepsTheVelocityWithinItsFrame) {
    const std::regex text(
        "<text x=\"([0-9.]+)\" y=\"204.0\"><tspan font-style=\"italic\">V</tspan><tspan dy=\"0\">(.*?)<");
    for (const double velocity : {0.1, 0.12, -0.0125, 1.234e-7}) {
        parameters::Case c;
        c.drive.kind = parameters::DriveKind::constant;
        c.drive.velocity = velocity;
        const std::string svg = sketch_svg(c);
        std::smatch label;
        ASSERT_TRUE(std::regex_search(svg, label, text)) << velocity;
        EXPECT_LE(std::stod(label[1]) + 6.5 * static_cast<double>(label[2].length() + 1), 340.0) << label[2];
    }
}

TEST(Sketch, OfSeveralJointsHasEachInAPlaceOfItsOwn) {
    const std::string svg = sketch_svg(parameters::two_lips());
    for (const char* text : {"viewBox=\"0 0 680 250\"", ">upper<", ">lower<", "70°", "60°", "translate(340.0 0)"})
        EXPECT_NE(svg.find(text), std::string::npos) << text;
}

}  // namespace
}  // namespace stridor::report
