#include "stridor/pictures/parts/field_axis.hpp"

#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/tables/temperature_table.hpp"
#include "support/property.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::pictures {
namespace {

using sweep::Scale;

TEST(CellEdges, AreMidpointsOnALinearAxis) {
    EXPECT_EQ(cell_edges({"contact.kinetic_friction", 0.0, 1.0, 3, Scale::linear}),
              (std::vector<double>{-0.25, 0.25, 0.75, 1.25}));
}

TEST(CellEdges, AreGeometricMeansOnALogarithmicAxis) {
    const std::vector<double> edges = cell_edges({"contact.preload", 1.0, 100.0, 3, Scale::logarithmic});
    ASSERT_EQ(edges.size(), 4U);
    for (std::size_t i = 0; i < edges.size(); ++i)
        // half decades around 1, 10, 100; value_at's own logarithm is good to 1e-15
        EXPECT_NEAR(std::log10(edges[i]), static_cast<double>(i) - 0.5, 1e-13) << i;
}

RC_GTEST_PROP(CellEdges, HoldTheirValueAndAreEquallyLong, ()) {
    const Scale scale = *rc::gen::element(Scale::linear, Scale::logarithmic);
    const int points = *support::whole_between(2, 60);
    const double from = *support::number_between(0.5, 100.0);
    const sweep::Axis axis{"contact.preload", from, from + *support::number_between(0.1, 5000.0), points, scale};
    const std::vector<double> edges = cell_edges(axis);
    const drawing::PanelAxis drawn = field_axis(axis);
    RC_ASSERT(edges.size() == static_cast<std::size_t>(points) + 1U);
    RC_ASSERT(drawn.range == (drawing::Extent{edges.front(), edges.back()}));
    const auto length = [&](std::size_t i) {
        return scale == Scale::linear ? edges[i + 1] - edges[i] : std::log(edges[i + 1] / edges[i]);
    };
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        const double value = sweep::value_at(axis, static_cast<int>(i));
        RC_ASSERT(edges[i] < value && value < edges[i + 1]);
        RC_ASSERT(std::abs(length(i) - length(0)) <= 1e-9 * (length(0) + axis.to));
    }
}

TEST(CellEdges, RiseEvenIfTheAxisFalls) {
    const std::vector<double> edges = cell_edges({"contact.preload", 10.0, 1.0, 2, Scale::linear});
    EXPECT_LT(edges.front(), edges.back());
}

TEST(FieldAxis, IsCalledAsInTheFieldTable) {
    const drawing::PanelAxis axis = field_axis({"contact.preload", 1.0, 100.0, 3, Scale::logarithmic});
    EXPECT_EQ(drawing::plain_text(axis.label), "preload F");
    EXPECT_EQ(axis.unit, "N");
    EXPECT_EQ(axis.scale, drawing::AxisScale::logarithmic);
    EXPECT_EQ(drawing::plain_text(field_axis({"contact.kinetic_friction", 0.0, 1.0, 3, Scale::linear}).label),
              "kinetic friction μd");
}

TEST(Setting, HasSymbolValueAndUnit) {
    const parameters::Case c;
    EXPECT_EQ(drawing::plain_text(setting(c, "joint.incidence_angle")), "α = 70°");
    EXPECT_EQ(drawing::plain_text(setting(c, "contact.preload")), "F = 20 N");
    EXPECT_EQ(drawing::plain_text(setting(c, "run.initial")), "initial = rest");
}

TEST(Conditions, LeaveOutWhatVariesAndWhatDoesNotBelong) {
    const parameters::Case c;
    const std::array<std::string_view, 1> varied{"contact.preload"};
    const std::string text = drawing::plain_text(conditions(c, varied));
    EXPECT_EQ(text.find("F = "), std::string::npos);
    EXPECT_EQ(text.find("V = "), std::string::npos) << "the drive is sinusoidal";
    EXPECT_NE(text.find("μs = 0.8"), std::string::npos);
    EXPECT_NE(text.find("initial = rest"), std::string::npos);
}

TEST(Conditions, NameNoValueOfWhatFollowsAnAxis) {
    parameters::Case c;
    using Holds = parameters::TemperatureColumn::Holds;
    parameters::set_temperature_table(c, {-30.0, 80.0},
                                      {{"contact.kinetic_friction", {0.5, 0.7}, Holds::quantity},
                                       {"joint.axial_stiffness", {2e7, 1e7}, Holds::quantity}});
    const std::string at_one = drawing::plain_text(conditions(c));
    EXPECT_NE(at_one.find("μs = 0.8, μd = "), std::string::npos) << at_one;
    EXPECT_NE(at_one.find(", θ = "), std::string::npos) << at_one;
    const std::array<std::string_view, 1> varied{"temperature.value"};
    const std::string over = drawing::plain_text(conditions(c, varied));
    EXPECT_EQ(over.find("μd ="), std::string::npos) << over;
    EXPECT_EQ(over.find("θ ="), std::string::npos) << over;
    EXPECT_NE(over.find("μs = 0.8"), std::string::npos) << over;
    EXPECT_TRUE(over.ends_with("; k1i, μd over θ by table")) << over;
}

TEST(Conditions, NameNoCoefficientOfAPairWhoseLoadIsAnAxis) {
    parameters::Case c;
    parameters::set_from_text(c, *parameters::find_field("contact.pair"),
                              "load: 10, 40; static_friction: 1, 0.9; kinetic_friction: 0.8, 0.7");
    const std::array<std::string_view, 1> load{"contact.preload"};
    const std::array<std::string_view, 1> velocity{"drive.velocity"};
    EXPECT_EQ(drawing::plain_text(conditions(c, load)).find("μs ="), std::string::npos);
    EXPECT_NE(drawing::plain_text(conditions(c, velocity)).find("μs = 0.966"), std::string::npos);
}

TEST(FieldAxis, OfOneOfSeveralJointsSaysWhose) {
    const parameters::Case c = parameters::two_lips();
    const drawing::PanelAxis axis =
        field_axis({"joint.lower.contact.preload", 10.0, 400.0, 3, sweep::Scale::logarithmic});
    EXPECT_EQ(drawing::plain_text(axis.label).rfind("lower: preload ", 0), 0U) << drawing::plain_text(axis.label);
    EXPECT_EQ(axis.unit, "N");
    EXPECT_EQ(drawing::plain_text(setting(c, "joint.lower.incidence_angle")).rfind("lower: ", 0), 0U);
    EXPECT_NE(drawing::plain_text(setting(c, "joint.lower.incidence_angle")).find("60"), std::string::npos);
}

TEST(FieldAxis, ConditionsOfSeveralJointsAreThoseTheyHaveInCommon) {
    const parameters::Case c = parameters::two_lips();
    const std::string said = drawing::plain_text(conditions(c));
    EXPECT_NE(said.find("200 N"), std::string::npos) << said;
    EXPECT_EQ(said.find("70"), std::string::npos) << said;  // they lean differently
    const std::vector<std::string_view> varied{"joint.lower.contact.preload"};
    EXPECT_EQ(drawing::plain_text(conditions(c, varied)).find("200 N"), std::string::npos);
}

}  // namespace
}  // namespace stridor::pictures
