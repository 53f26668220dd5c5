#include "stridor/sweep/refinement.hpp"

#include "stridor/base/check.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>

namespace stridor::sweep {

namespace {

// points with corners included; x0 < x1 and y0 < y1
struct Block {
    int x0;
    int x1;
    int y0;
    int y1;
    int level;  // 0 is the coarsest
};

std::size_t point_count(const Study& study) {
    return static_cast<std::size_t>(study.x.points) * static_cast<std::size_t>(study.y.points);
}

// one mark per point for the directions that one run gives; points are alike when they are in each of them
std::vector<int> point_marks(const Study& study, std::span<const int> marks, std::size_t first_direction) {
    const std::size_t points = point_count(study);
    const std::span<const int> first = marks.subspan(first_direction * points, points);
    std::vector<int> joint(first.begin(), first.end());
    constexpr int radix = 1 << 12;  // above any mark of one direction
    for (std::size_t k = 1; k < directions_per_run(study); ++k)
        for (std::size_t point = 0; point < points; ++point) {
            const int mark = marks[(first_direction + k) * points + point];
            const bool is_known = joint[point] != unknown_mark && mark != unknown_mark;
            STRIDOR_EXPECT(mark < radix);
            joint[point] = is_known ? joint[point] * radix + mark : unknown_mark;
        }
    return joint;
}

// every one that is not known: no tree is needed where all cells are computed
std::vector<std::size_t> unknown_runs(const Study& study, std::span<const int> marks) {
    std::vector<std::size_t> runs;
    for (std::size_t index = 0; index < marks.size(); ++index) {
        const std::size_t run = run_of(study, index);
        if (marks[index] == unknown_mark && run == index) runs.push_back(run);
    }
    return runs;
}

// the quadtree as far as the known points tell it
class Tree {
public:
    Tree(const Study& study, std::vector<int> marks)
        : columns_(study.x.points),
          rows_(study.y.points),
          levels_(study.refine),
          marks_(std::move(marks)),
          is_required_(marks_.size(), 0) {
        const int stride = 1 << levels_;
        // a diagram over x alone has one row, and blocks without height
        for (int y = 0; y == 0 || y + 1 < rows_; y += stride)
            for (int x = 0; x + 1 < columns_; x += stride)
                add({x, std::min(x + stride, columns_ - 1), y, std::min(y + stride, rows_ - 1), 0});
        while (grow())
            ;
    }

    std::vector<std::size_t> missing() const {
        std::vector<std::size_t> points;
        for (std::size_t point = 0; point < marks_.size(); ++point)
            if (is_required_[point] != 0 && marks_[point] == unknown_mark) points.push_back(point);
        return points;
    }

    // for each point itself if it is required, else the nearest corner of its block
    std::vector<CellIndex> sources() const {
        // a block is 2^most_refinement wide at most, so that squares fit
        using Square = std::uint16_t;
        static_assert(2 * (1 << most_refinement) * (1 << most_refinement) < std::numeric_limits<Square>::max());
        std::vector<CellIndex> nearest(marks_.size());
        std::vector<Square> distances(marks_.size(), std::numeric_limits<Square>::max());
        for (const Block& block : leaves_)
            for (int y = block.y0; y <= block.y1; ++y)
                for (int x = block.x0; x <= block.x1; ++x)
                    for (const auto& [cx, cy] : corners(block)) {
                        const std::size_t point = at(x, y);
                        const int dx = x - cx;
                        const int dy = y - cy;
                        const std::pair offer{static_cast<Square>(dx * dx + dy * dy),
                                              static_cast<CellIndex>(at(cx, cy))};
                        if (offer >= std::pair{distances[point], nearest[point]}) continue;
                        std::tie(distances[point], nearest[point]) = offer;
                    }
        for (std::size_t point = 0; point < marks_.size(); ++point)
            if (is_required_[point] != 0) nearest[point] = static_cast<CellIndex>(point);
        return nearest;
    }

private:
    int columns_;
    int rows_;
    int levels_;
    std::vector<int> marks_;  // shape [point]
    std::vector<char> is_required_;
    std::vector<Block> leaves_;

    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
    }

    static std::array<std::pair<int, int>, 4> corners(const Block& block) {
        return {{{block.x0, block.y0}, {block.x1, block.y0}, {block.x0, block.y1}, {block.x1, block.y1}}};
    }

    void add(const Block& block) {
        for (const auto& [x, y] : corners(block))
            is_required_[at(x, y)] = 1;
        leaves_.push_back(block);
    }

