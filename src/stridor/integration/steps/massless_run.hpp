#pragma once

#include "stridor/integration/modal/modal_account.hpp"
#include "stridor/integration/run/imposed_motion.hpp"
#include "stridor/integration/steps/contact_rows.hpp"
#include "stridor/integration/steps/free_propagation.hpp"
#include "stridor/integration/steps/massless.hpp"
#include "stridor/integration/steps/step_contacts.hpp"

#include <stop_token>
#include <vector>

namespace stridor::integration {

/// One run of the time stepping without inertia at the contacts: from step to step (massless.cpp), and written down
/// (massless_account.cpp).
class MasslessRun {
public:
    MasslessRun(const model::Structure& structure, MasslessStructure massless, const parameters::Drive& drive,
                const InitialState& start, double step, record::Recorder& recorder);

    Outcome run(const std::stop_token& stop);
    EnergyBalance energy() const;

    // for `run_spans` and `step_to`
    long steps() const { return n_; }
    double time() const { return static_cast<double>(n_) * step_; }
    void begin_span();
    void end_span(std::size_t span, long steps, double length);
    bool advance();
    void watch();
    void sample();
    void widen_travel() { widen(travel_, q_, v_); }
    bool is_finite() const { return integration::is_finite(q_, v_); }
    Outcome without_forces() const { return {Reason::no_forces, time()}; }
    static constexpr long watch_every() { return 1; }
    static constexpr bool samples_behind() { return false; }

private:
    bool settle(double surface_travel);
    void shake();
    void push_by_half();
    void note(double surface_travel);
    void press(const std::vector<double>& forces);
    void tell(std::size_t contact);
    double stored() const;
    double load_place() const;
    double shaken_place() const;

    const model::Structure& whole_;
    MasslessStructure massless_;
    double step_;  // [s]
    ImposedMotion motion_;
    parameters::Drive drive_;
    record::Recorder& recorder_;
    FreePropagation propagation_;
    ContactRows rows_;
    StepContacts contacts_;
    Eigen::MatrixXd channels_moved_;       // [m/N] shape [channel][row]
    Eigen::VectorXd channels_shaken_;      // [m/N] shape [channel]
    std::vector<double> q_, v_;            // shape [mode], filled up
    std::vector<double> push_;             // likewise
    std::vector<double> shaken_;           // [1/√kg] of an imposed force, shape [mode], filled up; empty: none
    std::vector<std::size_t> all_;         // rows
    std::vector<char> touches_;            // all of them, shape [contact]
    std::vector<ContactMode> set_;         // of the instant before
    std::vector<double> place_, free_;     // [m] gaps and tangential places, shape [row]
    std::vector<double> free_rates_;       // [m/s] of the step without contact forces, likewise
    std::vector<double> forces_, before_;  // [N] at this instant and the one before, likewise
    std::vector<double> share_;            // [1] of V along a tangent, likewise
    double force_ = 0.0;                   // [N] imposed at this instant
    double force_before_ = 0.0;            // [N] at the one before
    double loads_place_ = 0.0;             // [J] work of the load on what has no inertia, up to now
    double shakers_place_ = 0.0;           // [m] of the imposed force's point, without inertia
    double dashpot_power_ = 0.0;           // [W]
    long n_ = 0;                           // number of the step
    long watched_ = 0;
    std::vector<record::Vibration> vibration_;  // of the span so far, shape [channel]
    std::vector<record::Load> load_;            // likewise, shape [contact]
    EnergyBalance work_;
    double initial_energy_ = 0.0;  // [J]
    ModalTravel travel_;
};

}  // namespace stridor::integration
