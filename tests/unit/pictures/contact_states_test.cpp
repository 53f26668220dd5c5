#include "stridor/pictures/contact_states.hpp"

#include "pictures_support.hpp"
#include "stridor/drawing/palette.hpp"
#include "stridor/pictures/parts/category_colours.hpp"

#include <gtest/gtest.h>

namespace stridor::pictures {
namespace {

using model::ContactState;

const record::ContactHistory history{{ContactState::slip, 0.0, 0.2, 0.0, 0.0},
                                     {ContactState::separation, 0.2, 0.3, 0.0, 0.0},
                                     {ContactState::stick, 0.3, 1.0, 0.0, 0.0}};

TEST(StatePanel, HasARowPerStateInItsColour) {
    const drawing::Panel panel = state_panel(std::span(&history, 1), {0.0, 1.0});
    const drawing::Strip strip = layers_of<drawing::Strip>(panel).at(0);
    ASSERT_EQ(strip.rows.size(), 3U);
    ASSERT_EQ(panel.y.ticks.size(), 3U);
    for (std::size_t row = 0; row < 3; ++row) {
        EXPECT_EQ(strip.rows[row], state_colour(static_cast<ContactState>(row)));
        EXPECT_EQ(drawing::plain_text(panel.y.ticks[row].label), model::contact_state_names[row]);
    }
    ASSERT_EQ(strip.intervals.size(), 3U);
    EXPECT_EQ(strip.intervals[1].row, model::index_of(ContactState::separation));
    EXPECT_EQ(strip.intervals[1].to, 0.3);
}

TEST(StatePanel, HasRowsForEachContact) {
    const std::vector<record::ContactHistory> histories{history, {{ContactState::stick, 0.0, 1.0, 0.0, 0.0}}};
    const drawing::Panel panel = state_panel(histories, {0.0, 1.0});
    const drawing::Strip strip = layers_of<drawing::Strip>(panel).at(0);
    ASSERT_EQ(panel.y.ticks.size(), 6U);
    EXPECT_EQ(drawing::plain_text(panel.y.ticks[0].label), "slip 1");
    EXPECT_EQ(drawing::plain_text(panel.y.ticks[4].label), "stick 2");
    ASSERT_EQ(strip.intervals.size(), 4U);
    EXPECT_EQ(strip.intervals[3].row, model::contact_states + model::index_of(ContactState::stick));
}

TEST(ContactStates, StackCasesOverOneTimeAxis) {
    parameters::Case squeak;
    squeak.contact().preload = 200.0;
    const std::vector<StatesOfCase> cases{{"squeal", {}, {history}}, {"squeak", squeak, {history}}};
    const drawing::Scene scene = contact_states(cases, {0.4, 0.5});
    ASSERT_EQ(scene.panels.size(), 2U);
    EXPECT_EQ(drawing::plain_text(scene.panels[0].title), "a) squeal: α = 70°, μd = 0.6, μs = 0.8, F = 20 N");
    EXPECT_EQ(drawing::plain_text(scene.panels[1].title), "b) squeak: α = 70°, μd = 0.6, μs = 0.8, F = 200 N");
    EXPECT_EQ(scene.panels[0].x.text, drawing::AxisText::hidden);
    EXPECT_EQ(scene.panels[1].x.text, drawing::AxisText::shown);
    EXPECT_EQ(scene.panels[1].x.range, (drawing::Extent{0.4, 0.5}));
    EXPECT_EQ(scene.panels[1].x.unit, "s");
}

}  // namespace
}  // namespace stridor::pictures
