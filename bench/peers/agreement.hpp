#pragma once

#include "stridor/record/tally.hpp"

namespace stridor::peers {

/// How a motion parts from the reference.
enum class Parting {
    never,
    drift,  // the same changes of state go on, at other times
    event,  // the next changes of state are others: one was missed, or found where there is none
};

/// How far a history tells the same story as the reference.
///
/// A change of state is met if the other history enters the same state within the tolerance. What lies between two met
/// changes is common as well if both histories go through the same states there, somewhat late; else those of the
/// reference are missed and those of the other are extra. The two have parted at the last met change before
/// `lost_changes` of the reference in a row that are not met.
struct Agreement {
    double until = 0.0;  // [s] the last met change, or the end
    int common = 0;      // [1] changes of state up to `until`
    int missed = 0;      // [1] changes of the reference that the other has not
    int extra = 0;       // [1] changes of the other that the reference has not
    Parting parting = Parting::never;
};

inline constexpr int lost_changes = 6;
inline constexpr double same_time = 1e-6;  // [s]

Agreement agreement(const record::ContactHistory& reference, const record::ContactHistory& found,
                    double tolerance = same_time);

/// Largest difference of the rates (slip, stick, separation) [1] between 0 and `until` [s].
double rate_error(const record::ContactHistory& reference, const record::ContactHistory& found, double until);

}  // namespace stridor::peers
