#include "stridor/pictures/many_contacts.hpp"

#include "stridor/analysis/rates.hpp"
#include "stridor/base/check.hpp"
#include "stridor/drawing/palette.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/pictures/parts/category_colours.hpp"
#include "stridor/pictures/parts/field_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

namespace stridor::pictures {

namespace {

constexpr double half_width = 0.4;  // [1] of a bar, of the way to the nearest neighbour

// Way from each place to the nearest other one; zero where two contacts are at one place. Shape [contact].
std::vector<double> ways_to_neighbours(const ContactLine& line) {
    std::vector<double> ways(line.places.size(), std::numeric_limits<double>::infinity());
    for (std::size_t k = 1; k < line.order.size(); ++k) {
        const std::size_t left = line.order[k - 1], right = line.order[k];
        const double way = line.places[right] - line.places[left];
        ways[left] = std::min(ways[left], way);
        ways[right] = std::min(ways[right], way);
    }
    return ways;
}

void number_contacts(ContactLine& line) {
    std::iota(line.order.begin(), line.order.end(), std::size_t{0});
    std::iota(line.places.begin(), line.places.end(), 1.0);
}

// takes the places that the case knows; false where it does not know them, or two are one
bool place_contacts(ContactLine& line, const parameters::Case& c) {
    std::vector<double> places = parameters::contact_places(c);
    if (places.empty()) return false;
    line.places = std::move(places);
    std::sort(line.order.begin(), line.order.end(),
              [&](std::size_t a, std::size_t b) { return line.places[a] < line.places[b]; });
    const std::vector<double> ways = ways_to_neighbours(line);
    return *std::min_element(ways.begin(), ways.end()) > 0.0;
}

using drawing::Box;
using drawing::Extent;
using model::ContactState;

// from below to above, in shares and in rows that are split: what moves least lies at the bottom
constexpr std::array<ContactState, model::contact_states> stacked{ContactState::stick, ContactState::slip,
                                                                  ContactState::separation};

constexpr double share_height = 26.0;       // [mm] of a row of panels of shares and forces
constexpr double row_height = 5.0;          // [mm] of a contact's states, while that is no more than
constexpr double most_states_height = 110;  // [mm] of all of them
constexpr double half_height = 0.4;         // [1] of a bar, of its row
constexpr std::size_t most_changes = 200;   // of a contact that is drawn stay by stay
constexpr std::size_t changes_a_part = 16;  // of one that is split, at least: one more or less is hardly seen

// boxes of each state, in the order of their numbers
using StateBoxes = std::array<std::vector<Box>, model::contact_states>;

void add_layers(drawing::Panel& panel, StateBoxes boxes) {
    for (const ContactState state : stacked)
        panel.layers.emplace_back(drawing::Boxes{std::move(boxes[model::index_of(state)]),
                                                 {state_colour(state), drawing::Texture::none, drawing::ink}});
}

// a neighbour that reaches as high is the same box
void add_box(std::vector<Box>& boxes, const Box& box) {
    const bool goes_on = !boxes.empty() && boxes.back().x.to == box.x.from && boxes.back().y == box.y;
    if (goes_on)
        boxes.back().x.to = box.x.to;
    else
        boxes.push_back(box);
}

// --- along the line

double share_of(const analysis::Rates& rates, ContactState state) {
    return state == ContactState::slip ? rates.slip : state == ContactState::stick ? rates.stick : rates.separation;
}

drawing::Panel share_panel(const ContactLine& line, const record::Tally& tally) {
    drawing::Panel panel;
    panel.x = line.axis;
    panel.y.label = "share of time";
    panel.y.unit = "1";
    panel.y.range = {0.0, 1.0};
    StateBoxes boxes;
    for (std::size_t k = 0; k < tally.contacts.size(); ++k) {
        const analysis::Rates rates = analysis::rates(tally.contacts[k].judged_time);
        double below = 0.0;
        for (const ContactState state : stacked) {
            const double share = share_of(rates, state);
            // nothing where nothing was judged
            if (share > 0.0) boxes[model::index_of(state)].push_back({line.bars[k], {below, below + share}});
            below += share;
        }
    }
    add_layers(panel, std::move(boxes));
    return panel;
}

// small enough to stand beside its neighbours
drawing::Points preload_mark(std::size_t contacts) {
    const double diameter = std::min(3.0, 100.0 / static_cast<double>(contacts));  // [pt]
    return {{}, {}, drawing::white, diameter, {}, drawing::Mark::diamond, drawing::ink};
}

drawing::Panel force_panel(const parameters::Case& c, const ContactLine& line, const record::Tally& tally) {
    drawing::Panel panel;
    panel.x = line.axis;
    panel.grid = drawing::Grid::none;
    panel.y.label = drawing::StyledText("mean ") + drawing::symbol("N");
    panel.y.unit = "N";
    drawing::Boxes forces{{}, {drawing::accent, drawing::Texture::none, drawing::ink}};
    drawing::Points preloads = preload_mark(tally.contacts.size());
    double most = 0.0;
    for (std::size_t k = 0; k < tally.contacts.size(); ++k) {
        const record::ContactTally& contact = tally.contacts[k];
        const double judged = std::accumulate(contact.judged_time.begin(), contact.judged_time.end(), 0.0);
        if (judged > 0.0) {
            const double force = contact.load.normal_impulse / judged;
            forces.boxes.push_back({line.bars[k], {0.0, force}});
            most = std::max(most, force);
        }
        if (!parameters::is_preloaded(c)) continue;
        preloads.x.push_back(line.places[k]);
        preloads.y.push_back(parameters::contact_of(c, k).preload);
        most = std::max(most, preloads.y.back());
    }
    panel.y.range = {0.0, most > 0.0 ? 1.1 * most : 1.0};
    panel.layers.emplace_back(std::move(forces));
    panel.layers.emplace_back(std::move(preloads));
    return panel;
}

// --- over time

// the states of one contact as they are
void add_stays(StateBoxes& boxes, const record::ContactHistory& history, const Extent& time, double row) {
    for (const record::ContactInterval& stay : history) {
        const Extent within{std::max(stay.from, time.from), std::min(stay.to, time.to)};
        if (within.from < within.to)
            boxes[model::index_of(stay.state)].push_back({within, {row - half_height, row + half_height}});
    }
}

// its shares in each of `parts` equal parts of the time
void add_shares(StateBoxes& boxes, const record::ContactHistory& history, const Extent& time, double row,
                std::size_t parts) {
    const double length = (time.to - time.from) / static_cast<double>(parts);
    auto stay = history.begin();
    for (std::size_t part = 0; part < parts; ++part) {
        const Extent within{time.from + static_cast<double>(part) * length,
                            time.from + static_cast<double>(part + 1) * length};
        while (stay != history.end() && stay->to <= within.from)
            ++stay;
        std::array<double, model::contact_states> spent{};  // [s]
        for (auto each = stay; each != history.end() && each->from < within.to; ++each)
            spent[model::index_of(each->state)] += std::min(each->to, within.to) - std::max(each->from, within.from);
        double below = row - half_height;
        for (const ContactState state : stacked) {
            const double height = 2.0 * half_height * spent[model::index_of(state)] / length;
            // thinner than rounding is nothing
            if (height > 1e-9) add_box(boxes[model::index_of(state)], {within, {below, below + height}});
            below += height;
        }
    }
}

std::size_t changes_within(const record::ContactHistory& history, const Extent& time) {
    return static_cast<std::size_t>(std::count_if(
        history.begin(), history.end(),
        [&](const record::ContactInterval& stay) { return stay.from > time.from && stay.from < time.to; }));
}

struct States {
    drawing::Panel panel;
    bool is_split = false;  // some row is
};

States state_rows(const parameters::Case& c, const ContactLine& line, const record::Record& record,
                  const Extent& time) {
    const std::size_t contacts = record.histories.size();
    States states;
    drawing::Panel& panel = states.panel;
    panel.x.label = drawing::StyledText("time ") + drawing::symbol("t");
    panel.x.unit = "s";
    panel.x.range = time;
    panel.y.label = "contact";
    panel.y.range = {0.5, static_cast<double>(contacts) + 0.5};
    StateBoxes boxes;
    for (std::size_t place = 0; place < contacts; ++place) {
        const std::size_t k = line.order[place];
        const double row = static_cast<double>(contacts - place);
        panel.y.ticks.push_back({row, parameters::contact_name(c, k), drawing::TickSize::major});
        const std::size_t changes = changes_within(record.histories[k], time);
        const bool is_dense = changes > most_changes;
        if (is_dense)
            add_shares(boxes, record.histories[k], time, row, std::min(most_changes, changes / changes_a_part));
        else
            add_stays(boxes, record.histories[k], time, row);
        states.is_split = states.is_split || is_dense;
    }
    std::reverse(panel.y.ticks.begin(), panel.y.ticks.end());
    add_layers(panel, std::move(boxes));
    return states;
}

// --- the whole picture

class Picture {
public:
    Picture(const parameters::Case& c, const record::Record& record) : c_(c), record_(record), line_(contact_line(c)) {
        scene_.title = c.title.empty() ? drawing::StyledText("Contacts") : drawing::StyledText(c.title);
        scene_.caption = {conditions(c)};
        scene_.column_widths = {1.0, 1.0};
        scene_.row_heights.clear();
        height_ = std::clamp(row_height * static_cast<double>(record.histories.size()), 15.0, most_states_height);
    }

