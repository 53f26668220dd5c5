#include "stridor/analysis/friction/slips.hpp"

#include <algorithm>
#include <cmath>

namespace stridor::analysis {

namespace {

constexpr std::size_t fewest_slip_samples = 6;  // of a slip, between its onset and its lowest force
constexpr std::size_t most_climb_samples = 64;  // before it

// force of the spring [N] and velocity of the slider [m/s]
struct SlipMotion {
    double force = 0.0;
    double velocity = 0.0;
};

struct SlipEquations {
    const model::FrictionLaw& law;
    const MeasuringRig& rig;
    const SlipStart& start;

    SlipMotion rates(const SlipMotion& at) const {
        const double w = std::max(0.0, start.velocity - at.velocity);
        const double friction = -start.limit * model::slip_ratio(law, model::Slip::forward, w);
        return {rig.stiffness * at.velocity, (friction - at.force - rig.damping * at.velocity) / rig.mass};
    }
    SlipMotion step(const SlipMotion& at, double h) const {
        const auto ahead = [&](const SlipMotion& rate, double time) {
            return SlipMotion{at.force + time * rate.force, at.velocity + time * rate.velocity};
        };
        const SlipMotion a = rates(at), b = rates(ahead(a, 0.5 * h)), c = rates(ahead(b, 0.5 * h)),
                         d = rates(ahead(c, h));
        return {at.force + h / 6.0 * (a.force + 2.0 * (b.force + c.force) + d.force),
                at.velocity + h / 6.0 * (a.velocity + 2.0 * (b.velocity + c.velocity) + d.velocity)};
    }
};

// Hermite's cubic between two motions, at a share of the step
double force_between(const SlipMotion& from, const SlipMotion& to, double share, double h, double stiffness) {
    const double s = share, r = 1.0 - share;
    return r * r * (1.0 + 2.0 * s) * from.force + s * s * (1.0 + 2.0 * r) * to.force +
           s * r * h * stiffness * (r * from.velocity - s * to.velocity);
}

}  // namespace

RecordedSlip recorded_slip(const Fall& fall, std::span<const double> force, double rate) {
    RecordedSlip slip;
    if (fall.valley < fall.onset + fewest_slip_samples || fall.onset < fall.rise_from + 4) return slip;
    const std::size_t from =
        fall.onset - std::min(most_climb_samples, std::max<std::size_t>(4, (fall.onset - fall.rise_from) / 2));
    slip.force.assign(force.begin() + static_cast<std::ptrdiff_t>(from),
                      force.begin() + static_cast<std::ptrdiff_t>(fall.valley + 1));
    const Release release = release_of(fall, force);
    slip.rate = rate;
    slip.onset = (static_cast<double>(fall.onset - from) + 0.5) / rate;
    slip.limit = release.peak;
    slip.climb = release.resolution * rate;
    return slip;
}

SlipTrack slip_track(const model::FrictionLaw& law, const MeasuringRig& rig, const SlipStart& start,
                     std::span<const double> times) {
    const SlipEquations equations{law, rig, start};
    const double climb = rig.stiffness * start.velocity;
    SlipTrack track;
    track.force.reserve(times.size());
    track.rate.reserve(times.size());
    SlipMotion at{start.limit - rig.damping * start.velocity, start.velocity}, next = at;
    double time = 0.0, stuck_from = 0.0, stuck_force = at.force;
    bool is_slipping = false, is_over = false;
    for (const double wanted : times) {
        if (wanted > 0.0 && !is_slipping && !is_over) {
            is_slipping = true;
            next = equations.step(at, start.step);
        }
        while (is_slipping) {
            // the slider has caught up: it sticks from where the slip velocity is zero
            if (next.velocity >= start.velocity) {
                const double before = start.velocity - at.velocity, after = next.velocity - start.velocity;
                const double share = before + after > 0.0 ? before / (before + after) : 0.0;
                stuck_from = time + share * start.step;
                stuck_force = force_between(at, next, share, start.step, rig.stiffness);
                is_over = true;
            }
            if (is_over || !(wanted > time + start.step)) break;
            time += start.step;
            at = next;
            next = equations.step(at, start.step);
        }
        if (!is_slipping || (is_over && wanted >= stuck_from)) {
            track.force.push_back(stuck_force + climb * (wanted - stuck_from));
            track.rate.push_back(climb);
            continue;
        }
        const double share = (wanted - time) / start.step;
        track.force.push_back(force_between(at, next, share, start.step, rig.stiffness));
        track.rate.push_back(rig.stiffness * (at.velocity + share * (next.velocity - at.velocity)));
    }
    return track;
}

}  // namespace stridor::analysis
