#pragma once

#include "stridor/integration/exact/exact.hpp"
#include "stridor/integration/exact/flow.hpp"
#include "stridor/integration/exact/logbook.hpp"
#include "stridor/integration/run/event_loop.hpp"
#include "stridor/integration/run/imposed_motion.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stop_token>

namespace stridor::integration {

/// One run of the exact engine: where the motion is, and what takes it from event to event (exact.cpp).
template <int dofs>
class ExactRun {
public:
    ExactRun(const model::Structure& structure, const model::ContactPoint& contact, const parameters::Drive& drive,
             const Start& start, const Exact& settings, SizedFlows<dofs>& shared, record::Recorder& recorder,
             std::stop_token stop);

    /// Runs it to its end; once.
    Motion run();

private:
    static constexpr int closed = dofs - 1;
    static constexpr int x_speed = velocity_lane(closed, 0);
    static constexpr int F = load_lane(closed);
    static constexpr int V = surface_lane(closed);
    static constexpr int G = gap_lane(closed);
    using Vector = typename model::SizedStructure<dofs>::Vector;
    using Matrix = typename model::SizedStructure<dofs>::Matrix;

    // what ended a step: an event function, or none
    struct Crossing {
        double tau = no_crossing;  // [1]
        int test = -1;
    };

    // what lies within a step besides events: a change of the drive, or a request to stop
    enum class Boundary { none, knot, stop_request };

    struct Position {
        Vector displacement;  // [m] u
        Vector velocity;      // [m/s] u'
    };

    const Flow& flow() const { return flows_.flow[static_cast<int>(mode_)]; }
    double time() const { return origin_ + static_cast<double>(count_) * flow().step; }

    void begin(const Start& start);
    Outcome advance();
    SurfaceNumbers surface(double time) const;
    void widen_reach() {
        Lanes& most = mode_ == ContactMode::open ? open_reach_ : closed_reach_;
        for (int i = 0; i < lanes; ++i)
            most.at[i] = std::max(most.at[i], std::abs(s_.at[i]));
    }
    Crossing first_event() const;
    void glide();
    void step();
    Boundary pass_boundaries(double& from, double& reach, Crossing& crossing);
    void turn_knot(double time);
    void sample(double tau, double time);
    void press(double tau);
    void enter(const Transition& next);
    bool is_finite() const;

    // exact_energy.cpp
    Position position(const Lanes& s, ContactMode mode) const;
    Position seen(const Lanes& s, ContactMode mode, const Matrix& basis) const;
    double stored(const Position& here) const;
    double held() const;
    EnergyBalance energy() const;
    record::Outlook outlook(const Outcome& outcome) const;

    void watch_for_silence();
    void watch_for_cycle();
    void pass(Memory& pass);
    void hand_over();

    const model::Structure& whole_;
    const model::ContactPoint& contact_;
    model::SizedStructure<dofs> structure_;  // the same
    ContactCoordinates<dofs> coordinates_;
    const Kernel& kernel_;
    ImposedMotion drive_;
    const Flows& flows_;
    Exact settings_;
    record::Recorder& recorder_;
    std::stop_token stop_;
    Logbook book_;
    Handover* handover_ = nullptr;
    EngineMemory last_step_{};  // the state at the beginning of the step in which the run ends

    ContactMode mode_ = ContactMode::stick;
    Lanes s_{};
    double origin_ = 0.0;   // [s] when the steps were last counted from nought
    long count_ = 0;        // [1] steps since
    int multiplicity_ = 0;  // [1] of the root at which the last event function begins, 0 after the first step

    double initial_energy_ = 0.0;  // [J]
    Vector initial_displacement_;  // [m]
    Lanes closed_reach_{};         // the largest that each number of the state has been, by kind of state
    Lanes open_reach_{};

    PileUp pile_up_;
    std::optional<Reason> lost_;  // why the search for events gave up

    bool may_end_early_ = false;
    std::optional<Sliding> sliding_;
    ContactMode sliding_mode_ = ContactMode::slip_forward;
    CycleWatch watch_;
    bool has_returned_ = false;  // the account holds the time since the watch's first return
    std::optional<Silence> silence_;
    std::optional<LimitCycle> cycle_;
    EnergyBalance balance_;  // at the proof, if there is one
};

}  // namespace stridor::integration
