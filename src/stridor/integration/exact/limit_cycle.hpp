#pragma once

#include "stridor/integration/exact/account.hpp"
#include "stridor/integration/run/event_loop.hpp"
#include "stridor/integration/run/motion.hpp"
#include "stridor/integration/run/return_watch.hpp"
#include "stridor/record/recorder.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace stridor::integration {

/// Watches the events of one contact for a limit cycle.
class CycleWatch {
    struct Event {
        double time = 0.0;
        ContactMode mode = ContactMode::open;
        Lanes s{};
    };

public:
    using Finding = ReturnWatch<Event>::Finding;

    /// `velocity` [m/s] is the drive's, `rate` [1/s] makes positions comparable with velocities.
    CycleWatch(double velocity, double rate, int closed) : velocity_(velocity), rate_(rate), closed_(closed) {}

    /// Returns the contact enters a state.
    Finding note(double time, ContactMode mode, const Lanes& s);

    /// Returns the cycle that was found.
    const LimitCycle& cycle() const { return cycle_; }

    /// Returns when the last whole period began [s].
    double period_begin() const { return watch_.found().first.time; }

private:
    static constexpr int longest = 64;  // events of a period

    double distance(const Event& a, const Event& b) const;

    double velocity_, rate_;
    int closed_;
    ReturnWatch<Event> watch_{longest};
    LimitCycle cycle_;
};

/// The changes of state a recorder has been told of lately.
class RecentChanges {
public:
    void add(const record::ContactInterval& interval) { ring_[count_++ % size] = interval; }

    /// Returns those from a time on, in order.
    std::vector<ContactChange> since(double time) const;

private:
    static constexpr std::size_t size = 256;
    std::array<record::ContactInterval, size> ring_;
    std::size_t count_ = 0;
};

}  // namespace stridor::integration