    static bool is_smallest(const Block& block) { return block.x1 - block.x0 < 2 && block.y1 - block.y0 < 2; }

    // true if the block got a probe that it had not
    bool probe(const Block& block) {
        if (is_smallest(block)) return false;
        const int mark = marks_[at(block.x0, block.y0)];
        for (const auto& [x, y] : corners(block))
            if (marks_[at(x, y)] != mark || mark == unknown_mark) return false;
        return std::exchange(is_required_[at((block.x0 + block.x1) / 2, (block.y0 + block.y1) / 2)], 1) == 0;
    }

    bool holds_a_difference(const Block& block) const {
        int first = unknown_mark;
        for (int y = block.y0; y <= block.y1; ++y)
            for (int x = block.x0; x <= block.x1; ++x) {
                const int mark = is_required_[at(x, y)] != 0 ? marks_[at(x, y)] : unknown_mark;
                if (first == unknown_mark) first = mark;
                if (mark != first && mark != unknown_mark) return true;
            }
        return false;
    }

    void split(const Block& block) {
        const int half = 1 << (levels_ - block.level - 1);
        // a block at the far end may be too narrow to be cut
        const auto parts = [half](int from, int to) {
            std::vector<std::pair<int, int>> cut{{from, to}};
            if (from + half < to) cut = {{from, from + half}, {from + half, to}};
            return cut;
        };
        for (const auto& [y0, y1] : parts(block.y0, block.y1))
            for (const auto& [x0, x1] : parts(block.x0, block.x1))
                add({x0, x1, y0, y1, block.level + 1});
    }

    // probes and splits what is there now; false if nothing changed
    bool grow() {
        bool has_changed = false;
        for (const Block& block : std::exchange(leaves_, {})) {
            has_changed = probe(block) || has_changed;
            if (is_smallest(block) || !holds_a_difference(block)) {
                leaves_.push_back(block);
                continue;
            }
            has_changed = true;
            split(block);
        }
        return has_changed;
    }
};

}  // namespace

int sound_refinement(const Study& study, int asked) {
    constexpr int fewest_blocks = 7;
    if (asked < 0 || asked > most_refinement) return asked;  // refused with the rest
    const int intervals = std::min(study.x.points, study.y.points) - 1;
    int refinement = 0;
    while (refinement < asked && intervals >> (refinement + 1) >= fewest_blocks)
        ++refinement;
    return refinement;
}

int mark_of(const Study& study, const Cell& cell) {
    if (study.refine == 0) return 0;
    using classification::category_names;
    constexpr int statuses = status_names.size();
    constexpr int agreements = agreement_names.size();
    constexpr int stabilities = 3;  // of steady sliding: stable, divergence, flutter
    int shown = static_cast<int>(cell.status);
    int stability = 0;
    if (cell.status == Status::done) {
        if (figure_of(cell, "growth_rate") > 0.0) stability = figure_of(cell, "mode_frequency") > 0.0 ? 2 : 1;
        shown = statuses + static_cast<int>(cell.category);
        if (cell.quiet == classification::Quiet::sticks) shown = statuses + static_cast<int>(category_names.size());
        if (cell.quiet == classification::Quiet::locks) shown = statuses + static_cast<int>(category_names.size()) + 1;
    }
    return (shown * agreements + static_cast<int>(cell.agreement)) * stabilities + stability;
}

Refinement refine(const Study& study, std::span<const int> marks) {
    STRIDOR_EXPECT(marks.size() == cell_count(study));
    if (study.refine == 0) return {unknown_runs(study, marks), {}};
    const std::size_t points = point_count(study);
    Refinement result;
    for (std::size_t first = 0; first < study.directions.size(); first += directions_per_run(study)) {
        const Tree tree(study, point_marks(study, marks, first));
        for (const std::size_t point : tree.missing())
            result.missing.push_back(first * points + point);
        if (!result.missing.empty()) continue;
        const std::vector<CellIndex> sources = tree.sources();
        result.sources.reserve(marks.size());
        for (std::size_t k = 0; k < directions_per_run(study); ++k)
            for (const CellIndex source : sources)
                result.sources.push_back(static_cast<CellIndex>((first + k) * points + source));
    }
    return result;
}

std::vector<CellVerdict> inferred(std::vector<CellVerdict> cells, std::span<const CellIndex> sources) {
    if (sources.empty()) return cells;
    STRIDOR_EXPECT(cells.size() == sources.size());
    for (std::size_t index = 0; index < cells.size(); ++index)
        cells[index] = cells[sources[index]];
    return cells;
}

}  // namespace stridor::sweep
