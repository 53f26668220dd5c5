#pragma once

#include "stridor/integration/modal/modal_account.hpp"
#include "stridor/integration/rules/contact_mode_of.hpp"
#include "stridor/integration/run/end_state.hpp"
#include "stridor/integration/run/imposed_motion.hpp"
#include "stridor/integration/run/initial_state.hpp"
#include "stridor/integration/run/step_loop.hpp"
#include "stridor/integration/steps/contact_rows.hpp"
#include "stridor/integration/steps/free_propagation.hpp"
#include "stridor/integration/steps/step_contacts.hpp"
#include "stridor/model/structure.hpp"
#include "stridor/record/recorder.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <stop_token>
#include <tuple>
#include <utility>
#include <vector>

namespace stridor::integration {

/// A run by time steps, whatever the inertia of its contacts: the free structure, which moves exactly, the contacts'
/// rows and forces, and what is written down. A formulation says what a contact force moves (`run_steps`).
struct StepState {
    StepState(const model::Structure& structure, ModalStructure modes, const parameters::Drive& drive,
              const InitialState& start, double step, record::Recorder& recorder);

    const model::Structure& whole;
    ModalStructure modal;  // of the modes that have inertia
    double step;           // [s]
    ImposedMotion motion;
    parameters::Drive drive;
    record::Recorder& recorder;
    FreePropagation propagation;
    ContactRows rows;
    std::vector<double> q, v;                  // shape [mode], filled up
    std::vector<double> push;                  // [N/√kg] of the contacts, likewise
    std::vector<double> shaken;                // [1/√kg] of an imposed force, likewise; empty: none
    std::vector<double> share;                 // [1] of V along a tangent, shape [row]
    std::vector<double> forces;                // [N] of the contacts, likewise
    std::vector<ContactMode> set;              // of the step before
    std::vector<std::size_t> pressed;          // contacts that friction presses without end, where it ended so
    double force = 0.0;                        // [N] imposed
    double dashpot_power = 0.0;                // [W]
    long n = 0;                                // number of the step
    long watched = 0;                          // velocities that were added to this span's
    std::vector<record::Vibration> vibration;  // of the span so far, shape [channel]
    std::vector<record::Load> load;            // likewise, shape [contact]
    EnergyBalance work;
    std::vector<record::ContactInterval> told;  // the present states, as the recorder knows them, shape [contact]
    Handover* handover = nullptr;
    bool grows = false;           // static friction of some contact, with rest
    double initial_energy = 0.0;  // [J]
    ModalTravel travel;

    const ContactRowPlan& plan() const { return rows.plan(); }
    double time() const { return static_cast<double>(n) * step; }  // [s]
    bool is_steady() const { return parameters::is_steady(drive); }

    /// Passes what is the same in all formulations.
    void pass(Memory& pass);

    /// Returns the modes of a vector that is filled up.
    Eigen::Map<const Eigen::VectorXd> modes_of(const std::vector<double>& numbers) const {
        return {numbers.data(), static_cast<Eigen::Index>(modal.modes())};
    }

    /// Notes what the contacts carry, where one of them changes its state or a span ends.
    void press(const std::vector<double>& carried);

    /// Velocities [m/s], shape [channel], stand for the steps until the next ones.
    void watch(const Eigen::VectorXd& speed);

    /// Notes what the dashpots take from the step that is done.
    void note_dashpots();

    /// Tells that a contact enters a state at the step's begin, with this slip velocity and this rate of its gap [m/s].
    void tell(std::size_t contact, ContactMode mode, double slip_velocity, double gap_velocity);

    /// Returns for how long [s] a contact has stuck at this instant, the time before the start included; 0 if it does
    /// not.
    double rested(std::size_t contact) const;

    /// Tells the forces of the next step how far the limits have grown by rest.
    void let_rest(StepContacts& contacts) const {
        for (std::size_t k = 0; grows && k < set.size(); ++k)
            contacts.grow(k, model::grown(modal.contacts[k].rest, rested(k)));
    }

    /// Accelerations [1/s²] of the modes at q and v, under `push`.
    Eigen::VectorXd acceleration(const std::vector<double>& at_q, const std::vector<double>& at_v) const;

    /// Hands a sample at a time [s] to the recorder: u [m], its rates u' and u'' of all degrees of freedom, and each
    /// contact's gap [m].
    void sample(double at, const Eigen::VectorXd& u, const Eigen::VectorXd& speed, const Eigen::VectorXd& rate,
                const std::vector<double>& gaps);

