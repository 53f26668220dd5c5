#pragma once

#include "stridor/integration/modal/modal_structure.hpp"
#include "stridor/integration/rules/set_search.hpp"
#include "stridor/integration/steps/exchange_tableau.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace stridor::integration {

/// The forces of all touching contacts over one time step, constant in it:
///
///     (g', w) at its end = (g', w) without them + W_h (N, T);   N >= 0, g' >= 0, one of them 0;
///     w = 0 with |T| <= limit N, or T = ratio N against w
///
/// Where a contact has two tangents w and T are vectors in the plane of contact and the cone of friction is circular:
/// the direction of each slip follows from Newton's method over the angles of all (step_directions.cpp), to rounding.
///
/// Where friction changes with the slip velocity the ratio of each slip follows likewise from Newton's method: it is
/// that of the velocity at the step's end. Where it falls so fast that several may be, one slip after the other takes
/// the fastest (`ratio_of_fastest_slip`), until none changes.
///
/// Begins with the states of the step before, and changes the contact that is farthest from its law until none is. A
/// limit that broke is that of the slip until the step has ended. The solved system of a set of states is kept and
/// exchanged contact by contact (`ExchangeTableau`): no sweeps, whatever couples the contacts.
class StepContacts {
public:
    /// `response` is W_h [m/s/N] as `FreePropagation::response`, `set` the states to begin with.
    StepContacts(const ModalStructure& structure, Eigen::MatrixXd response, const std::vector<ContactMode>& set);

    /// Finds forces and states. `free_rates` [m/s]: g' and w of each contact at the end of the step without contact
    /// forces, shape [2 contact]; `touches`: who takes part, shape [contact]; a contact that does not is open. Returns
    /// false where no set of states obeys all laws, or friction presses a contact without end (Painleve).
    bool solve(const std::vector<double>& free_rates, const std::vector<char>& touches);

    /// Returns the contacts that friction presses without end, if a step is without forces because of them.
    std::vector<std::size_t> pressed(const std::vector<char>& touches) const;

    /// Sets what rest has added to the contact's limit [1] from now on.
    void grow(std::size_t contact, double by) { grown_[contact] = by; }

    const std::vector<ContactMode>& set() const { return set_; }
    double force(std::size_t row) const { return force_[row]; }  // [N] along a normal or tangent
    double rate(std::size_t row) const { return rate_[row]; }    // [m/s] likewise, at its end: of the gap, or of slip
    /// Returns the slip velocity at its end [m/s]: signed, or of two tangents its size.
    double slip_velocity(std::size_t contact) const { return tried_[contact].slip_velocity; }
    /// Passes what a step leaves to the next one.
    void pass(Memory& pass) {
        tableau_.pass(pass);
        pass(set_), pass(friction_), pass(direction_), pass(force_), pass(rate_), pass(is_singular_);
        pass(changes_), pass(restarts_);
    }
    long changes() const { return changes_; }    // [1] of states so far, all trials
    long restarts() const { return restarts_; }  // [1] searches that began again with all contacts stuck

private:
    enum class Search { found, endless, singular };

    void change(std::size_t contact, ContactMode mode);
    void take_up(std::size_t row);
    void set_friction(std::size_t row, double ratio);
    void set_directions(std::size_t contact);
    bool settle_directions();
    std::vector<std::size_t> turning();
    std::vector<std::size_t> changing_slips() const;
    bool settle_ratios();
    bool is_gentle_step(const std::vector<std::size_t>& slips) const;
    bool settle_together(const std::vector<std::size_t>& slips);
    bool settle_one_by_one(const std::vector<std::size_t>& slips);
    bool is_pressed_by(std::size_t contact, ContactMode mode) const;
    bool has_painleve(std::size_t contact, model::Slip way) const;
    void rebuild();
    void look(std::size_t contact);
    void look_at_plane(std::size_t contact);
    ContactMode begin_slip(std::size_t contact);
    void forget(std::size_t contact);
    Search search(const std::vector<double>& free_rates, const std::vector<char>& touches);

    const ModalStructure& structure_;
    ContactRowPlan plan_;
    Eigen::MatrixXd response_;
    ExchangeTableau tableau_;
    std::vector<ContactMode> set_;
    std::vector<double> friction_;                  // [1] share of N that T has beside what follows, shape [row]
    std::vector<std::array<double, 2>> direction_;  // [1] of a slip of two tangents, length one, shape [contact]
    std::vector<TriedContact> tried_;               // shape [contact]
    std::vector<double> grown_;                     // [1] of the limits by rest, shape [contact]
    std::vector<double> force_, rate_;              // of the trial, shape [row]
    bool is_state_wise_;                            // all laws of friction
    std::vector<std::array<bool, 2>> pressed_;      // Painleve: by a slip along the tangent, shape [contact][slip]
    double speed_ = 0.0;                            // [m/s] what directions are held against
    bool is_singular_ = false;
    long changes_ = 0;
    long restarts_ = 0;
};

}  // namespace stridor::integration
