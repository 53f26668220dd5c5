#include "stridor/reduction/contact_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace stridor::reduction {

namespace {

constexpr double within = 2.5;  // [1] of the nearest neighbour's distance: others are no neighbours in a mesh
// [1] cosine from which a neighbour lies ahead: a hollow of up to 30 degrees from node to node is a surface all the
// same
constexpr double ahead = 0.5;
constexpr std::array<std::string_view, 3> axis_names{"x", "y", "z"};

/// Does the part go on from a node, forwards and backwards along each axis?
struct Surroundings {
    std::array<bool, 3> forwards{};
    std::array<bool, 3> backwards{};

    bool is_inside() const {
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (!forwards[axis] || !backwards[axis]) return false;
        return true;
    }
};

// unit vectors to the nearest nodes that the stiffness couples with this one
std::vector<Eigen::Vector3d> ways_to_neighbours(const ElasticPart& part, const std::string& node,
                                                const std::vector<Eigen::Index>& its_rows) {
    const auto here = part.positions.find(node);
    if (here == part.positions.end()) return {};
    std::set<std::string_view> names;
    for (const Eigen::Index row : its_rows)
        for (SparseMatrix::InnerIterator entry(part.stiffness, row); entry; ++entry)
            if (entry.value() != 0.0) names.insert(part.labels[static_cast<std::size_t>(entry.row())].node);
    std::vector<Eigen::Vector3d> ways;
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::string_view name : names) {
        const auto there = part.positions.find(std::string(name));
        if (name == node || there == part.positions.end()) continue;
        const Eigen::Vector3d way = there->second - here->second;
        if (!(way.norm() > 0.0)) continue;
        nearest = std::min(nearest, way.norm());
        ways.push_back(way);
    }
    std::erase_if(ways, [&](const Eigen::Vector3d& way) { return way.norm() > within * nearest; });
    for (Eigen::Vector3d& way : ways)
        way.normalize();
    return ways;
}

Surroundings surroundings_of(const ElasticPart& part, const std::string& node,
                             const std::vector<Eigen::Index>& its_rows) {
    Surroundings found;
    for (const Eigen::Vector3d& way : ways_to_neighbours(part, node, its_rows))
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double cosine = way[static_cast<Eigen::Index>(axis)];
            found.forwards[axis] = found.forwards[axis] || cosine > ahead;
            found.backwards[axis] = found.backwards[axis] || cosine < -ahead;
        }
    return found;
}

using AllSurroundings = std::vector<std::pair<std::string, Surroundings>>;

AllSurroundings surroundings_at(const ElasticPart& part, const std::vector<Eigen::Index>& rows) {
    std::map<std::string, std::vector<Eigen::Index>> rows_of_node;
    for (const Eigen::Index row : rows)
        rows_of_node[part.labels[static_cast<std::size_t>(row)].node];
    for (Eigen::Index row = 0; row < rows_of(part); ++row) {
        const auto found = rows_of_node.find(part.labels[static_cast<std::size_t>(row)].node);
        if (found != rows_of_node.end()) found->second.push_back(row);
    }
    AllSurroundings all;
    for (const auto& [node, its_rows] : rows_of_node)
        all.emplace_back(node, surroundings_of(part, node, its_rows));
    return all;
}

struct Sides {
    std::size_t into = 0;      // nodes from which the part goes on along the normal alone
    std::size_t outwards = 0;  // against it alone
    std::size_t both = 0;
};

Sides sides_along(const AllSurroundings& all, int normal) {
    Sides sides;
    const auto axis = static_cast<std::size_t>(std::abs(normal) - 1);
    for (const auto& [node, around] : all) {
        const bool into = normal > 0 ? around.forwards[axis] : around.backwards[axis];
        const bool outwards = normal > 0 ? around.backwards[axis] : around.forwards[axis];
        sides.both += into && outwards ? 1 : 0;
        sides.into += into && !outwards ? 1 : 0;
        sides.outwards += !into && outwards ? 1 : 0;
    }
    return sides;
}

std::string told(int normal) {
    return (normal < 0 ? "-" : "") + std::string(axis_names.at(static_cast<std::size_t>(std::abs(normal) - 1)));
}

// the one along which the part goes on from all nodes, and from none against it; 0: there is none
int better_normal(const AllSurroundings& all) {
    for (const int normal : {3, 2, 1, -3, -2, -1})
        if (sides_along(all, normal).into == all.size()) return normal;
    return 0;
}

}  // namespace

std::vector<base::Problem> surface_doubts(const ElasticPart& part, const std::vector<Eigen::Index>& rows, int normal) {
    AllSurroundings all = surroundings_at(part, rows);
    std::vector<base::Problem> found;
    const std::size_t nodes = all.size();
    const auto inside = std::find_if(all.begin(), all.end(), [](const auto& each) { return each.second.is_inside(); });
    if (inside != all.end()) {
        const std::string first = inside->first;
        const std::size_t before = all.size();
        std::erase_if(all, [](const auto& each) { return each.second.is_inside(); });
        found.push_back({fmt::format("node {}{} inside the part", first,
                                     before - all.size() > 1 ? fmt::format(" and {} more lie", before - all.size() - 1)
                                                             : std::string(" lies")),
                         "the part goes on from it along x, y and z, both ways", "Name nodes of the surface."});
    }
    if (normal == 0 || all.empty()) return found;
    const Sides sides = sides_along(all, normal);
    const int better = better_normal(all);
    const std::string advice = better == 0 ? std::string() : fmt::format("Say --normal {}?", better);
    if (sides.both > 0)
        found.push_back(
            {fmt::format("the normal {} lies in the surface at {} of {} nodes", told(normal), sides.both, nodes),
             "the part goes on from them both ways: are normal and tangent swapped?", advice});
    else if (sides.outwards > sides.into)
        found.push_back(
            {fmt::format("the normal {} points out of the part at {} of {} nodes", told(normal), sides.outwards, nodes),
             "a gap opens along it, so that the part would lie within the surface it rubs on", advice});
    return found;
}

}  // namespace stridor::reduction
