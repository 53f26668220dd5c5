#pragma once

#include "stridor/integration/exact/account.hpp"
#include "stridor/integration/exact/contact_transition.hpp"
#include "stridor/integration/exact/limit_cycle.hpp"
#include "stridor/integration/exact/silence.hpp"
#include "stridor/integration/rules/contact_mode_of.hpp"
#include "stridor/integration/run/end_state.hpp"
#include "stridor/integration/run/event_loop.hpp"
#include "stridor/integration/run/motion.hpp"
#include "stridor/record/recorder.hpp"

#include <algorithm>
#include <cstddef>
#include <stop_token>
#include <vector>

namespace stridor::integration {

/// What the exact engine writes down: changes of state, integrals by span, samples that are due, where the energy went.
///
/// Time is only told, never kept here. A state that lasted no time was never there.
class Logbook {
public:
    /// `knots` [s] are instants after 0 at which the engine must stop for reasons of its own, rising.
    Logbook(record::Recorder& recorder, const Flows& flows, std::vector<double> knots);

    /// Why the engine must look up at an instant.
    enum class Stop { sample, knot, end_of_span };

    bool is_full() const { return span_ == spans().size(); }  // all spans have ended
    double end() const { return end_; }                       // [s] of the run
    bool has_samples() const { return samples_.has_next(); }
    Stop next_stop() const;
    double next_stop_time() const;  // [s]
    void pass_sample() { ++samples_.next; }
    void pass_knot() { ++knot_; }

    Sums& full(ContactMode mode) { return account_.full[static_cast<int>(mode)]; }
    Sums& part(ContactMode mode) { return account_.part[static_cast<int>(mode)]; }

    /// Notes that the contact enters a state.
    void enter(const Transition& next, double now);

    /// Notes that the contact carries this normal force [N] where its state, or a span, ends.
    void press(double normal_force) { account_.largest_force = std::max(account_.largest_force, normal_force); }

    /// Hands the integrals of the span that ends here to the recorder.
    void end_span();

    /// Passes what has been written down; the recorder of a run that goes on is told the present state.
    void pass(Memory& pass);

    /// Clears the account, keeping its integrals for the span and the balance.
    void bank();

    /// Writes down the last state, if it has lasted.
    void close(double now);

    /// Losses and the drive's work so far; what is stored and the preload's work are left to the caller.
    EnergyBalance losses() const;

    /// Integrals since the account was last cleared.
    Totals since_banked() const { return totals(flows_, account_); }

    /// Fills the rest of the run with decaying slip from state `s` at `now` on.
    void fill_with_silence(const Sliding& sliding, const Kernel& loops, Lanes s, double now);

    /// Fills the rest of the run with repetitions of the period that ended at `now` and began at `begin`; less of it
    /// after a stop request.
    void fill_with_cycle(const Totals& period, double begin, double now, const std::stop_token& stop);

private:
    const std::vector<record::Span>& spans() const { return recorder_.schedule().spans; }
    void tell();
    void vibrate();

    record::Recorder& recorder_;
    const Flows& flows_;
    std::vector<double> knots_;  // [s]
    double end_ = 0.0;           // [s]
    std::size_t span_ = 0;
    std::size_t knot_ = 0;
    SampleTimes samples_;

    Account account_;
    Totals banked_;         // of this span
    EnergyBalance losses_;  // impacts, and the spans that have ended

    record::ContactInterval pending_;  // the state since the last event
    bool has_pending_ = false;
    bool has_told_ = false;
    record::ContactInterval told_;
    RecentChanges recent_;
};

}  // namespace stridor::integration
