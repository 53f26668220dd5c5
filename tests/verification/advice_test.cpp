#include "stridor/advice/advice.hpp"

#include "stridor/parameters/paper_cases.hpp"
#include "stridor/sweep/boundaries.hpp"
#include "stridor/sweep/evaluate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace stridor::sweep {
namespace {

const parameters::Case squeal = parameters::paper_case(parameters::PaperCase::squeal);

// charts around the squeal of Table 1, close along one axis, with the present design in the middle of the other
constexpr int close = advice::scan_intervals + 1;

Study chart(Axis preload, Axis friction) {
    Study study;
    study.base = squeal;
    study.x = std::move(preload);
    study.y = std::move(friction);
    return study;
}

Study chart_along_preload() {
    return chart({"contact.preload", 2.0, 200.0, close, Scale::logarithmic},
                 {"contact.kinetic_friction", 0.4, 0.8, 3, Scale::linear});
}

Study chart_along_friction() {
    return chart({"contact.preload", 2.0, 200.0, 3, Scale::logarithmic},
                 {"contact.kinetic_friction", 0.0, 0.8, close, Scale::linear});
}

std::vector<Boundary> boundaries_of(const Study& study) {
    std::vector<Cell> cells(cell_count(study));
    for (int iy = 0; iy < study.y.points; ++iy)
        for (int ix = 0; ix < study.x.points; ++ix) {
            std::vector<Cell> here = evaluate(study, ix, iy);
            for (std::size_t direction = 0; direction < here.size(); ++direction)
                cells[index_of(study, {direction, iy, ix})] = std::move(here[direction]);
        }
    return boundaries(complete(study, std::move(cells)));
}

// does a line of this direction cross the row (or column) of the present design at the value, within its resolution?
bool is_crossed(const std::vector<Boundary>& lines, std::size_t direction, Crossing along, double value) {
    for (const Boundary& line : lines) {
        if (line.direction != direction) continue;
        for (const BoundaryVertex& vertex : line.vertices) {
            const bool is_along_x = along == Crossing::along_x;
            const bool is_here = is_along_x ? std::abs(vertex.y - squeal.contact().kinetic_friction) < 1e-9
                                            : std::abs(vertex.x - squeal.contact().preload) < 1e-9;
            const double off = is_along_x ? std::abs(vertex.x - value) / vertex.x_resolution
                                          : std::abs(vertex.y - value) / vertex.y_resolution;
            if (vertex.crossing == along && is_here && off <= 1.0 + 1e-9) return true;
        }
    }
    return false;
}

TEST(Advice, HasItsMarginsOnTheBoundariesOfTheChart) {
    const std::vector<Boundary> lines[] = {boundaries_of(chart_along_preload()), boundaries_of(chart_along_friction())};
    advice::AdviceOptions options;
    options.over = {{"contact.preload", 2.0, 200.0}, {"contact.kinetic_friction", 0.0, 0.8}};
    const advice::Advice advice = advice::advise(squeal, options);
    std::size_t compared = 0;
    for (const advice::ParameterMargin& margin : advice.margins)
        for (const advice::ScanSide* side : {&margin.below, &margin.above}) {
            if (!side->change) continue;
            for (std::size_t phase = 0; phase < advice.space.phases.size(); ++phase) {
                if (side->change->beyond.phases[phase] == advice.present.phases[phase]) continue;
                const Crossing along = margin.parameter == 0 ? Crossing::along_x : Crossing::along_y;
                EXPECT_TRUE(is_crossed(lines[margin.parameter], phase, along, side->change->value))
                    << advice.space.parameters[margin.parameter].key << " = " << side->change->value;
                ++compared;
            }
        }
    EXPECT_GE(compared, 3U);
}

}  // namespace
}  // namespace stridor::sweep
