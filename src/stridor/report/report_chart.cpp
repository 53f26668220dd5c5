#include "stridor/report/report_chart.hpp"

#include "stridor/base/error.hpp"
#include "stridor/io/chart/axis_text.hpp"
#include "stridor/sweep/usual_axes.hpp"

#include <algorithm>

namespace stridor::report {

namespace {

bool has_chart_axes(const io::TomlSource& source) {
    const io::TomlDocument document = io::parse_toml(source);
    return document.find("chart.x.parameter") != nullptr && document.find("chart.y.parameter") != nullptr;
}

// what a file does not say
io::AxisTexts usual_axes(const parameters::Case& c, int points) {
    const auto [x, y] = sweep::usual_axes(c, points);
    return {io::axis_text(x), io::axis_text(y)};
}

}  // namespace

sweep::Study chart_to_report(const io::TomlSource& source, const parameters::Case& c, io::AxisTexts axes, int points,
                             const advice::AskedRuns& runs) {
    if (axes.x.empty() && axes.y.empty() && !has_chart_axes(source)) axes = usual_axes(c, points);
    sweep::Study study = io::read_study(source, axes);
    if (sweep::has_one_axis(study))
        throw Error(ErrorKind::input, {"the chart of a report has two axes", "--x was given without --y",
                                       "Add --y, such as --y mu_d=0.2:0.8."});
    for (sweep::Axis* axis : {&study.x, &study.y})
        axis->points = std::min(axis->points, points);
    study.quantities = {"category"};
    study.refine = 0;
    judge_alike(study, advice::design_space(c, {}, runs));
    return study;
}

void judge_alike(sweep::Study& study, const advice::DesignSpace& space) {
    study.starts = advice::starts_of(space);
    if (!parameters::has_one_phase(space.base.drive) || space.runs.front().direction) {
        study.directions.clear();
        for (const record::Phase phase : space.phases)
            study.directions.push_back(phase == record::Phase::going ? parameters::Direction::going
                                                                     : parameters::Direction::coming);
    }
}

}  // namespace stridor::report
