#include "stridor/chart/design_mark.hpp"

#include "stridor/chart/field_axis.hpp"
#include "stridor/chart/palette.hpp"

#include <array>
#include <string_view>

namespace stridor::chart {

namespace {

constexpr double mark_diameter = 9.0;  // [pt] found at a glance

Text design_words(const sweep::Study& study) {
    const std::array<std::string_view, 2> keys{study.x.parameter, study.y.parameter};
    const std::size_t axes = sweep::has_one_axis(study) ? 1 : 2;
    return settings(study.base, std::span(keys).first(axes));
}

}  // namespace

void mark_design(Scene& scene, const sweep::Study& study) {
    if (!sweep::holds_design(study)) {
        scene.caption.push_back(Text("The design, ") + design_words(study) + ", lies outside of this chart.");
        return;
    }
    if (sweep::has_one_axis(study)) {
        const Stroke stroke{ink, 1.2, Dash::dashed};
        scene.legend.push_back({Text("design: ") + design_words(study), stroke});
        for (Panel& panel : scene.panels)
            panel.layers.emplace_back(Rule{sweep::own_value(study, study.x), Orientation::vertical, stroke});
        return;
    }
    Points mark{{}, {}, ink, mark_diameter, {}, Mark::diamond, white};
    scene.legend.push_back({Text("design: ") + design_words(study), mark});
    mark.x = {sweep::own_value(study, study.x)};
    mark.y = {sweep::own_value(study, study.y)};
    for (Panel& panel : scene.panels)
        panel.layers.emplace_back(mark);
}

}  // namespace stridor::chart