    void add_phase(const record::Tally& tally) {
        const bool is_only = tally.phase == record::Phase::all;
        const std::string phase =
            is_only ? "" : fmt::format(", {}", record::phase_names[static_cast<std::size_t>(tally.phase)]);
        add(share_panel(line_, tally), 0, "states of the judged time" + phase);
        add(force_panel(c_, line_, tally), 1, "mean normal force" + phase);
        scene_.row_heights.push_back(share_height);
    }

    void add_states(const Extent& whole, const std::optional<Extent>& stretch) {
        States run = state_rows(c_, line_, record_, whole);
        bool is_split = run.is_split;
        if (stretch) {
            run.panel.layers.insert(
                run.panel.layers.begin(),
                drawing::Boxes{{{*stretch, run.panel.y.range}}, {drawing::highlight, drawing::Texture::none, {}}});
        }
        add(std::move(run.panel), 0, "whole run");
        if (stretch) {
            States part = state_rows(c_, line_, record_, *stretch);
            is_split = is_split || part.is_split;
            part.panel.y.label = {};
            add(std::move(part.panel), 1, fmt::format("{:g} s to {:g} s", stretch->from, stretch->to));
        }
        if (is_split)
            scene_.caption.emplace_back(
                "Where a contact changes its state too often to be drawn, its row is split by the shares of time.");
        scene_.row_heights.push_back(height_);
    }

