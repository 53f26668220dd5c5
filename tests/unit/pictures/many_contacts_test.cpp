#include "stridor/pictures/many_contacts.hpp"

#include "pictures_support.hpp"
#include "stridor/drawing/layout.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/pictures/parts/category_colours.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace stridor::pictures {
namespace {

using model::ContactState;

// some contacts of an own structure over one second, pressed by equal shares of 6 N
parameters::Case line_of(std::size_t contacts) {
    parameters::Case c;
    c.drive.kind = parameters::DriveKind::constant;
    c.contact().preload = 6.0;
    c.run.duration = 1.0;
    parameters::OwnStructure structure;
    for (std::size_t k = 0; k < contacts; ++k) {
        parameters::OwnContact contact;
        contact.name = "n" + std::to_string(k + 1);
        contact.preload_share = 1.0;
        structure.contacts.push_back(contact);
    }
    c.own_structure = std::make_shared<const parameters::OwnStructure>(std::move(structure));
    return c;
}

const record::ContactHistory once{{ContactState::slip, 0.0, 0.2, 0.0, 0.0},
                                  {ContactState::separation, 0.2, 0.3, 0.0, 0.0},
                                  {ContactState::stick, 0.3, 1.0, 0.0, 0.0}};

// sticks for a quarter of each period
record::ContactHistory often(int periods) {
    record::ContactHistory history;
    const double period = 1.0 / periods;
    for (int k = 0; k < periods; ++k) {
        history.push_back({ContactState::stick, k * period, (k + 0.25) * period, 0.0, 0.0});
        history.push_back({ContactState::slip, (k + 0.25) * period, (k + 1) * period, 0.0, 0.0});
    }
    return history;
}

// its last 0.5 s are judged: 0.1 s slip, 0.4 s stick, with a mean of 3 N
record::Record record_of(std::vector<record::ContactHistory> histories) {
    record::Record record;
    record::Tally tally;
    tally.contacts.assign(histories.size(), {});
    for (record::ContactTally& contact : tally.contacts) {
        contact.judged_time = {0.1, 0.4, 0.0};
        contact.load.normal_impulse = 1.5;
    }
    record.phases = {tally};
    record.histories = std::move(histories);
    return record;
}

const drawing::Boxes& boxes_of(const drawing::Panel& panel, ContactState state) {
    for (const drawing::Layer& layer : panel.layers)
        if (const auto* boxes = std::get_if<drawing::Boxes>(&layer); boxes && boxes->fill.colour == state_colour(state))
            return *boxes;
    throw std::logic_error("no boxes of this state");
}

TEST(ManyContacts, AreShownOfOwnStructuresWithSeveral) {
    EXPECT_TRUE(shows_many_contacts(line_of(2)));
    EXPECT_FALSE(shows_many_contacts(line_of(1)));
    EXPECT_FALSE(shows_many_contacts({}));
}

TEST(ManyContacts, HaveTheirSharesAndForcesAlongTheLine) {
    const drawing::Scene scene = many_contacts(line_of(3), record_of({once, once, once}), {});
    ASSERT_EQ(scene.panels.size(), 3U);
    const drawing::Panel& shares = scene.panels[0];
    ASSERT_EQ(shares.x.ticks.size(), 3U);
    EXPECT_EQ(drawing::plain_text(shares.x.ticks[1].label), "n2");
    const drawing::Box stick = boxes_of(shares, ContactState::stick).boxes.at(1);
    const drawing::Box slip = boxes_of(shares, ContactState::slip).boxes.at(1);
    EXPECT_EQ(stick.x, (drawing::Extent{1.6, 2.4}));
    EXPECT_EQ(stick.y, (drawing::Extent{0.0, 0.8}));
    EXPECT_EQ(slip.y, (drawing::Extent{0.8, 1.0}));
    EXPECT_TRUE(boxes_of(shares, ContactState::separation).boxes.empty());
    const drawing::Panel& forces = scene.panels[1];
    EXPECT_EQ(layers_of<drawing::Boxes>(forces).at(0).boxes.at(2).y, (drawing::Extent{0.0, 3.0}));
    EXPECT_EQ(layers_of<drawing::Points>(forces).at(0).y, (std::vector{2.0, 2.0, 2.0})) << "6 N among three";
}

// as line_of, with each contact at its place
parameters::Case line_at(const std::vector<double>& places) {
    parameters::Case c = line_of(places.size());
    parameters::OwnStructure structure = *c.own_structure;
    for (std::size_t k = 0; k < places.size(); ++k)
        structure.contacts[k].position = {0.0, places[k], 1.0};
    c.own_structure = std::make_shared<const parameters::OwnStructure>(std::move(structure));
    return c;
}

TEST(ManyContacts, StandAtTheirPlacesWhereTheseAreKnown) {
    const parameters::Case c = line_at({0.5, 0.0, 0.25});
    const record::Record record = record_of({once, {{ContactState::slip, 0.0, 1.0, 0.0, 0.0}}, once});
    const drawing::Scene scene = many_contacts(c, record, {});
    const drawing::Panel& shares = scene.panels[0];
    EXPECT_EQ(shares.x.unit, "m");
    EXPECT_EQ(shares.x.range, (drawing::Extent{-0.125, 0.625}));
    const drawing::Boxes stick = boxes_of(shares, ContactState::stick);
    EXPECT_EQ(stick.boxes.at(1).x, (drawing::Extent{-0.1, 0.1})) << "four fifths of 0.25 m to its neighbour";
    EXPECT_EQ(stick.boxes.at(0).x, (drawing::Extent{0.4, 0.6}));
    EXPECT_EQ(layers_of<drawing::Points>(scene.panels[1]).at(0).x, (std::vector{0.5, 0.0, 0.25}));
    // the rows follow the line: n2 is at its first end, and slips for ever
    const drawing::Panel& rows = scene.panels[2];
    EXPECT_EQ(drawing::plain_text(rows.y.ticks.back().label), "n2");
    EXPECT_EQ(boxes_of(rows, ContactState::slip).boxes.at(0).y, (drawing::Extent{2.6, 3.4}));
}

TEST(ManyContacts, KeepTheirOrderWhereTwoAreAtOnePlace) {
    const drawing::Scene scene = many_contacts(line_at({0.5, 0.0, 0.5}), record_of({once, once, once}), {});
    EXPECT_EQ(drawing::plain_text(scene.panels[0].x.ticks.at(0).label), "n1");
    EXPECT_EQ(scene.panels[0].x.range, (drawing::Extent{0.5, 3.5}));
}

TEST(ManyContacts, HaveARowEachTheFirstOnTop) {
    const drawing::Scene scene =
        many_contacts(line_of(2), record_of({once, {{ContactState::slip, 0.0, 1.0, 0.0, 0.0}}}), {{0.1, 0.25}});
    ASSERT_EQ(scene.panels.size(), 4U);
    const drawing::Panel& whole = scene.panels[2];
    EXPECT_EQ(drawing::plain_text(whole.y.ticks.back().label), "n1");
    EXPECT_EQ(whole.y.ticks.back().value, 2.0);
    const drawing::Boxes open = boxes_of(whole, ContactState::separation);
    ASSERT_EQ(open.boxes.size(), 1U);
    EXPECT_EQ(open.boxes[0].x, (drawing::Extent{0.2, 0.3}));
    EXPECT_EQ(open.boxes[0].y, (drawing::Extent{1.6, 2.4}));
    const drawing::Panel& part = scene.panels[3];
    EXPECT_EQ(part.x.range, (drawing::Extent{0.1, 0.25}));
    EXPECT_EQ(boxes_of(part, ContactState::separation).boxes.at(0).x, (drawing::Extent{0.2, 0.25}));
    EXPECT_EQ(boxes_of(part, ContactState::slip).boxes.at(1).y, (drawing::Extent{0.6, 1.4}));
}

TEST(ManyContacts, SplitTheRowOfOneThatChangesTooOften) {
    // 62 parts of 16.1 periods each: the share misses by a stick's quarter period at either end at most
    const drawing::Scene scene = many_contacts(line_of(2), record_of({once, often(1000)}), {{0.1, 0.11}});
    const drawing::Boxes stick = boxes_of(scene.panels[2], ContactState::stick);
    EXPECT_EQ(stick.boxes.at(0).x, (drawing::Extent{0.3, 1.0})) << "the first contact is drawn stay by stay";
    ASSERT_GT(stick.boxes.size(), 2U);
    for (std::size_t k = 1; k < stick.boxes.size(); ++k) {
        EXPECT_EQ(stick.boxes[k].y.from, 0.6);
        EXPECT_NEAR(stick.boxes[k].y.to, 0.6 + 0.25 * 0.8, 0.8 * 0.25 / 8.0);
    }
    EXPECT_NE(drawing::plain_text(scene.caption.back()).find("split"), std::string::npos);
    // the stretch holds ten periods, which are drawn
    EXPECT_EQ(boxes_of(scene.panels[3], ContactState::stick).boxes.size(), 10U);
}

TEST(ManyContacts, FillEachInstantOfASplitRow) {
    const drawing::Scene scene = many_contacts(line_of(2), record_of({often(400), often(3000)}), {});
    double area = 0.0;
    for (const ContactState state : {ContactState::slip, ContactState::stick, ContactState::separation})
        for (const drawing::Box& box : boxes_of(scene.panels[2], state).boxes)
            area += (box.x.to - box.x.from) * (box.y.to - box.y.from);
    EXPECT_NEAR(area, 2.0 * 0.8, 1e-9);  // sums of some thousand rounded lengths
}

TEST(ManyContacts, NameNoMoreThanFindRoom) {
    const std::vector<record::ContactHistory> histories(120, once);
    const drawing::Scene scene = many_contacts(line_of(120), record_of(histories), {});
    const drawing::Layout layout = drawing::arrange(scene);
    const auto names = std::count_if(layout.texts.begin(), layout.texts.end(), [](const drawing::PlacedText& text) {
        return drawing::plain_text(text.text).starts_with("n") && text.align != drawing::Align::left;
    });
    EXPECT_GT(names, 20);
    EXPECT_LT(names, 20 + 20 + 40) << "of 360: below shares and forces, and beside the states";
    EXPECT_LT(layout.height, 220.0) << "a page";
}

TEST(ManyContacts, HavePanelsForEachPhase) {
    record::Record record = record_of({once, once});
    record.phases = {record.phases[0], record.phases[0]};
    record.phases[0].phase = record::Phase::going;
    record.phases[1].phase = record::Phase::coming;
    const drawing::Scene scene = many_contacts(line_of(2), record, {});
    ASSERT_EQ(scene.panels.size(), 5U);
    EXPECT_EQ(drawing::plain_text(scene.panels[2].title), "c) states of the judged time, coming");
}

TEST(TellingLength, ShowsAboutTwentyStaysInARoundNumber) {
    record::Record record = record_of({once, once});
    EXPECT_EQ(telling_length(line_of(2), record), 0.1) << "none changes";
    record.phases[0].contacts[1].changes[0].count = 1000;  // stays of 0.5 ms
    EXPECT_NEAR(telling_length(line_of(2), record), 10e-3, 1e-12);
    record.phases[0].contacts[0].changes[0].count = 2000;
    EXPECT_NEAR(telling_length(line_of(2), record), 5e-3, 1e-12);
    record.phases[0].contacts[0].changes[0].count = record.phases[0].contacts[1].changes[0].count = 2;
    EXPECT_EQ(telling_length(line_of(2), record), 1.0) << "the whole run";
}

}  // namespace
}  // namespace stridor::pictures
