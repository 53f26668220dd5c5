#pragma once

#include "stridor/record/tally.hpp"

#include <array>
#include <cstddef>

namespace stridor::support {

/// Shares of time in each state (slip, stick, separation) over whole periods, and the mean period.
struct Periods {
    std::array<double, model::contact_states> shares{};  // [1]
    double period = 0.0;                                 // [s]
    int count = 0;                                       // [1] number of periods
};

/// Counts from one entry into a state to another entry into it, from `from` [s] on: no part of a period is counted.
inline Periods whole_periods(const record::ContactHistory& history, model::ContactState state, double from) {
    Periods result;
    double first = -1.0;
    std::array<double, model::contact_states> since_entry{};
    for (const record::ContactInterval& interval : history) {
        const bool begins_period = interval.state == state && interval.from >= from;
        if (begins_period && first < 0.0) first = interval.from;
        if (begins_period && interval.from > first) {
            for (std::size_t k = 0; k < since_entry.size(); ++k)
                result.shares[k] += since_entry[k];
            ++result.count;
            result.period = interval.from - first;
            since_entry = {};
        }
        if (first >= 0.0) since_entry[model::index_of(interval.state)] += interval.to - interval.from;
    }
    for (double& share : result.shares)
        share /= result.period;
    result.period /= result.count;
    return result;
}

}  // namespace stridor::support
