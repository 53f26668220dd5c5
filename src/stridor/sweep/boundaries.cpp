#include "stridor/sweep/boundaries.hpp"

#include "stridor/base/check.hpp"
#include "stridor/sweep/starts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace stridor::sweep {

namespace {

// where a line may pass: between a cell and the next one, or amid four of which it is the first
struct Node {
    int iy;
    int ix;
    Crossing crossing;
    bool operator==(const Node&) const = default;
    bool operator<(const Node& other) const {
        return std::tie(iy, ix, crossing) < std::tie(other.iy, other.ix, other.crossing);
    }
};

using Pair = std::pair<std::size_t, std::size_t>;  // numbers of verdicts, rising
using Links = std::map<Node, std::vector<Node>>;   // at most two for each node
using LinksOfPairs = std::map<Pair, Links>;

// the numbers of one direction's verdicts
class Verdicts {
public:
    Verdicts(const SweepResult& result, std::size_t direction) : result_(result), direction_(direction) {}

    std::size_t at(int iy, int ix) const {
        const CellVerdict& cell = result_.cells[index_of(result_.study, {direction_, iy, ix})];
        return number_of({cell.status, cell.category, cell.quiet});
    }

private:
    const SweepResult& result_;
    std::size_t direction_;
};

void link(Links& links, const Node& a, const Node& b) {
    links[a].push_back(b);
    links[b].push_back(a);
}

// a side of a square of cells that a line crosses
struct Side {
    Pair pair;
    Node node;
};

// joins the crossings of one pair in the square above and right of a cell; they come in the order
// lower, right, upper, left
void join(Links& links, const std::vector<Node>& crossings, const Node& middle, bool lower_left_holds_together) {
    STRIDOR_EXPECT(crossings.size() == 1 || crossings.size() == 2 || crossings.size() == 4);
    if (crossings.size() == 1) return link(links, crossings[0], middle);
    if (crossings.size() == 2) return link(links, crossings[0], crossings[1]);
    // the lines cut off the two corners that do not hold together
    const std::size_t partner = lower_left_holds_together ? 1 : 3;
    link(links, crossings[0], crossings[partner]);
    link(links, crossings[2], crossings[4 - partner]);
}

void add_square(LinksOfPairs& links, const Verdicts& verdicts, int iy, int ix) {
    const std::size_t lower_left = verdicts.at(iy, ix);
    const std::size_t lower_right = verdicts.at(iy, ix + 1);
    const std::size_t upper_left = verdicts.at(iy + 1, ix);
    const std::size_t upper_right = verdicts.at(iy + 1, ix + 1);
    const std::array<Side, 4> sides{{{std::minmax({lower_left, lower_right}), {iy, ix, Crossing::along_x}},
                                     {std::minmax({lower_right, upper_right}), {iy, ix + 1, Crossing::along_y}},
                                     {std::minmax({upper_left, upper_right}), {iy + 1, ix, Crossing::along_x}},
                                     {std::minmax({lower_left, upper_left}), {iy, ix, Crossing::along_y}}}};
    std::map<Pair, std::vector<Node>> crossings;
    for (const Side& side : sides)
        if (side.pair.first != side.pair.second) crossings[side.pair].push_back(side.node);
    for (const auto& [pair, nodes] : crossings)
        join(links[pair], nodes, {iy, ix, Crossing::amid}, lower_left == pair.second);
}

double middle(const Axis& axis, int index) {
    const double a = value_at(axis, index);
    const double b = value_at(axis, index + 1);
    return axis.scale == Scale::logarithmic ? std::sqrt(a) * std::sqrt(b) : a + 0.5 * (b - a);
}

// on a value of the axis: there, and how far it is to the farther of the middles beside it
std::pair<double, double> on_value(const Axis& axis, int index) {
    const double value = value_at(axis, index);
    const double before = index > 0 ? value - middle(axis, index - 1) : 0.0;
    const double after = index + 1 < axis.points ? middle(axis, index) - value : 0.0;
    return {value, std::max(before, after)};
}

// between two values: their middle, and how far it is to the farther one
std::pair<double, double> between_values(const Axis& axis, int index) {
    const double between = middle(axis, index);
    return {between, std::max(between - value_at(axis, index), value_at(axis, index + 1) - between)};
}

BoundaryVertex vertex(const Study& study, const Node& node) {
    const auto [x, x_resolution] =
        node.crossing == Crossing::along_y ? on_value(study.x, node.ix) : between_values(study.x, node.ix);
    const auto [y, y_resolution] =
        node.crossing == Crossing::along_x ? on_value(study.y, node.iy) : between_values(study.y, node.iy);
    return {x, y, x_resolution, y_resolution, node.crossing};
}

// takes the line that begins at a node out of the links
std::vector<Node> taken_line(Links& links, Node here) {
    std::vector<Node> line{here};
    while (!links[here].empty()) {
        const Node next = links[here].front();
        links[here].erase(links[here].begin());
        std::vector<Node>& back = links[next];
        back.erase(std::find(back.begin(), back.end(), here));
        line.push_back(next);
        here = next;
    }
    return line;
}

void add_lines(std::vector<Boundary>& lines, const Study& study, const Boundary& without_vertices, Links links) {
    const auto take = [&](LineForm form, const Node& start) {
        Boundary& boundary = lines.emplace_back(without_vertices);
        boundary.form = form;
        std::vector<Node> nodes = taken_line(links, start);
        if (form == LineForm::closed) nodes.pop_back();
        for (const Node& node : nodes)
            boundary.vertices.push_back(vertex(study, node));
    };
    for (const auto& [node, others] : links)
        if (others.size() == 1) take(LineForm::open, node);
    // what is left has two links everywhere
    for (const auto& [node, others] : links)
        if (!others.empty()) take(LineForm::closed, node);
}

// a diagram over x alone has no squares: each change along x is a boundary of one vertex
void add_changes(std::vector<Boundary>& lines, const Study& study, const Verdicts& verdicts, std::size_t direction) {
    for (int ix = 0; ix + 1 < study.x.points; ++ix) {
        const auto [first, second] = std::minmax({verdicts.at(0, ix), verdicts.at(0, ix + 1)});
        if (first == second) continue;
        lines.push_back({direction,
                         verdict_words[first],
                         verdict_words[second],
                         LineForm::open,
                         {vertex(study, {0, ix, Crossing::along_x})}});
    }
}

}  // namespace

std::vector<Boundary> boundaries(const SweepResult& result) {
    const Study& study = result.study;
    STRIDOR_EXPECT(result.cells.size() == cell_count(study));
    std::vector<Boundary> lines;
    for (std::size_t direction = 0; direction < study.directions.size(); ++direction) {
        const Verdicts verdicts(result, direction);
        if (has_one_axis(study)) add_changes(lines, study, verdicts, direction);
        LinksOfPairs links;
        for (int iy = 0; iy + 1 < study.y.points; ++iy)
            for (int ix = 0; ix + 1 < study.x.points; ++ix)
                add_square(links, verdicts, iy, ix);
        for (auto& [pair, links_of_pair] : links)
            add_lines(lines, study,
                      {direction, verdict_words[pair.first], verdict_words[pair.second], LineForm::open, {}},
                      std::move(links_of_pair));
    }
    return lines;
}

}  // namespace stridor::sweep
