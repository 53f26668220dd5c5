#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace stridor::integration {

/// A motion that has come back to where it was, within two equal sequences of events.
template <typename Event>
struct Return {
    Event first;            // where the second sequence began
    double distance = 0.0;  // [1] of its end from its beginning
    int length = 0;         // events of a sequence
};

/// Watches the events of a motion under a constant drive for a limit cycle: the same sequence of contact states twice,
/// and the same state at its end as at its beginning, closer the second time than the first.
///
/// An `Event` has a `mode`, which says what the contacts do from there on, and `distance(a, b)` [1] of two of one mode
/// is found with it.
template <typename Event>
class ReturnWatch {
public:
    /// What an event showed.
    enum class Finding { nothing, first_return, cycle };

    /// `longest` is the most events of a period.
    explicit ReturnWatch(int longest) : longest_(longest) {}

    /// Returns an event happens. `distance(a, b)` is that of two states as a share of the velocities.
    template <typename Distance>
    Finding note(Event here, const Distance& distance) {
        if (!has_anchor_) {
            anchor_ = std::move(here);
            has_anchor_ = true;
            restart();
            return Finding::nothing;
        }
        ++since_;
        return length_ == 0 ? note_first(std::move(here), distance) : note_second(std::move(here), distance);
    }

    /// Says whether the motion has returned once, and may be in a second equal period.
    bool is_returning() const { return length_ > 0; }

    /// Returns the last cycle that was found.
    const Return<Event>& found() const { return found_; }

private:
    // distance of two states up to which a motion has returned
    static constexpr double tolerance = 1e-9;
    // below this a distance is rounding and need not shrink any more
    static constexpr double rounding = 1e-12;

    void restart() {
        since_ = length_ = 0;
        sequence_.clear();
    }

    template <typename Distance>
    Finding note_first(Event here, const Distance& distance) {
        sequence_.push_back(here.mode);
        if (here.mode == anchor_.mode) {
            first_distance_ = distance(here, anchor_);
            if (first_distance_ <= tolerance) {
                first_ = std::move(here);
                length_ = since_;
                since_ = 0;
                return Finding::first_return;
            }
        }
        if (since_ == longest_) {
            anchor_ = std::move(here);
            restart();
        }
        return Finding::nothing;
    }

    template <typename Distance>
    Finding note_second(Event here, const Distance& distance) {
        const bool follows = sequence_[static_cast<std::size_t>(since_ - 1)] == here.mode;
        if (follows && since_ < length_) return Finding::nothing;
        const double second = follows ? distance(here, first_) : 1.0;
        const bool returns = follows && second <= tolerance && (second <= first_distance_ || second <= rounding);
        if (returns) found_ = {std::move(first_), second, length_};
        anchor_ = std::move(here);
        restart();
        return returns ? Finding::cycle : Finding::nothing;
    }

    int longest_;
    Event anchor_{}, first_{};
    std::vector<decltype(Event::mode)> sequence_;
    int since_ = 0;   // events since the anchor
    int length_ = 0;  // events of a period; 0: no return seen yet
    double first_distance_ = 0.0;
    bool has_anchor_ = false;
    Return<Event> found_{};
};

}  // namespace stridor::integration
