#include "stridor/reduction/reduction.hpp"

#include <algorithm>
#include <string>

namespace stridor::reduction {

namespace {

using Eigen::Index;

// positions and sets of what the reduced part still names
void keep_geometry(ElasticPart& reduced, const ElasticPart& part, const std::vector<RowLabel>& recovered) {
    const auto keep = [&](const RowLabel& label) {
        if (const auto found = part.positions.find(label.node); found != part.positions.end())
            reduced.positions.insert(*found);
    };
    std::for_each(reduced.labels.begin(), reduced.labels.end(), keep);
    std::for_each(recovered.begin(), recovered.end(), keep);
    for (const NodeSet& set : part.sets) {
        NodeSet kept{set.name, {}};
        for (const std::string& node : set.nodes)
            if (std::any_of(reduced.labels.begin(), reduced.labels.end(),
                            [&](const RowLabel& label) { return label.node == node; }))
                kept.nodes.push_back(node);
        if (!kept.nodes.empty()) reduced.sets.push_back(std::move(kept));
    }
}

}  // namespace

Reduction opened_reduction(const ElasticPart& part, const ReductionRequest& request, const Modes& modes) {
    Reduction reduction;
    reduction.boundary_rows = static_cast<Index>(request.boundary.size());
    for (const Index row : request.boundary)
        reduction.part.labels.push_back(part.labels[static_cast<std::size_t>(row)]);
    for (Index mode = 0; mode < modes.squared.size(); ++mode) {
        reduction.part.labels.push_back({"mode " + std::to_string(mode + 1), 0});
        reduction.mode_frequencies.push_back(frequency_of(modes.squared[mode]));
    }
    for (const Index row : request.recovered)
        reduction.recovered.push_back(part.labels[static_cast<std::size_t>(row)]);
    keep_geometry(reduction.part, part, reduction.recovered);
    return reduction;
}

}  // namespace stridor::reduction