    /// Returns the balance of the run, of the energy that is stored now [J].
    EnergyBalance balance(double stored) const;
};

/// Takes a formulation through its run. It has
///
///     StepState state
///     std::optional<Outcome> begin()      finds the forces at the start, if it needs any
///     bool advance()                      one step; false if no contact forces obey the laws
///     Reason without_forces()             what that ends as
///     void press(), void watch()          tell the state what contacts carry, and velocities
///     long watch_every()                  steps between two velocities
///     void sample(), bool samples_behind  samples the step that is next, or the one that is done
///     double stored(), outlooks(outcome)  energy [J], and what is known of the time afterwards
///     pass(memory), place()               what it goes on from, and u and u' [m, m/s] of the state at this instant
///
/// Every 256 steps it looks for numbers that left double precision, and at the stop request.
template <typename Formulation>
Outcome run_steps(Formulation& run, const std::stop_token& stop) {
    constexpr long steps_between_looks = 256;
    StepState& s = run.state;
    const auto is_finite_now = [&] { return is_finite(s.q, s.v); };
    struct Spans {
        Formulation& run;
        StepState& s;

        long steps() const { return s.n; }
        void begin_span() {
            std::fill(s.vibration.begin(), s.vibration.end(), record::Vibration());
            std::fill(s.load.begin(), s.load.end(), record::Load());
            run.press();
            s.watched = 0;
        }
        void end_span(std::size_t span, long, double length) {
            if (s.watched == 0) run.watch();  // a span between two steps has the velocities of the next one
            for (record::Vibration& sum : s.vibration)
                sum.square_time *= length / static_cast<double>(s.watched);
            s.recorder.vibrate(span, length, s.vibration);
            run.press();
            s.recorder.load(span, s.load);
        }
    };
    const auto go_to = [&](long end, record::Use use, StepSamples& samples) -> std::optional<Outcome> {
        while (s.n < end) {
            const long n = s.n;
            if (n % run.watch_every() == 0 && record::is_judged(use)) run.watch();
            if (!Formulation::samples_behind && samples.take(n)) run.sample();
            if (n % steps_between_looks == 0) {
                widen(s.travel, s.q, s.v);
                if (!is_finite_now()) return Outcome{Reason::diverged, s.time()};
                if (stop.stop_requested()) return Outcome{Reason::cancelled, s.time()};
            }
            if (!run.advance()) return Outcome{run.without_forces(), s.time()};
            if (Formulation::samples_behind && samples.take(n)) run.sample();
        }
        return std::nullopt;
    };
    if (s.handover != nullptr && s.handover->from != nullptr) {
        restore(s.handover, [&](Memory& memory) { run.pass(memory); });
        for (std::size_t k = 0; k < s.told.size(); ++k)
            s.recorder.enter(s.modal.number[k], s.told[k]);
    } else if (const std::optional<Outcome> ended = run.begin()) {
        return *ended;
    }
    Spans spans{run, s};
    if (const std::optional<Outcome> ended = run_spans(spans, s.recorder, s.step, go_to)) return *ended;
    return Outcome{is_finite_now() ? Reason::completed : Reason::diverged, s.time()};
}

/// Runs a formulation to its end; once.
template <typename Formulation>
Motion motion_of(Formulation run, const std::stop_token& stop) {
    const Outcome ended = run_steps(run, stop);
    if (Handover* handover = run.state.handover; handover != nullptr && has_result(ended)) {
        std::tie(handover->to.displacement, handover->to.velocity) = run.place();
        handover->to.contacts.resize(run.state.set.size());
        handover->to.rested.resize(run.state.grows ? run.state.set.size() : 0);
        for (std::size_t k = 0; k < run.state.set.size(); ++k) {
            handover->to.contacts[run.state.modal.number[k]] = contact_of(run.state.set[k]);
            if (run.state.grows) handover->to.rested[run.state.modal.number[k]] = run.state.rested(k);
        }
        keep(handover, [&](Memory& memory) { run.pass(memory); });
    }
    const EnergyBalance balance = run.state.balance(run.stored());
    const Outcome outcome = weighed(ended, balance, std::numeric_limits<double>::infinity());
    Motion motion{outcome, balance, run.state.recorder.finish(outcome.time, run.outlooks(outcome))};
    motion.pressed = run.state.pressed;
    return motion;
}

}  // namespace stridor::integration
