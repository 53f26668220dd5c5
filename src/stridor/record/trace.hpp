#pragma once

#include "stridor/model/contact_state.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace stridor::record {

/// Sampled motion, all vectors of shape [sample], those per degree of freedom of shape [dof][sample].
struct Trace {
    std::vector<double> time;                       // [s]
    std::vector<std::vector<double>> displacement;  // [m] u
    std::vector<std::vector<double>> velocity;      // [m/s] u'
    std::vector<std::vector<double>> acceleration;  // [m/s^2] u''
    std::vector<double> surface_velocity;           // [m/s] V
    std::vector<double> normal_force;               // [N] N on mass 1
    std::vector<double> friction_force;             // [N] T on mass 1
    std::vector<double> gap;                        // [m] g
    std::vector<model::ContactState> state;
};

/// Most samples that a taker is handed at a time.
inline constexpr std::size_t trace_block = 4096;

/// When to sample a trace. Engines sample at their own steps nearest to the asked ones.
struct TraceRequest {
    double from = 0.0;      // [s]
    double to = 0.0;        // [s]
    double interval = 0.0;  // [s] between samples; 0: no trace
    // is handed the trace in blocks, in order, while the run goes on; the record then keeps none of it
    std::function<void(const Trace&)> taker{};
};

}  // namespace stridor::record
