// The second rule of settling.hpp: contact states whose forces and accelerations obey all laws.

#include "stridor/integration/rules/contact_mode_of.hpp"
#include "stridor/integration/rules/set_search.hpp"
#include "stridor/integration/series/settling.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace stridor::integration {

namespace {

// the first coefficient above `zero`; none if all are below
struct Leading {
    int order = most_dropped + 1;
    double value = 0.0;
};

Leading leading(const BlockSeries& c, const FunctionZero& zero) {
    for (int k = 0; k <= most_dropped; ++k)
        if (std::abs(c[static_cast<std::size_t>(k)]) > (k < zero.of_state ? zero.first : zero.later))
            return {k, c[static_cast<std::size_t>(k)]};
    return {};
}

double largest(const BlockSeries& c) {
    double most = 0.0;
    for (int k = 0; k <= settling_order; ++k)
        most = std::max(most, std::abs(c[static_cast<std::size_t>(k)]));
    return most;
}

// the largest of a gap's acceleration, told as the gap's coefficient c_2: a normal force N with the coefficients n_m
// moves the gap by h² W_nn n_m/((m + 1)(m + 2)) in c_(m+2)
double largest_acceleration(const BlockSeries& gap) {
    double most = 0.0;
    for (int k = 2; k <= settling_order; ++k)
        most = std::max(most, 0.5 * k * (k - 1) * std::abs(gap[static_cast<std::size_t>(k)]));
    return most;
}

}  // namespace

struct Settling::Violation {
    int order = most_dropped + 1;
    double size = 0.0;  // [1]
    std::size_t contact = 0;
    std::size_t function = 0;
};

FunctionZero Settling::zero_of(const TaylorBlock& block, const TaylorState& state, std::size_t contact,
                               std::size_t function, const BlockSeries& c) const {
    const ModalContact& law = structure_.contacts[contact];
    const ContactMode mode = state.set[contact];
    if (mode == ContactMode::open) {
        // gap and rate come from the state, what follows from accelerations: zero where the force that would hold the
        // contact is, or one that lifts obeys no set of states
        const double zero = gap_zero(law, state, block.step());
        return {2, zero,
                zero + term_rounding * block.gap_change_scale(contact) + function_rounding * largest_acceleration(c)};
    }
    const double zero = function_rounding * largest(c);
    if (!is_slip(mode) || function == 0) return {0, 0.0, zero + term_rounding * block.force_scale(contact)};
    // a slip comes from the state, however fast the set changes it
    return {1, function_rounding * block.velocity_scale(contact) + term_rounding * block.free_change_scale(contact),
            slip_per_friction * zero +
                term_rounding * (block.velocity_scale(contact) + block.velocity_change_scale(contact))};
}

// compares a contact's functions with the worst so far; notes their orders
void Settling::look(const TaylorState& state, std::size_t contact, Violation& worst) {
    const ContactMode mode = state.set[contact];
    for (std::size_t f = 0; f < event_functions(mode); ++f) {
        BlockSeries c = event_series(structure_, block_, contact, mode, f, broken_[contact]);
        const bool grows = mode == ContactMode::stick && f > 0 && !state.rested.empty() && !broken_[contact];
        if (grows)
            add_growth(structure_.contacts[contact], block_, block_.normal_force(contact), state.rested[contact], {},
                       c);
        const double most = largest(c);
        // below the surface by rounding, it touches: its rate says whether it closes
        if (mode == ContactMode::open) c[0] = std::max(0.0, c[0]);
        const Leading first = leading(c, zero_of(block_, state, contact, f, c));
        orders_[contact][f] = first.order;
        if (!(first.value < 0.0)) continue;
        const double size = most > 0.0 ? -first.value / most : 0.0;
        if (first.order < worst.order || (first.order == worst.order && size > worst.size))
            worst = {first.order, size, contact, f};
    }
}

// would the contact, which slips, obey the law of a stick beside what the others do?
bool Settling::could_stick(TaylorState& state, const SurfaceSeries& surface, std::size_t contact) {
    const ContactMode slip = std::exchange(state.set[contact], ContactMode::stick);
    broken_[contact] = false;
    Violation worst;
    const bool is_determined = block_.choose(state.set);
    if (is_determined) {
        block_.expand(state.q, state.v, state.friction_states, surface, settling_order);
        look(state, contact, worst);
    }
    state.set[contact] = slip;
    broken_[contact] = true;
    return is_determined && worst.order > most_dropped;
}

// a slip that has begun before others changed: it sticks if it can now; returns whether one does
bool Settling::stick_again(TaylorState& state, const SurfaceSeries& surface, std::vector<bool>& has_tried) {
    for (std::size_t k = 0; k < state.set.size(); ++k) {
        const bool has_begun =
            is_slip(state.set[k]) && begins_[k] && !has_friction_state(structure_.contacts[k].friction);
        if (!has_begun || has_tried[k] || !could_stick(state, surface, k)) continue;
        state.set[k] = ContactMode::stick;
        broken_[k] = begins_[k] = false;
        has_tried[k] = true;
        return true;
    }
    block_.choose(state.set);
    block_.expand(state.q, state.v, state.friction_states, surface, settling_order);
    return false;
}

