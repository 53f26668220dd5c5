#include "stridor/analysis/evidence_figures.hpp"

#include <array>

namespace stridor::analysis {

namespace {

using Holds = EvidenceFigure::Holds;
using Kept = EvidenceFigure::Kept;

constexpr std::string_view level_unit = "dB re 1e-9 m/s";

constexpr std::array table{
    EvidenceFigure{"slip", "rates.slip", "1", "share of the window in slip",
                   [](const Evidence& e) { return e.rates.slip; }},
    EvidenceFigure{"stick", "rates.stick", "1", "share of the window in stick",
                   [](const Evidence& e) { return e.rates.stick; }},
    EvidenceFigure{"separation", "rates.separation", "1", "share of the window in separation",
                   [](const Evidence& e) { return e.rates.separation; }},
    EvidenceFigure{"judged_slip", "judged_rates.slip", "1", "share of the judged time in slip",
                   [](const Evidence& e) { return e.judged_rates.slip; }},
    EvidenceFigure{"judged_stick", "judged_rates.stick", "1", "share of the judged time in stick",
                   [](const Evidence& e) { return e.judged_rates.stick; }},
    EvidenceFigure{"judged_separation", "judged_rates.separation", "1", "share of the judged time in separation",
                   [](const Evidence& e) { return e.judged_rates.separation; }},
    EvidenceFigure{"regularity", "regularity", "1", "regularity of the beats: 1 when all intervals are equal",
                   [](const Evidence& e) { return e.alternation.regularity; }},
    EvidenceFigure{"repetition", "repetition", "1", "repetition of the pattern, perhaps after several unequal beats",
                   [](const Evidence& e) { return e.alternation.repetition; }},
    EvidenceFigure{"variation", "variation", "1", "coefficient of variation of the intervals between beats",
                   [](const Evidence& e) { return e.alternation.variation; }},
    EvidenceFigure{"intervals", "intervals", "1", "number of intervals between beats",
                   [](const Evidence& e) { return static_cast<double>(e.alternation.intervals); }, Holds::count},
    EvidenceFigure{"releases", "releases", "1", "number of sticks that ended in the judged time",
                   [](const Evidence& e) { return static_cast<double>(e.releases); }, Holds::count},
    EvidenceFigure{"lag", "lag", "1", "beats per period of the pattern",
                   [](const Evidence& e) { return static_cast<double>(e.alternation.lag); }, Holds::count},
    EvidenceFigure{"period", "period", "s", "period of the pattern",
                   [](const Evidence& e) { return e.alternation.period; }},
    EvidenceFigure{"frequency", "frequency", "Hz", "dominant frequency of the alternation",
                   [](const Evidence& e) { return e.alternation.frequency; }},
    EvidenceFigure{"preload", "normal_force.preload", "N", "normal force at rest",
                   [](const Evidence& e) { return e.preload; }, Holds::number, Kept::in_verdicts},
    EvidenceFigure{"largest_normal_force", "normal_force.largest", "N",
                   "largest normal force in the judged time, where states end",
                   [](const Evidence& e) { return e.largest_force; }, Holds::number, Kept::in_verdicts},
    EvidenceFigure{"drag_from", "drag.from", "N", "normal force where the last stick began, without vibration",
                   [](const Evidence& e) { return e.ending.outlook.drag.from; }, Holds::number, Kept::in_verdicts},
    EvidenceFigure{"drag_to", "drag.to", "N", "normal force at the end of the run, without vibration",
                   [](const Evidence& e) { return e.ending.outlook.drag.to; }, Holds::number, Kept::in_verdicts},
    EvidenceFigure{"drag_way", "drag.way", "m", "way over which the contact was dragged in between",
                   [](const Evidence& e) { return e.ending.outlook.drag.way; }, Holds::number, Kept::in_verdicts},
    EvidenceFigure{"drag_slope", "drag.slope", "N/m", "how the normal force goes on with the way",
                   [](const Evidence& e) { return e.ending.outlook.drag.slope; }, Holds::number, Kept::in_verdicts},
    EvidenceFigure{"joint_rms", "levels.joint.rms", "m/s", "root mean square velocity of the joint",
                   [](const Evidence& e) { return e.levels.joint.rms; }},
    EvidenceFigure{"joint_peak", "levels.joint.peak", "m/s", "peak velocity of the joint",
                   [](const Evidence& e) { return e.levels.joint.peak; }},
    EvidenceFigure{"joint_level", "levels.joint.level", level_unit, "velocity level of the joint",
                   [](const Evidence& e) { return e.levels.joint.decibels; }},
    EvidenceFigure{"joint_peak_level", "levels.joint.peak_level", level_unit, "peak velocity level of the joint",
                   [](const Evidence& e) { return e.levels.joint.peak_decibels; }, Holds::number, Kept::in_verdicts},
    EvidenceFigure{"plate_rms", "levels.plate.rms", "m/s", "root mean square velocity of the plate",
                   [](const Evidence& e) { return e.levels.plate.rms; }},
    EvidenceFigure{"plate_peak", "levels.plate.peak", "m/s", "peak velocity of the plate",
                   [](const Evidence& e) { return e.levels.plate.peak; }},
    EvidenceFigure{"plate_level", "levels.plate.level", level_unit, "velocity level of the plate",
                   [](const Evidence& e) { return e.levels.plate.decibels; }},
    EvidenceFigure{"plate_peak_level", "levels.plate.peak_level", level_unit, "peak velocity level of the plate",
                   [](const Evidence& e) { return e.levels.plate.peak_decibels; }, Holds::number, Kept::in_verdicts},
};

}  // namespace

std::span<const EvidenceFigure> evidence_figures() {
    return table;
}

std::string unit_key(const EvidenceFigure& figure) {
    if (figure.holds == Holds::count) return {};
    const std::string_view object = figure.key.substr(0, figure.key.find('.'));
    if (object == figure.key || figure.unit == "1") return std::string(object);
    return std::string(object) + "." + std::string(figure.key.substr(figure.key.rfind('.') + 1));
}

}  // namespace stridor::analysis
