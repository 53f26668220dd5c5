#include "stridor/analysis/evidence.hpp"

#include "stridor/analysis/rates.hpp"
#include "stridor/base/check.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/parameters/system.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace stridor::analysis {

std::string_view level_title(const parameters::Case& c) {
    return parameters::has_plate(c) ? "joint level" : "level";
}

std::string_view level_note(const parameters::Case& c) {
    return parameters::has_plate(c)
               ? "Levels are of the joint's velocity, dB re 1 nm/s: a vibration, not a sound pressure."
               : "Levels are of the contact point's velocity, dB re 1 nm/s: a vibration, not a sound pressure.";
}

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

double level(double velocity) {
    if (std::isnan(velocity)) return velocity;
    return velocity >= reference_velocity ? base::decibels(velocity / reference_velocity)
                                          : -std::numeric_limits<double>::infinity();
}

Level level_of(std::span<const record::Vibration> components, double time) {
    double square_time = 0.0;
    double peak_square = 0.0;
    for (const record::Vibration& component : components) {
        square_time += component.square_time;
        peak_square = std::max(peak_square, component.peak_square);
    }
    if (!(time > 0.0)) {
        return {nothing, nothing, nothing, nothing};
    }
    const double rms = std::sqrt(square_time / time);
    // instants of the largest velocity lie between the sampled ones; a steady velocity is its own peak but for rounding
    const double peak = std::max(rms, std::sqrt(peak_square));
    return {rms, peak, level(rms), level(peak)};
}

Rates change(const Rates& from, const Rates& to) {
    return {std::abs(to.slip - from.slip), std::abs(to.stick - from.stick), std::abs(to.separation - from.separation)};
}

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

Levels levels(const record::Tally& tally, std::size_t contact, Part part, Along along) {
    const bool is_closing = part == Part::closing;
    const std::span<const record::Vibration> all(is_closing ? tally.closing_vibration : tally.vibration);
    const double time = is_closing ? tally.closing_time : tally.vibration_time;
    const std::size_t points = 2 * tally.contacts.size();
    STRIDOR_EXPECT((all.size() == points || all.size() == points + 1) && contact < tally.contacts.size());
    // an own structure has no plate; across a closed contact it rests
    if (all.size() == points)
        return {level_of(along == Along::carried ? all.subspan(2 * contact + 1, 1) : all.subspan(2 * contact, 2), time),
                {nothing, nothing, nothing, nothing}};
    const Level plate = level_of(all.last(1), time);
    // the gap is closed: across the contact a carried joint moves as the plate does
    return {along == Along::carried ? plate : level_of(all.subspan(2 * contact, 2), time), plate};
}

Evidence evidence(const record::Tally& tally, std::size_t contact) {
    STRIDOR_EXPECT(contact < tally.contacts.size());
    const record::ContactTally& one = tally.contacts[contact];
    Evidence figures;
    figures.phase = tally.phase;
    figures.contact = contact;
    figures.window_time = one.time[0] + one.time[1] + one.time[2];
    figures.judged_time = one.judged_time[0] + one.judged_time[1] + one.judged_time[2];
    figures.rates = rates(one.time);
    figures.judged_rates = rates(one.judged_time);
    figures.judged_errors = share_errors(one);
    figures.alternation = alternation(one.changes);
    for (std::size_t to = 0; to < model::contact_states; ++to)
        figures.releases +=
            one.changes[record::change_kind(model::ContactState::stick, static_cast<model::ContactState>(to))].count;
    figures.all_releases = one.releases;
    figures.ending = one.ending;
    figures.preload = one.preload;
    figures.creeps = one.creeps;
    figures.largest_force = one.load.largest_force;
    if (one.coarser) {
        figures.step_change = change(rates(one.coarser->time), figures.rates);
        figures.judged_step_change = change(rates(one.coarser->judged_time), figures.judged_rates);
        figures.coarser = alternation(one.coarser->changes);
    }
    const bool is_over = slides_for_good(figures) || sticks_for_good(figures);
    const Along along = sticks_for_good(figures) ? Along::carried : Along::counted;
    figures.levels = levels(tally, contact, is_over && tally.closing_time > 0.0 ? Part::closing : Part::judged, along);
    return figures;
}

bool sticks_for_good(const Evidence& evidence) {
    const record::Future future = evidence.ending.outlook.future;
    const bool sticks_throughout = evidence.judged_rates.stick >= 1.0 && future != record::Future::releases;
    return future == record::Future::sticks || sticks_throughout;
}

bool slides_for_good(const Evidence& evidence) {
    const record::Outlook& outlook = evidence.ending.outlook;
    const bool slides_throughout =
        evidence.judged_rates.slip >= 1.0 && std::isnan(outlook.growth) && outlook.future != record::Future::creeps;
    return outlook.future == record::Future::slides || slides_throughout;
}

bool stays_off(const Evidence& evidence) {
    return evidence.judged_rates.separation > 0.0 && evidence.alternation.intervals == 0 &&
           evidence.ending.state == model::ContactState::separation;
}

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
