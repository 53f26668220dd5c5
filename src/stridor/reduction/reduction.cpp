#include "stridor/reduction/reduction.hpp"

#include "stridor/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <unordered_set>

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
    std::unordered_set<std::string_view> nodes;
    for (const RowLabel& label : reduced.labels)
        nodes.insert(label.node);
    for (const NodeSet& set : part.sets) {
        NodeSet kept{set.name, {}};
        for (const std::string& node : set.nodes)
            if (nodes.contains(node)) kept.nodes.push_back(node);
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

void expect_finite(const Reduction& reduction) {
    const auto is_finite = [](const SparseMatrix& matrix) {
        return std::all_of(matrix.valuePtr(), matrix.valuePtr() + matrix.nonZeros(),
                           [](double number) { return std::isfinite(number); });
    };
    if (is_finite(reduction.part.stiffness) && is_finite(reduction.part.mass) && is_finite(reduction.part.damping) &&
        reduction.recovery.allFinite())
        return;
    throw Error(ErrorKind::numerical,
                {"the reduced part left double precision", "a mode without mass, or numbers too far apart",
                 "Check the units of the part."});
}

}  // namespace stridor::reduction
