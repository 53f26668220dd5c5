#include "golden/motion_values.hpp"

namespace stridor::golden {

void add(Values& values, const record::ContactTally& contact) {
    values.add("time", contact.time);
    values.add("judged_time", contact.judged_time);
    for (const record::Instants& instants : contact.changes) {
        values.add("changes", instants.count);
        values.add("instant", instants.times);
    }
}

void add_ending(Values& values, const record::ContactTally& contact) {
    values.add("releases", contact.releases);
    values.add("state", contact.ending.state);
    values.add("since", contact.ending.since);
    values.add("future", contact.ending.outlook.future);
    values.add("future_from", contact.ending.outlook.from);
    values.add("release", contact.ending.outlook.release);
}

void add_vibration(Values& values, const record::Tally& tally) {
    for (const auto* vibrations : {&tally.vibration, &tally.closing_vibration})
        for (const record::Vibration& vibration : *vibrations) {
            values.add("square_time", vibration.square_time);
            values.add("peak_square", vibration.peak_square);
        }
    values.add("vibration_time", tally.vibration_time);
    values.add("closing_time", tally.closing_time);
}

void add(Values& values, const classification::Verdict& verdict) {
    values.add("category", name(verdict.category));
    values.add("quiet", name(verdict.quiet));
    const analysis::Evidence& evidence = verdict.evidence;
    values.add("regularity", evidence.alternation.regularity);
    values.add("repetition", evidence.alternation.repetition);
    values.add("variation", evidence.alternation.variation);
    values.add("lag", evidence.alternation.lag);
    values.add("period", evidence.alternation.period);
    values.add("frequency", evidence.alternation.frequency);
    for (const analysis::Level& level : {evidence.levels.joint, evidence.levels.plate}) {
        values.add("rms", level.rms);
        values.add("peak", level.peak);
        values.add("decibels", level.decibels);
    }
    for (const classification::Margin& margin : verdict.margins)
        values.add("distance", margin.distance);
}

void add_motion(Values& values, const record::Trace& trace) {
    values.add("sample", trace.time);
    for (const auto* motions : {&trace.displacement, &trace.velocity, &trace.acceleration})
        for (const std::vector<double>& motion : *motions)
            values.add("motion", motion);
}

void add(Values& values, const record::ContactTrace& contact) {
    values.add("normal_force", contact.normal_force);
    values.add("friction_force", contact.friction_force);
    values.add("gap", contact.gap);
}

void add(Values& values, const integration::Motion& motion) {
    values.add("reason", motion.outcome.reason);
    values.add("time", motion.outcome.time);
    const integration::EnergyBalance& energy = motion.energy;
    for (const double term : {energy.stored, energy.preload_work, energy.drive_work, energy.dashpot_loss,
                              energy.friction_loss, energy.impact_loss, energy.residual, energy.held})
        values.add("energy", term);
    if (motion.silence) values.add("silence", motion.silence->time);
    if (motion.cycle) values.add("cycle", motion.cycle->period);
}

void add(Values& values, const record::ContactHistory& history) {
    for (const record::ContactInterval& interval : history) {
        values.add("interval", interval.state);
        values.add("from", interval.from);
        values.add("slip_velocity", interval.slip_velocity);
        values.add("gap_velocity", interval.gap_velocity);
    }
}

}  // namespace stridor::golden
