#pragma once

#include "stridor/integration/energy_balance.hpp"
#include "stridor/integration/outcome.hpp"
#include "stridor/record/recorder.hpp"

namespace stridor::integration {

/// A run: how it ended, its energy balance and what was kept of it.
struct Motion {
    Outcome outcome;
    EnergyBalance energy;
    record::Record record;
};

}  // namespace stridor::integration
