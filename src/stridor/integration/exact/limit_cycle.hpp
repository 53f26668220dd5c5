#pragma once

#include "stridor/integration/exact/account.hpp"
#include "stridor/integration/motion.hpp"
#include "stridor/record/recorder.hpp"

#include <array>
#include <cstddef>
#include <stop_token>
#include <vector>

namespace stridor::integration {

/// Watches the events of a motion under a constant drive for a limit cycle: the same sequence of contact states twice,
/// and the same state at its end as at its beginning, closer the second time than the first.
class CycleWatch {
public:
    /// What an event showed.
    enum class Finding { nothing, first_return, cycle };

    /// `velocity` [m/s] is the drive's, `rate` [1/s] makes positions comparable with velocities.
    CycleWatch(double velocity, double rate, int closed) : velocity_(velocity), rate_(rate), closed_(closed) {}

    /// The contact enters a state.
    Finding note(double time, ContactMode mode, const Lanes& s);

    /// Of the cycle found.
    const LimitCycle& cycle() const { return cycle_; }

    /// [s] when the last whole period began.
    double period_begin() const { return period_begin_; }

private:
    static constexpr int longest = 64;  // events of a period

    struct Event {
        double time = 0.0;
        ContactMode mode = ContactMode::open;
        Lanes s{};
    };

    double distance(const Event& a, const Event& b) const;

    double velocity_, rate_;
    int closed_;
    Event anchor_, first_;
    std::array<ContactMode, longest> sequence_{};
    int since_ = 0;   // events since the anchor
    int length_ = 0;  // events of a period; 0: no return seen yet
    double first_distance_ = 0.0;
    bool has_anchor_ = false;
    double period_begin_ = 0.0;  // [s]
    LimitCycle cycle_;
};

/// The changes of state a recorder has been told of lately.
class RecentChanges {
public:
    void add(const record::ContactInterval& interval) { ring_[count_++ % size] = interval; }

    /// Those from a time on, in order.
    std::vector<record::ContactInterval> since(double time) const;

private:
    static constexpr std::size_t size = 256;
    std::array<record::ContactInterval, size> ring_;
    std::size_t count_ = 0;
};

/// Repeats the changes of one period, of some duration, until the run's end or until it is to stop: a long run repeats
/// a short period a thousand million times.
void repeat_period(const std::vector<record::ContactInterval>& period, double duration, double end,
                   record::Recorder& recorder, const std::stop_token& stop);

}  // namespace stridor::integration
