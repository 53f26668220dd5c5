#pragma once

#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/case.hpp"

#include <gtest/gtest.h>

#include <ostream>
#include <stop_token>
#include <string>
#include <utility>

namespace stridor::contract {

/// An engine as the contract suite sees it. The suite has cases of one joint on a plate; every run goes through
/// `integration::simulate`, the one door to all engines.
struct EngineUnderTest {
    std::string name;
    void (*choose)(parameters::Case&);  // sets the engine and settings that make 20 ms of motion cheap
    double energy_tolerance = 0.0;      // [1] largest relative residual of the energy balance, derived
    double unstable_step = 0.0;         // [s] a time step no run may be made with; 0: no step is too long
    parameters::Case (*as_solved)(parameters::Case) = nullptr;  // the joint as this engine takes it; null: as it is
    double force_share = 0.0;   // [1] of the preload, to which its forces at rest are known; 0: to rounding
    double change_moves = 0.0;  // [s] so far changes of state may move where judged spans end elsewhere; 0: not a bit
    bool starts_stuck = true;   // can a run start with the contact stuck to what moves?
};

/// Lets the contact of a case rub by Stribeck's curve.
inline void rub_by_stribeck(parameters::Case& c) {
    c.contact().friction = parameters::FrictionKind::stribeck;
    c.contact().static_friction = c.contact().kinetic_friction + 0.05;  // with which a slip begins
    c.contact().stribeck_velocity = 1.0;                                // it falls by 0.05 s/m at most
    c.contact().viscous_friction = 0.01;
}

/// Lets the static friction of a case's contact grow while it sticks: by some hundredths in a millisecond.
inline void grow_by_rest(parameters::Case& c) {
    c.contact().rest = parameters::RestKind::kato;
    c.contact().rest_growth = 0.2;
    c.contact().rest_time = 0.02;
}

inline void PrintTo(const EngineUnderTest& engine, std::ostream* out) {
    *out << engine.name;
}

/// What every engine promises. Instantiate it with INSTANTIATE_TEST_SUITE_P for each engine.
class EngineContract : public testing::TestWithParam<EngineUnderTest> {
protected:
    /// Returns a case of one joint as the engine takes it.
    static parameters::Case solved(parameters::Case c) {
        return GetParam().as_solved == nullptr ? c : GetParam().as_solved(std::move(c));
    }

    /// Returns the motion of a case of one joint by the engine.
    static integration::Motion moved(const parameters::Case& c, const record::Request& request = {},
                                     std::stop_token stop = {}) {
        return integration::simulate(solved(c), request, std::move(stop));
    }
};

}  // namespace stridor::contract
