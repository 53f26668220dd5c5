#pragma once

#include "stridor/model/contact_state.hpp"

#include <vector>

namespace stridor::record {

/// One stay of a contact in one state, and how it was entered.
struct ContactInterval {
    model::ContactState state = model::ContactState::slip;
    double from = 0.0;           // [s]
    double to = 0.0;             // [s]
    double slip_velocity = 0.0;  // [m/s] w when the state began
    double gap_velocity = 0.0;   // [m/s] g' when the state began; negative: the surfaces met (an impact)
};

/// The whole life of one contact: states one after the other, without gaps, neighbours different.
using ContactHistory = std::vector<ContactInterval>;

}  // namespace stridor::record
