#include "stridor/sweep/ready_charts.hpp"

#include "stridor/sweep/paper_charts.hpp"
#include "stridor/sweep/soft_parts.hpp"

namespace stridor::sweep {

std::vector<ReadyChart> ready_charts() {
    constexpr double paper_angle = 70.0;  // [deg]
    std::vector<ReadyChart> charts{{"noise-chart", PlaneSet::paper, figure_8()},
                                   {"rate-map", PlaneSet::paper, figure_6(paper_angle)}};
    for (std::size_t k = 0; k < soft_part_names.size(); ++k)
        charts.push_back({std::string(soft_part_names[k].name), PlaneSet::soft, soft_part(static_cast<SoftPart>(k))});
    return charts;
}

}  // namespace stridor::sweep
