#include "stridor/drawing/reduce.hpp"

#include "stridor/base/check.hpp"
#include "stridor/drawing/ticks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stridor::drawing {

namespace {

constexpr double shade_steps = 8.0;  // usual 8: finer steps are not told apart, and join less

// the column a value lies in; -1 and `columns` stand for everything left and right of the axis
long column_of(const PanelAxis& axis, double value, std::size_t columns) {
    const double place = position(axis, value) * static_cast<double>(columns);
    return static_cast<long>(std::floor(std::clamp(place, -1.0, static_cast<double>(columns))));
}

bool is_missing(const Line& line, std::size_t i, const PanelAxis& x) {
    return std::isnan(line.y[i]) || std::isnan(position(x, line.x[i]));
}

// the points of one stay in a column, [first, last], that must be drawn
std::vector<std::size_t> corners(const Line& line, std::size_t first, std::size_t last) {
    std::size_t lowest = first;
    std::size_t highest = first;
    for (std::size_t i = first; i <= last; ++i) {
        if (line.y[i] < line.y[lowest]) lowest = i;
        if (line.y[i] > line.y[highest]) highest = i;
    }
    std::vector<std::size_t> kept{first, std::min(lowest, highest), std::max(lowest, highest), last};
    kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
    return kept;
}

void add_interval(std::vector<double>& covered, const Extent& place) {
    const auto columns = static_cast<double>(covered.size());
    const auto first = static_cast<std::size_t>(std::min(place.from, columns - 1.0));
    for (std::size_t c = first; c < covered.size() && static_cast<double>(c) <= place.to; ++c) {
        const auto left = static_cast<double>(c);
        const double share = std::min(place.to, left + 1.0) - std::max(place.from, left);
        // an interval too short to measure is there all the same
        if (share > 0.0 || place.from == place.to) covered[c] += std::max(share, std::numeric_limits<double>::min());
    }
}

double shade_of(double covered) {
    return std::clamp(std::ceil(covered * shade_steps - 1e-6), 1.0, shade_steps) / shade_steps;
}

}  // namespace

Line reduced(const Line& line, const PanelAxis& x, std::size_t columns) {
    STRIDOR_EXPECT(line.x.size() == line.y.size() && columns > 0);
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    Line kept;
    kept.stroke = line.stroke;
    for (std::size_t i = 0; i < line.x.size();) {
        if (is_missing(line, i, x)) {
            if (!kept.y.empty() && !std::isnan(kept.y.back())) {
                kept.x.push_back(line.x[i]);
                kept.y.push_back(nothing);
            }
            ++i;
            continue;
        }
        const long column = column_of(x, line.x[i], columns);
        std::size_t end = i + 1;
        while (end < line.x.size() && !is_missing(line, end, x) && column_of(x, line.x[end], columns) == column)
            ++end;
        for (const std::size_t k : corners(line, i, end - 1)) {
            kept.x.push_back(line.x[k]);
            kept.y.push_back(line.y[k]);
        }
        i = end;
    }
    return kept;
}

std::vector<Shade> shades(const Strip& strip, const Extent& x, std::size_t columns) {
    STRIDOR_EXPECT(columns > 0);
    const double width = (x.to - x.from) / static_cast<double>(columns);
    std::vector<std::vector<double>> covered(strip.rows.size(), std::vector<double>(columns, 0.0));
    for (const Strip::Interval& interval : strip.intervals) {
        STRIDOR_EXPECT(interval.row < strip.rows.size());
        if (interval.to < x.from || interval.from > x.to) continue;
        add_interval(covered[interval.row], {(std::max(interval.from, x.from) - x.from) / width,
                                             (std::min(interval.to, x.to) - x.from) / width});
    }
    std::vector<Shade> result;
    for (std::size_t row = 0; row < covered.size(); ++row)
        for (std::size_t c = 0; c < columns; ++c) {
            if (covered[row][c] == 0.0) continue;
            const double share = shade_of(covered[row][c]);
            const double from = x.from + static_cast<double>(c) * width;
            const double to = x.from + static_cast<double>(c + 1) * width;
            const bool goes_on = c > 0 && covered[row][c - 1] > 0.0 && result.back().share == share;
            if (goes_on)
                result.back().x.to = to;
            else
                result.push_back({{from, to}, row, share});
        }
    return result;
}

std::vector<CellRun> cell_runs(const std::vector<double>& x_edges, const std::vector<double>& y_edges,
                               const std::vector<std::uint16_t>& kinds) {
    std::vector<CellRun> runs;
    if (x_edges.size() < 2 || y_edges.size() < 2) return runs;
    const std::size_t columns = x_edges.size() - 1;
    STRIDOR_EXPECT(kinds.size() == columns * (y_edges.size() - 1));
    for (std::size_t row = 0; row + 1 < y_edges.size(); ++row)
        for (std::size_t column = 0; column < columns; ++column) {
            const std::size_t kind = kinds[row * columns + column];
            if (column > 0 && runs.back().kind == kind)
                runs.back().box.x.to = x_edges[column + 1];
            else
                runs.push_back({{{x_edges[column], x_edges[column + 1]}, {y_edges[row], y_edges[row + 1]}}, kind});
        }
    return runs;
}

}  // namespace stridor::drawing
