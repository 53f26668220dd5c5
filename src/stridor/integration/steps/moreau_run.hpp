#pragma once

#include "stridor/integration/modal/modal_account.hpp"
#include "stridor/integration/run/imposed_motion.hpp"
#include "stridor/integration/steps/contact_rows.hpp"
#include "stridor/integration/steps/exchange_tableau.hpp"
#include "stridor/integration/steps/free_propagation.hpp"
#include "stridor/integration/steps/moreau.hpp"
#include "stridor/integration/steps/step_contacts.hpp"

#include <stop_token>
#include <vector>

namespace stridor::integration {

/// One run of Moreau's time stepping: what takes the motion from step to step (moreau.cpp) and writes it down
/// (moreau_account.cpp).
class MoreauRun {
public:
    MoreauRun(const model::Structure& structure, ModalStructure modal, const parameters::Drive& drive,
              const InitialState& start, double step, record::Recorder& recorder);

    Outcome run(const std::stop_token& stop);
    EnergyBalance energy() const;

    /// What is known of each contact that sticks, at the end of the run over a surface of constant velocity.
    std::vector<record::Outlook> outlooks(const Outcome& outcome) const;

    /// Contacts that friction presses without end, if the run ended so.
    const std::vector<std::size_t>& pressed() const { return pressed_; }

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
    Outcome without_forces();
    long watch_every() const { return watch_every_; }
    static constexpr bool samples_behind() { return true; }  // its forces are known then

private:
    void shake();
    void find_touching();
    void ask_for(std::size_t contact);
    void subtract_surface(double velocity, std::vector<double>& rates) const;
    void find_free_rates(double surface_velocity);
    void project();
    void note(double start_velocity, double end_velocity);
    void press();
    void tell(std::size_t contact);
    double elastic() const;

    const model::Structure& whole_;
    ModalStructure structure_;
    double step_;  // [s]
    ImposedMotion motion_;
    parameters::Drive drive_;
    record::Recorder& recorder_;
    FreePropagation propagation_;
    ContactRows rows_;
    StepContacts contacts_;
    ExchangeTableau closing_;    // displacements along the normals that close gaps
    std::vector<double> q_, v_;  // shape [mode], filled up
    std::vector<double> q_before_, v_before_;
    std::vector<double> push_;                  // [N/√kg] of the contacts, shape [mode], filled up
    std::vector<double> scratch_;               // likewise
    std::vector<ContactMode> set_;              // of the step before
    std::vector<std::size_t> pressed_;          // contacts that friction presses without end, where it ended so
    bool has_impact_ = false;                   // the step before closed a contact: its forces are impulses
    std::vector<char> touches_, touched_;       // in this step and the one before, shape [contact]
    std::vector<double> rates_, free_rates_;    // [m/s] g' and w at the step's begin, and its free end, shape [row]
    std::vector<double> products_, forces_;     // shape [row]
    std::vector<double> share_;                 // [1] of V along a tangent, shape [row]
    std::vector<double> shaken_;                // [1/√kg] of an imposed force, shape [mode], filled up; empty: none
    double force_ = 0.0;                        // [N] imposed in the step
    std::vector<std::size_t> which_;            // rows
    double surface_velocity_ = 0.0;             // [m/s] at the step's begin
    double dashpot_power_ = 0.0;                // [W] likewise
    long n_ = 0;                                // number of the step
    long watch_every_;                          // steps
    long watched_ = 0;                          // velocities that were added to this span's
    std::vector<record::Vibration> vibration_;  // of the span so far, shape [channel]
    std::vector<record::Load> load_;            // likewise, shape [contact]
    EnergyBalance work_;
    double initial_energy_ = 0.0;  // [J]
    ModalTravel travel_;
};

}  // namespace stridor::integration
