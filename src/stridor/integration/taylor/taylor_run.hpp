#pragma once

#include "stridor/integration/imposed_motion.hpp"
#include "stridor/integration/taylor/event_polynomial.hpp"
#include "stridor/integration/taylor/settling.hpp"
#include "stridor/integration/taylor/taylor.hpp"

#include <optional>
#include <stop_token>
#include <vector>

namespace stridor::integration {

/// One run of the Taylor engine: where the motion is, and what takes it from event to event (taylor.cpp) and writes it
/// down (taylor_account.cpp).
class TaylorRun {
public:
    TaylorRun(const model::Structure& structure, const parameters::Drive& drive, const InitialState& start,
              record::Recorder& recorder);

    Outcome run(const std::stop_token& stop);
    EnergyBalance energy() const;

private:
    // a function of a contact that becomes zero
    struct Firing {
        double theta = no_zero;  // [1]
        std::size_t contact = 0;
        std::size_t function = 0;
        bool is_lost = false;  // a coefficient left double precision
    };

    const std::vector<record::Span>& spans() const { return recorder_.schedule().spans; }
    SurfaceSeries surface(double time) const;
    double next_boundary() const;
    Firing first_firing(double reach);
    void account(double theta);
    void add_vibration(const Eigen::VectorXd& speed, double duration);
    void pass_samples(double theta);
    void move(double theta);
    std::optional<Outcome> fire(const Firing& firing);
    bool pass_boundary();
    void tell();
    double stored() const;
    bool is_finite() const;

    const model::Structure& whole_;
    parameters::Drive drive_;
    ImposedMotion motion_;
    record::Recorder& recorder_;
    ModalStructure structure_;
    double step_;
    TaylorBlock block_;
    Settling settling_;
    TaylorState state_;
    SurfaceSeries surface_{};
    bool is_fresh_ = true;  // the block begins at an event
    double time_ = 0.0;     // [s]
    std::size_t span_ = 0;
    std::size_t knot_ = 0;
    long sample_ = 0;
    long last_sample_ = -1;
    std::vector<ContactMode> told_;
    std::vector<record::Vibration> vibration_;
    double vibrated_from_ = 0.0;      // [s]
    std::vector<record::Load> load_;  // of the span so far, shape [contact]
    EnergyBalance work_;              // dashpots, friction, drive
    double initial_energy_ = 0.0;
    std::vector<double> initial_q_;
    std::vector<double> most_q_, most_v_;  // largest that they have been
    double window_begin_ = 0.0;            // [s] of the search for pile-ups
    int window_events_ = 0;
    std::vector<double> scratch_;
};

}  // namespace stridor::integration
