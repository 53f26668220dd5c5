#include "stridor/integration/exact/limit_cycle.hpp"

#include <cmath>

namespace stridor::integration {

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
    const Finding finding =
        watch_.note({time, mode, s}, [this](const Event& a, const Event& b) { return distance(a, b); });
    if (finding != Finding::cycle) return finding;
    const Return<Event>& found = watch_.found();
    cycle_ = {time, time - found.first.time, found.distance, found.length};
    return finding;
}

std::vector<ContactChange> RecentChanges::since(double time) const {
    std::vector<ContactChange> changes;
    for (std::size_t k = count_ > size ? count_ - size : 0; k < count_; ++k)
        if (ring_[k % size].from >= time) changes.push_back({0, ring_[k % size]});
    return changes;
}

}  // namespace stridor::integration