    drawing::Scene finish() {
        for (const ContactState state : stacked)
            scene_.legend.push_back({std::string(model::contact_state_names[model::index_of(state)]),
                                     drawing::Fill{state_colour(state), drawing::Texture::none, {}}});
        if (parameters::is_preloaded(c_))
            scene_.legend.push_back(
                {"preload at rest",
                 drawing::Points{{}, {}, drawing::white, 3.0, {}, drawing::Mark::diamond, drawing::ink}});
        // numbers and names of the axes take 14 mm below each row, title, caption and legend the rest
        const double panels = std::accumulate(scene_.row_heights.begin(), scene_.row_heights.end(), 0.0);
        scene_.height = 24.0 + 4.0 * static_cast<double>(scene_.caption.size()) + panels +
                        14.0 * static_cast<double>(scene_.row_heights.size());
        return std::move(scene_);
    }

private:
    void add(drawing::Panel panel, std::size_t column, const std::string& title) {
        panel.row = scene_.row_heights.size();
        panel.column = column;
        panel.title = lettered(scene_.panels.size(), title);
        scene_.panels.push_back(std::move(panel));
    }

    const parameters::Case& c_;
    const record::Record& record_;
    ContactLine line_;
    drawing::Scene scene_;
    double height_ = 0.0;  // [mm] of the rows of states
};

}  // namespace

ContactLine contact_line(const parameters::Case& c) {
    const std::size_t contacts = parameters::contact_count(c);
    ContactLine line;
    line.order.resize(contacts);
    line.places.resize(contacts);
    number_contacts(line);
    if (place_contacts(line, c)) {
        line.axis.label = "place along the line";
        line.axis.unit = "m";
    } else {
        number_contacts(line);
        line.axis.label = "contact";
        for (std::size_t k = 0; k < contacts; ++k)
            line.axis.ticks.push_back({line.places[k], parameters::contact_name(c, k), drawing::TickSize::major});
    }
    std::vector<double> ways = ways_to_neighbours(line);
    for (double& way : ways)
        way = std::isfinite(way) ? way : 1.0;  // of a single contact
    for (std::size_t k = 0; k < contacts; ++k)
        line.bars.push_back({line.places[k] - half_width * ways[k], line.places[k] + half_width * ways[k]});
    const std::size_t first = line.order.front(), last = line.order.back();
    line.axis.range = {line.places[first] - 0.5 * ways[first], line.places[last] + 0.5 * ways[last]};
    return line;
}

bool shows_many_contacts(const parameters::Case& c) {
    return !parameters::has_plate(c) && parameters::contact_count(c) > 1;
}

drawing::Scene many_contacts(const parameters::Case& c, const record::Record& record,
                             const std::optional<drawing::Extent>& stretch) {
    STRIDOR_EXPECT(!parameters::has_plate(c) && record.histories.size() == parameters::contact_count(c));
    Picture picture(c, record);
    for (const record::Tally& tally : record.phases)
        picture.add_phase(tally);
    picture.add_states({0.0, c.run.duration}, stretch);
    return picture.finish();
}

double telling_length(const parameters::Case& c, const record::Record& record) {
    double shortest = 0.0;  // [s] mean stay
    for (const record::Tally& tally : record.phases)
        for (const record::ContactTally& contact : tally.contacts) {
            long changes = 0;
            for (const record::Instants& instants : contact.changes)
                changes += instants.count;
            const double judged = std::accumulate(contact.judged_time.begin(), contact.judged_time.end(), 0.0);
            if (changes == 0 || !(judged > 0.0)) continue;
            const double stay = judged / static_cast<double>(changes);
            shortest = shortest > 0.0 ? std::min(shortest, stay) : stay;
        }
    if (!(shortest > 0.0)) return 0.1 * c.run.duration;
    const double wanted = 20.0 * shortest;
    const double power = std::pow(10.0, std::floor(std::log10(wanted)));
    const double digit = wanted / power < 2.0 ? 1.0 : wanted / power < 5.0 ? 2.0 : 5.0;
    return std::min(digit * power, c.run.duration);
}

}  // namespace stridor::pictures
