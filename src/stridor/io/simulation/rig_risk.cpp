#include "stridor/io/simulation/rig_risk.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/io/chart/range_text.hpp"
#include "stridor/io/json_parts.hpp"
#include "stridor/io/simulation/friction_test_json.hpp"
#include "stridor/sweep/evaluate.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace stridor::io {

namespace {

using base::Json;

void set_scale(analysis::RiskScales& scales, const std::string& text) {
    const std::optional<RangeText> range = split_range(text);
    const auto scale =
        std::find_if(scales.begin(), scales.end(), [&](const auto& each) { return range && each.key == range->key; });
    if (scale == scales.end() || range->parts.size() != 2)
        base::refuse("\"" + text + "\" is no range of a risk figure",
                     "the figures are acceleration, impulse_rate and energy_rate",
                     "Write --risk-range \"acceleration=0.1:10 m/s^2\".");
    const RangeEnds ends = read_range_ends(range->parts[0], range->parts[1], scale->unit);
    if (!(ends.from > 0.0) || !(ends.to > ends.from))
        base::refuse("the range \"" + text + "\" does not rise from above zero", "ranks follow its logarithm", "");
    scale->low = ends.from;
    scale->high = ends.to;
}

// a slider of the rig's mass on its spring, dragged
parameters::Case case_of_rig(const FrictionTest& test, const analysis::FrictionTrace& trace,
                             const analysis::RiskRig& rig, double damping) {
    parameters::Case c;
    parameters::Joint& joint = c.joint();
    joint.incidence_angle = 0.0;
    joint.mass = rig.mass;
    joint.axial_stiffness = rig.stiffness;
    joint.axial_damping = damping;
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = std::abs(test.velocity);
    c.contact().preload = test.preload;
    c.contact().kinetic_friction = trace.all.kinetic_friction.value;
    const double limit = trace.all.static_friction.value;
    c.contact().static_friction = limit > c.contact().kinetic_friction ? limit : c.contact().kinetic_friction;
    c.run.initial = parameters::Initial::stuck;
    c.run.duration = c.run.window = 10.0;
    return c;
}

std::string model_category(const parameters::Case& c) {
    integration::Workspace workspace;
    const std::optional<sweep::Attempt> attempt = sweep::attempt(c, {}, {}, workspace);
    if (!attempt) return {};
    const sweep::Cell cell = sweep::cell_of(c, parameters::Direction::going, *attempt);
    return cell.status == sweep::Status::done ? std::string(classification::name(cell.category)) : std::string();
}

}  // namespace

RigRisk rig_risk(const FrictionFitTexts& texts, const std::vector<std::string>& ranges,
                 const std::function<void(const std::string&)>& note) {
    RigRisk risk;
    for (const std::string& range : ranges)
        set_scale(risk.scales, range);
    analysis::RiskRig numbers;
    if (!texts.mass.empty()) numbers.mass = base::parse_quantity(texts.mass, "kg");
    if (!texts.stiffness.empty()) numbers.stiffness = base::parse_quantity(texts.stiffness, "N/m");
    const double damping = texts.damping.empty() ? 0.0 : base::parse_quantity(texts.damping, "N*s/m");
    if (numbers.mass <= 0.0 || numbers.stiffness <= 0.0 || damping < 0.0)
        base::refuse("the rig's mass and stiffness must be above zero, its damping not below", "", "");
    for (const FrictionTexts& each : texts_of_files(texts)) {
        const MeasuredFriction measured = measured_friction(each, note);
        RunRisk run{measured.test, analysis::risk_number(measured.trace, numbers, risk.scales), {}};
        if (std::isfinite(numbers.mass) && std::isfinite(numbers.stiffness) && std::isfinite(measured.test.velocity) &&
            std::isfinite(measured.trace.all.kinetic_friction.value))
            run.category = model_category(case_of_rig(measured.test, measured.trace, numbers, damping));
        risk.number = std::max(risk.number, run.risk.number);
        risk.runs.push_back(std::move(run));
    }
    return risk;
}

std::string rig_risk_json(const RigRisk& risk) {
    Json document = json_parts::opening("friction-risk");
    Json units = Json::object();
    document["number"] = risk.number;
    document["word"] = analysis::risk_word(risk.number);
    document["runs"] = json_parts::array_of(risk.runs, [&](const RunRisk& run) {
        Json object = test_object(run.test, units);
        for (std::size_t k = 0; k < analysis::risk_figures; ++k)
            object[std::string(risk.scales[k].key)] = {{"value", run.risk.figures[k]}, {"rank", run.risk.ranks[k]}};
        object["number"] = run.risk.number;
        object["model"] = base::text_or_null(run.category);
        return object;
    });
    document["scales"] = json_parts::array_of(risk.scales, [](const analysis::RiskScale& scale) -> Json {
        return {{"figure", scale.key}, {"what", scale.sentence}, {"low", scale.low}, {"high", scale.high}};
    });
    for (const analysis::RiskScale& scale : risk.scales)
        units[std::string(scale.key)] = scale.unit;
    document["units"] = units;
    return base::text_of(document);
}

}  // namespace stridor::io