// changes the worst violated contact until none is, beginning with the present set
Settling::Forces Settling::change_one_by_one(TaylorState& state, const SurfaceSeries& surface) {
    broken_ = begins_;
    std::vector<bool> has_tried(state.set.size());
    bool has_changed = false;
    const auto trial = [&]() -> std::optional<Forces> {
        if (!block_.choose(state.set)) return Forces::inconsistent;
        block_.expand(state.q, state.v, state.friction_states, surface, settling_order);
        Violation worst;
        for (std::size_t k = 0; k < state.set.size(); ++k)
            look(state, k, worst);
        if (worst.order > most_dropped) {
            state.dropped = orders_;
            if (has_changed && stick_again(state, surface, has_tried)) return std::nullopt;
            return Forces::found;
        }
        has_changed = true;
        ContactMode& mode = state.set[worst.contact];
        if (mode == ContactMode::open) {
            if (worst.order <= 1) {
                closing_ = worst.contact;
                return Forces::closing;
            }
            mode = closed_mode(structure_.contacts[worst.contact], state, surface);
        } else if (worst.function == 0) {
            mode = ContactMode::open;
        } else if (is_slip(mode)) {
            const bool creeps = has_friction_state(structure_.contacts[worst.contact].friction);
            mode = creeps ? turned(mode) : ContactMode::stick;
        } else {
            mode = slip_mode(worst.function == 1 ? model::Slip::backward : model::Slip::forward);
            broken_[worst.contact] = begins_[worst.contact] = true;
        }
        return std::nullopt;
    };
    return integration::change_one_by_one(state.set.size(), trial).value_or(Forces::inconsistent);
}

// tries all sets, those nearest to the present one first; returns whether one obeys the laws
bool Settling::find_any(TaylorState& state, const SurfaceSeries& surface) {
    const std::size_t p = state.set.size();
    const ContactSet present = state.set;
    std::vector<std::vector<ContactMode>> possible(p);
    std::vector<bool> is_at_rest(p);
    block_.choose(ContactSet(p, ContactMode::open));
    block_.expand(state.q, state.v, state.friction_states, surface, 0);
    for (std::size_t k = 0; k < p; ++k) {
        const ModalContact& c = structure_.contacts[k];
        const double w = slip_velocity(c, state.v, surface[0]);
        // what is no slip to `look`, beside all that accelerations change in a block, is none here
        is_at_rest[k] = std::abs(w) <= slip_zero(c, state, surface) + term_rounding * block_.free_change_scale(k);
        if (present[k] == ContactMode::open &&
            (gap(c, state.q) > gap_zero(c, state, block_.step()) ||
             block_.step() * gap_velocity(c, state.v) > gap_zero(c, state, block_.step())))
            possible[k] = {ContactMode::open};
        else if (is_at_rest[k] && has_friction_state(c.friction))
            possible[k] = {ContactMode::slip_forward, ContactMode::slip_backward, ContactMode::open};
        else if (is_at_rest[k])
            possible[k] = {ContactMode::stick, ContactMode::slip_forward, ContactMode::slip_backward,
                           ContactMode::open};
        else
            possible[k] = {slip_mode(model::slip_of(w)), ContactMode::open};
    }
    broken_ = begins_;
    // all sets are to see the same: no slip at all
    for (std::size_t k = 0; k < p; ++k)
        if (is_slip(present[k]) && is_at_rest[k]) begins_[k] = true;
    if (begins_ != broken_) hold_ended(state, surface);
    const bool is_found = try_all_sets(possible, present, [&](const ContactSet& set) {
        if (!block_.choose(set)) return false;
        state.set = set;
        block_.expand(state.q, state.v, state.friction_states, surface, settling_order);
        Violation worst;
        for (std::size_t k = 0; k < p; ++k)
            look(state, k, worst);
        if (worst.order <= most_dropped) return false;
        state.dropped = orders_;
        for (std::size_t k = 0; k < p; ++k)
            begins_[k] = is_at_rest[k] && is_slip(set[k]);
        return true;
    });
    if (is_found) return true;
    state.set = present;
    possible_ = possible;
    return false;
}

// forces and accelerations that obey all laws
Settling::Forces Settling::find_forces(TaylorState& state, const SurfaceSeries& surface) {
    const ContactSet present = state.set;
    const std::vector<bool> begins = begins_;
    const Forces forces = change_one_by_one(state, surface);
    if (forces == Forces::found || forces == Forces::closing) return forces;
    state.set = present;
    begins_ = begins;
    return find_any(state, surface) ? Forces::found : forces;
}

}  // namespace stridor::integration
