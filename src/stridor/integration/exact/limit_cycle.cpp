#include "stridor/integration/exact/limit_cycle.hpp"

#include <cmath>

namespace stridor::integration {

namespace {

// distance of two states, as a share of the velocities, up to which a motion has returned
constexpr double tolerance = 1e-9;
// below this a distance is rounding and need not shrink any more
constexpr double rounding = 1e-12;

}  // namespace

double CycleWatch::distance(const Event& a, const Event& b) const {
    double difference = 0.0, scale = std::abs(velocity_);
    for (int i = 0; i < closed_; ++i) {
        difference += rate_ * std::abs(a.s.at[i] - b.s.at[i]) + std::abs(a.s.at[closed_ + i] - b.s.at[closed_ + i]);
        scale += std::abs(a.s.at[closed_ + i]);
    }
    // open: the velocity of the gap, which is zero at lift-off and not after a rebound; closed:
    // the drive's other number
    difference += std::abs(a.s.at[2 * closed_ + 2] - b.s.at[2 * closed_ + 2]);
    return difference / scale;
}

CycleWatch::Finding CycleWatch::note(double time, ContactMode mode, const Lanes& s) {
    const Event here{time, mode, s};
    if (!has_anchor_) {
        anchor_ = here;
        has_anchor_ = true;
        since_ = length_ = 0;
        return Finding::nothing;
    }
    ++since_;
    if (length_ == 0) {
        sequence_[static_cast<std::size_t>(since_ - 1)] = mode;
        if (mode == anchor_.mode) {
            first_distance_ = distance(here, anchor_);
            if (first_distance_ <= tolerance) {
                first_ = here;
                length_ = since_;
                since_ = 0;
                return Finding::first_return;
            }
        }
        if (since_ == longest) {
            anchor_ = here;
            since_ = 0;
        }
        return Finding::nothing;
    }
    const bool follows = sequence_[static_cast<std::size_t>(since_ - 1)] == mode;
    if (follows && since_ < length_) return Finding::nothing;
    const double second = follows ? distance(here, first_) : 1.0;
    if (follows && second <= tolerance && (second <= first_distance_ || second <= rounding)) {
        cycle_ = {time, time - first_.time, second, length_};
        period_begin_ = first_.time;
        anchor_ = here;
        since_ = length_ = 0;
        return Finding::cycle;
    }
    anchor_ = here;
    since_ = length_ = 0;
    return Finding::nothing;
}

std::vector<record::ContactInterval> RecentChanges::since(double time) const {
    std::vector<record::ContactInterval> changes;
    for (std::size_t k = count_ > size ? count_ - size : 0; k < count_; ++k)
        if (ring_[k % size].from >= time) changes.push_back(ring_[k % size]);
    return changes;
}

void repeat_period(const std::vector<record::ContactInterval>& period, double duration, double end,
                   record::Recorder& recorder, const std::stop_token& stop) {
    if (period.empty()) return;
    for (double number = 1.0; !stop.stop_requested(); ++number)
        for (record::ContactInterval interval : period) {
            interval.from += number * duration;
            if (interval.from >= end) return;
            recorder.enter(0, interval);
        }
}

}  // namespace stridor::integration
