#include "stridor/report/report_chart.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/case_key.hpp"
#include "stridor/parameters/temperature_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace stridor::report {

namespace {

bool has_chart_axes(const io::TomlSource& source) {
    const io::TomlDocument document = io::parse_toml(source);
    return document.find("chart.x.parameter") != nullptr && document.find("chart.y.parameter") != nullptr;
}

}  // namespace

sweep::Study chart_to_report(const io::TomlSource& source, const parameters::Case& c, io::AxisTexts axes, int points) {
    const bool is_own = axes.x.empty() && axes.y.empty() && !has_chart_axes(source);
    if (is_own) {
        // what a load or gaps press has no preload
        axes.x = parameters::belongs(c, "contact.preload")
                     ? fmt::format("contact.preload={}:{}:{}:log", base::shortest(0.1 * c.contact.preload),
                                   base::shortest(10.0 * c.contact.preload), points)
                     : fmt::format("structure.stiffness_scale=0.1:10:{}:log", points);
        const std::vector<double>& at = c.temperature.at;
        axes.y =
            parameters::temperature_column(c, "contact.kinetic_friction") == nullptr
                ? fmt::format("contact.kinetic_friction=0:{}:{}", base::shortest(c.contact.static_friction), points)
                : fmt::format("temperature.value={}:{}:{}", base::shortest(at.front()), base::shortest(at.back()),
                              points);
    }
    sweep::Study study = io::read_study(source, axes);
    if (sweep::has_one_axis(study))
        throw Error(ErrorKind::input, {"the chart of a report has two axes", "--x was given without --y",
                                       "Add --y, such as --y mu_d=0.2:0.8."});
    for (sweep::Axis* axis : {&study.x, &study.y})
        axis->points = std::min(axis->points, points);
    study.quantities = {"category"};
    study.refine = 0;
    study.starts.clear();
    return study;
}

}  // namespace stridor::report
