#pragma once

#include "stridor/integration/modal/modal_account.hpp"
#include "stridor/integration/proofs/lasting_set.hpp"
#include "stridor/integration/run/event_loop.hpp"
#include "stridor/integration/run/imposed_motion.hpp"
#include "stridor/integration/run/return_watch.hpp"
#include "stridor/integration/series/event_polynomial.hpp"
#include "stridor/integration/series/settling.hpp"
#include "stridor/integration/series/taylor.hpp"

#include <optional>
#include <stop_token>
#include <vector>

namespace stridor::integration {

/// One run of the Taylor engine: where the motion is, and what takes it from event to event (taylor.cpp), writes it
/// down (taylor_account.cpp) and ends it early (taylor_endings.cpp).
class TaylorRun {
public:
    TaylorRun(const model::Structure& structure, const parameters::Drive& drive, const InitialState& start,
              const Taylor& settings, record::Recorder& recorder);

    Motion run(const std::stop_token& stop);

private:
    // beside the event functions of a contact: that of its speed of creep
    static constexpr std::size_t creep_function = most_functions;
    static constexpr std::size_t no_contact = 0xFFFFFFFF;

    // a function of a contact that becomes zero
    struct Firing {
        double theta = no_zero;  // [1]
        std::size_t contact = 0;
        std::size_t function = 0;
        bool is_lost = false;  // a coefficient left double precision
    };

    // what a stretch of time leaves behind
    struct Sums {
        std::vector<record::Vibration> vibration;  // shape [channel]
        std::vector<record::Load> load;            // shape [contact]
    };

    // the state at an event, to which the motion may return
    struct Event {
        double time = 0.0;  // [s]
        std::vector<ContactMode> mode;
        std::vector<double> q, v;
        std::vector<double> grown;  // [1] of the limits by rest, shape [contact]; empty: nothing
    };

    Outcome advance(const std::stop_token& stop);
    EnergyBalance energy() const;
    const std::vector<record::Span>& spans() const { return recorder_.schedule().spans; }
    bool has_friction_states() const;
    bool counts_creep() const;
    SurfaceSeries surface(double time) const;
    double next_boundary() const;
    Firing first_firing(double reach);
    double growing_limit(std::size_t contact, std::size_t function, int dropped, double reach) const;
    bool is_creeping(std::size_t contact) const;
    double creep_ends(std::size_t contact, double reach) const;
    ContactMode shown_mode(std::size_t contact) const;
    void let_rest();
    void account(double theta);
    void add_normal_impulse(double theta, Sums& sums) const;
    void press(double theta);
    void add_impacts();
    void pass_samples(double theta);
    void move(double theta);
    Outcome without_forces(Settled how) const;
    std::optional<Outcome> fire(const Firing& firing);
    bool pass_boundary();
    void end_span();
    void tell();
    void pass(Memory& pass);
    void hand_over();
    Outcome go_on(const std::stop_token& stop);
    bool is_linear() const;
    bool watch_for_silence();
    void fill_with_silence(LastingSet& set);
    bool watch_for_cycle(const std::stop_token& stop);
    void fill_with_cycle(double duration, const std::stop_token& stop);
    double distance(const Event& a, const Event& b) const;
    std::vector<record::Outlook> outlooks(const Outcome& outcome) const;

    const model::Structure& whole_;
    ImposedMotion drive_;
    record::Recorder& recorder_;
    ModalStructure structure_;
    double step_;
    TaylorBlock block_;
    Settling settling_;
    TaylorState state_;
    std::vector<double> stuck_since_;  // [s] when each stick began, shape [contact]; empty: rest changes nothing
    SurfaceSeries surface_{};
    bool is_fresh_ = true;  // the block begins at an event
    double time_ = 0.0;     // [s]
    std::size_t span_ = 0;
    std::size_t corner_ = 0;
    SampleTimes samples_;
    std::vector<ContactMode> told_;                   // one that creeps as one that sticks
    std::size_t crossed_ = no_contact;                // its speed is that of creep where the block begins
    std::vector<record::ContactInterval> intervals_;  // the present states, as the recorder knows them, shape [contact]
    long blocks_ = 1;
    Handover* handover_ = nullptr;
    Sums sums_;               // of the span so far
    double sums_from_ = 0.0;  // [s]
    Sums period_;             // of the period that is being measured
    bool is_measuring_ = false;
    std::vector<ContactChange> period_changes_;  // in it
    bool is_steady_ = false;                     // the drive, so that the future can be known
    bool may_end_early_ = false;
    ReturnWatch<Event> watch_;
    long blocks_since_event_ = 0;
    std::optional<Silence> silence_;
    std::optional<LimitCycle> cycle_;
    EnergyBalance final_balance_;  // of a run that ended early, up to there
    EnergyBalance work_;           // dashpots, friction, drive
    double initial_energy_ = 0.0;
    ModalTravel travel_;
    PileUp pile_up_;
    double crowd_begin_ = 0.0;  // [s] of the events that are counted together
    std::size_t crowd_events_ = 0;
    std::vector<double> scratch_;
    std::vector<Lanes> velocities_;        // [1/s] shape [place][mode]
    std::vector<BlockPlaces> tangential_;  // [N] shape [contact]
    Eigen::MatrixXd speeds_;               // [m/s] shape [channel][place]
};

}  // namespace stridor::integration
