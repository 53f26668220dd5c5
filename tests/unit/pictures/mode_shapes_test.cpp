#include "stridor/pictures/mode_shapes.hpp"

#include "pictures_support.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/paper_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <variant>
#include <vector>

namespace stridor::pictures {
namespace {

analysis::StabilityScan scan_of(const parameters::Case& c) {
    return analysis::with_modes(analysis::scan_stability(c, std::nullopt));
}

TEST(ModeShapes, StandForTheDirectionThatGrows) {
    const drawing::Scene scene = mode_shapes(scan_of(parameters::paper_case(parameters::PaperCase::squeal)));
    ASSERT_EQ(scene.panels.size(), 3U) << "one mode grows";
    EXPECT_NE(drawing::plain_text(scene.caption.front()).find("going"), std::string::npos);
    EXPECT_NE(drawing::plain_text(scene.panels.front().title).find("592.0 Hz, +736.7 1/s"), std::string::npos)
        << drawing::plain_text(scene.panels.front().title);
}

TEST(ModeShapes, HaveABarForEachContactThatFeeds) {
    parameters::Case c = parameters::two_lips();
    c.contact.kinetic_friction = 0.7;
    c.further_joints.front().contact.kinetic_friction = 0.7;
    const analysis::StabilityScan scan = scan_of(c);
    const drawing::Scene scene = mode_shapes(scan);
    ASSERT_EQ(scene.panels.size() % 3, 0U);
    const auto growth = [](const analysis::DirectionScan& direction) {
        return direction.modes->modes.empty() ? -1e9 : direction.modes->modes.front().eigenvalue.real();
    };
    const analysis::DirectionScan& shown =
        growth(scan.directions[0]) >= growth(scan.directions[1]) ? scan.directions[0] : scan.directions[1];
    for (const drawing::Panel& panel : scene.panels) {
        if (panel.row != 1) continue;
        const std::vector<double>& each = shown.modes->modes[panel.column].contact_growth;
        // a contact that sliding lifts off feeds nothing
        const auto feeding = std::count_if(each.begin(), each.end(), [](double value) { return value != 0.0; });
        EXPECT_GE(feeding, 1);
        std::size_t bars = 0;
        for (const drawing::Layer& layer : panel.layers)
            if (const auto* boxes = std::get_if<drawing::Boxes>(&layer)) bars += boxes->boxes.size();
        EXPECT_EQ(bars, static_cast<std::size_t>(feeding));
        EXPECT_EQ(panel.x.ticks.size(), 2U);
    }
    // shares of energy lie on their axis
    for (const drawing::Panel& panel : scene.panels)
        for (const drawing::Layer& layer : panel.layers)
            if (const auto* boxes = std::get_if<drawing::Boxes>(&layer))
                for (const drawing::Box& box : boxes->boxes) {
                    EXPECT_GE(box.y.from, panel.y.range.from);
                    EXPECT_LE(box.y.to, panel.y.range.to);
                }
}

}  // namespace
}  // namespace stridor::pictures
