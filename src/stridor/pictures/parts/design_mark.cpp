#include "stridor/pictures/parts/design_mark.hpp"

#include "stridor/drawing/palette.hpp"
#include "stridor/pictures/parts/field_axis.hpp"

#include <array>
#include <string_view>

namespace stridor::pictures {

namespace {

constexpr double mark_diameter = 9.0;  // [pt] found at a glance

drawing::StyledText design_words(const sweep::Study& study) {
    const std::array<std::string_view, 2> keys{study.x.parameter, study.y.parameter};
    const std::size_t axes = sweep::has_one_axis(study) ? 1 : 2;
    return settings(study.base, std::span(keys).first(axes));
}

}  // namespace

void mark_design(drawing::Scene& scene, const sweep::Study& study) {
    if (!sweep::holds_design(study)) {
        scene.caption.push_back(drawing::StyledText("The design, ") + design_words(study) +
                                ", lies outside of this chart.");
        return;
    }
    if (sweep::has_one_axis(study)) {
        const drawing::Stroke stroke{drawing::ink, 1.2, drawing::Dash::dashed};
        scene.legend.push_back({drawing::StyledText("design: ") + design_words(study), stroke});
        for (drawing::Panel& panel : scene.panels)
            panel.layers.emplace_back(
                drawing::Rule{sweep::own_value(study, study.x), drawing::Orientation::vertical, stroke});
        return;
    }
    drawing::Points mark{{}, {}, drawing::ink, mark_diameter, {}, drawing::Mark::diamond, drawing::white};
    scene.legend.push_back({drawing::StyledText("design: ") + design_words(study), mark});
    mark.x = {sweep::own_value(study, study.x)};
    mark.y = {sweep::own_value(study, study.y)};
    for (drawing::Panel& panel : scene.panels)
        panel.layers.emplace_back(mark);
}

}  // namespace stridor::pictures
