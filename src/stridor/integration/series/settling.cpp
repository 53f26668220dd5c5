#include "stridor/integration/series/settling.hpp"

#include "stridor/integration/rules/contact_impulses.hpp"
#include "stridor/integration/rules/contact_mode_of.hpp"
#include "stridor/integration/rules/painleve.hpp"
#include "stridor/integration/rules/set_search.hpp"
#include "stridor/integration/series/held_sums.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace stridor::integration {

namespace {

constexpr int most_rounds = 64;  // of impacts and forces in one event

// what moves and is stretched, less the load's potential: closing a gap by force changes all of it
double free_energy(const ModalStructure& structure, const TaylorState& state) {
    double energy = 0.0;
    for (std::size_t j = 0; j < state.q.size(); ++j)
        energy += 0.5 * state.v[j] * state.v[j] +
                  (0.5 * structure.square_frequency[j] * state.q[j] - structure.load[j]) * state.q[j];
    for (const ModalSpring& spring : structure.springs)
        energy += energy_of(spring.law, elongation(spring, state.q));
    return energy;
}

}  // namespace

struct Settling::Lawful {
    TaylorState state;
    std::vector<bool> begins;
    EnergyBalance losses;
    std::vector<record::Load> impacts;
    long completed = 0;
};

BlockSeries event_series(const ModalStructure& structure, const TaylorBlock& block, std::size_t contact,
                         ContactMode mode, std::size_t function, bool has_broken) {
    if (mode == ContactMode::open) return block.gap(contact);
    const BlockSeries& N = block.normal_force(contact);
    if (function == 0) return N;
    BlockSeries series;
    if (is_slip(mode)) {
        series = block.slip_velocity(contact);
        for (double& each : series)
            each *= sign_of(mode);
        return series;
    }
    const model::Slip way = function == 1 ? model::Slip::backward : model::Slip::forward;
    const double limit =
        limit_of(structure.contacts[contact].friction, way, has_broken ? StickLimit::fallen : StickLimit::whole);
    const double sign = function == 1 ? -1.0 : 1.0;
    const BlockSeries& T = block.friction_force(contact);
    for (std::size_t m = 0; m < series.size(); ++m)
        series[m] = limit * N[m] + sign * T[m];
    return series;
}

void add_growth(const ModalContact& contact, const TaylorBlock& block, const BlockSeries& normal_force, double rested,
                const BlockStretch& stretch, BlockSeries& function) {
    const auto at = [&](double theta) { return model::grown(contact.rest, rested + theta * block.length()); };
    const double begin = at(stretch.from), slope = (at(stretch.to) - begin) / (stretch.to - stretch.from);
    const double level = begin - slope * stretch.from;
    for (std::size_t m = function.size(); m-- > 1;)
        function[m] += level * normal_force[m] + slope * normal_force[m - 1];
    function[0] += level * normal_force[0];
}

Settling::Settling(const ModalStructure& structure, double step)
    : structure_(structure),
      block_(structure, step),
      broken_(structure.contacts.size()),
      begins_(structure.contacts.size()),
      orders_(structure.contacts.size()),
      impacts_(structure.contacts.size()) {}

std::vector<record::Load> Settling::take_impacts() {
    return std::exchange(impacts_, std::vector<record::Load>(impacts_.size()));
}

std::vector<double> Settling::project(TaylorState& state, const SurfaceSeries& surface) const {
    std::vector<HeldSum> gaps, rates;
    for (std::size_t k = 0; k < state.set.size(); ++k) {
        if (state.set[k] == ContactMode::open) continue;
        const ModalContact& c = structure_.contacts[k];
        const auto number = static_cast<Eigen::Index>(2 * k);
        gaps.push_back({c.normal, c.initial_gap, number});
        rates.push_back({c.normal, 0.0, number});
    }
    for (std::size_t k = 0; k < state.set.size(); ++k) {
        const bool is_held = state.set[k] == ContactMode::stick || (begins_[k] && is_slip(state.set[k]));
        const ModalContact& c = structure_.contacts[k];
        if (is_held) rates.push_back({c.tangent, -(c.drive_share * surface[0]), static_cast<Eigen::Index>(2 * k + 1)});
    }
    hold_at_zero(gaps, structure_.compliance, state.q);
    const Eigen::VectorXd impulses = hold_at_zero(rates, structure_.compliance, state.v);
    std::vector<double> normal(state.set.size(), 0.0);
    for (Eigen::Index row = 0; row < impulses.size(); ++row) {
        const Eigen::Index number = rates[static_cast<std::size_t>(row)].number;
        if (number % 2 == 0) normal[static_cast<std::size_t>(number / 2)] = impulses(row);
    }
    return normal;
}

// what has been ended is held; what that changes is lost
void Settling::hold_ended(TaylorState& state, const SurfaceSeries& surface) {
    const double before = free_energy(structure_, state);
    const std::vector<double> impulses = project(state, surface);
    for (std::size_t k = 0; k < impulses.size(); ++k)
        impacts_[k].normal_impulse += impulses[k];
    losses_.impact_loss += before - free_energy(structure_, state);
}

// closed contacts have the state that their slip velocity says
void Settling::correct_modes(TaylorState& state, const SurfaceSeries& surface) {
    bool has_ended = false;
    for (std::size_t k = 0; k < state.set.size(); ++k) {
        if (state.set[k] == ContactMode::open) continue;
        const ModalContact& c = structure_.contacts[k];
        const double w = slip_velocity(c, state.v, surface[0]);
        if (std::abs(w) > slip_zero(c, state, surface)) {
            state.set[k] = slip_mode(model::slip_of(w));
        } else if (!begins_[k]) {
            // a slip this small is none, and was more than rounding
            const double terms = dot_of_sizes(c.tangent, state.v) + std::abs(c.drive_share * surface[0]);
            if (is_slip(state.set[k]) && std::abs(w) > term_rounding * terms) has_ended = true;
            const bool creeps = has_friction_state(c.friction);
            if (!creeps || !is_slip(state.set[k])) state.set[k] = resting_mode(c);
            begins_[k] = creeps;
        }
    }
    if (has_ended) hold_ended(state, surface);
}

// impulses of all that touches; returns false where there are none that obey the laws
bool Settling::meet(TaylorState& state, const SurfaceSeries& surface, std::size_t fired) {
    const std::size_t p = state.set.size();
    Meeting meeting{std::vector<double>(p), std::vector<double>(p), state.set, std::vector<bool>(p)};
    for (std::size_t k = 0; k < p; ++k) {
        const ModalContact& c = structure_.contacts[k];
        meeting.gap_velocity[k] = gap_velocity(c, state.v);
        meeting.slip_velocity[k] = slip_velocity(c, state.v, surface[0]);
        const bool is_near = gap(c, state.q) <= gap_zero(c, state, block_.step());
        meeting.touches[k] = state.set[k] != ContactMode::open || is_near || k == fired;
        if (k == fired || (state.set[k] == ContactMode::open && is_near && meeting.gap_velocity[k] < 0.0))
            meeting.mode[k] = ContactMode::stick;
    }
    for (std::size_t k = 0; k < state.rested.size(); ++k)
        meeting.grown.push_back(model::grown(structure_.contacts[k].rest, state.rested[k]));
    const std::optional<ContactImpulses> impulses = contact_impulses(structure_, meeting);
    if (!impulses) {
        possible_ = modes_of_touching(meeting.touches);
        return false;
    }
    for (std::size_t k = 0; k < p; ++k) {
        if (!meeting.touches[k]) continue;
        const ModalContact& c = structure_.contacts[k];
        const double P_n = impulses->normal[k];
        const double P_t = impulses->tangential[k];
        for (std::size_t j = 0; j < state.v.size(); ++j)
            state.v[j] += P_n * c.normal[j] + P_t * c.tangent[j];
        losses_.impact_loss -= 0.5 * P_n * (meeting.gap_velocity[k] + impulses->gap_velocity[k]);
        const double friction_loss = -0.5 * P_t * (meeting.slip_velocity[k] + impulses->slip_velocity[k]);
        losses_.friction_loss += friction_loss;
        impacts_[k] += record::Load{P_n, friction_loss};
        losses_.drive_work += P_t * c.drive_share * surface[0];
        state.set[k] = impulses->mode[k];
        begins_[k] = false;
    }
    // an impact tells a velocity beside the largest of all: a gap that falls by less, but by more than its own
    // rounding, is closed
    for (std::size_t k = 0; k < p; ++k) {
        const ModalContact& c = structure_.contacts[k];
        if (!meeting.touches[k] || state.set[k] != ContactMode::open) continue;
        if (block_.step() * impulses->gap_velocity[k] < -gap_zero(c, state, block_.step()))
            state.set[k] = closed_mode(c, state, surface);
    }
    return true;
}

// an impact, and what touches but for rounding put onto the surface: the load's work on that belongs to the impact,
// its work on taking rounding out of gaps that were closed before does not
bool Settling::collide(TaylorState& state, const SurfaceSeries& surface, std::size_t fired) {
    const ContactSet closed_before = state.set;
    if (!meet(state, surface, fired)) return false;
    bool is_moved = false;
    for (std::size_t k = 0; k < state.set.size(); ++k) {
        const ModalContact& c = structure_.contacts[k];
        const double terms = dot_of_sizes(c.normal, state.q) + std::abs(c.initial_gap);
        if (state.set[k] != ContactMode::open && std::abs(gap(c, state.q)) > term_rounding * terms) is_moved = true;
    }
    if (!is_moved) {
        project(state, surface);
        return true;
    }
    TaylorState without_rounding = state;
    without_rounding.set = closed_before;
    project(without_rounding, surface);
    without_rounding.v = state.v;
    project(state, surface);
    losses_.impact_loss += free_energy(structure_, without_rounding) - free_energy(structure_, state);
    return true;
}

// ends what would end within `soon_`; returns whether anything did
bool Settling::complete(TaylorState& state, const SurfaceSeries& surface) {
    bool has_ended = false;
    for (std::size_t k = 0; k < state.set.size(); ++k) {
        const ContactMode mode = state.set[k];
        if (mode == ContactMode::open && state.dropped[k][0] == 1) {
            const BlockSeries g = block_.gap(k);
            // c0 + c1 x + c2 x²: the flight's parabola
            const double c0 = std::max(0.0, g[0]);
            if (!(g[2] < 0.0)) continue;
            const double back = (-g[1] - std::sqrt(g[1] * g[1] - 4.0 * g[2] * c0)) / (2.0 * g[2]);
            if (!(back < soon_)) continue;
            // closed by force it slips, unless it had no slip velocity
            const ModalContact& c = structure_.contacts[k];
            const double w = slip_velocity(c, state.v, surface[0]);
            const double near = soon_ * (dot_of_sizes(c.tangent, state.v) + std::abs(c.drive_share * surface[0]));
            state.set[k] = std::abs(w) > near ? slip_mode(model::slip_of(w)) : ContactMode::stick;
            ++completed_;
            has_ended = true;
        } else if (is_slip(mode) && state.dropped[k][1] == 0 && !has_friction_state(structure_.contacts[k].friction)) {
            const BlockSeries w = block_.slip_velocity(k);
            const double rest = -w[0] / w[1];
            if (!(rest > 0.0 && rest < soon_)) continue;
            state.set[k] = ContactMode::stick;
            has_ended = true;
        }
    }
    if (has_ended) hold_ended(state, surface);
    return has_ended;
}

// the contacts with the friction of their slip velocities
std::vector<ModalContact> Settling::rubbing_as_now(const TaylorState& state, const SurfaceSeries& surface) const {
    std::vector<ModalContact> contacts = structure_.contacts;
    for (ModalContact& contact : contacts) {
        if (is_state_wise(contact.friction)) continue;
        const double w = slip_velocity(contact, state.v, surface[0]);
        model::Directional now;
        for (const model::Slip way : model::slips) {
            now.static_coefficients[index_of(way)] = stick_limit(contact.friction, way);
            now.kinetic_coefficients[index_of(way)] = std::abs(slip_ratio(contact.friction, way, w));
        }
        contact.friction = now;
    }
    return contacts;
}

// why no set obeys all laws
Settled Settling::failed(const TaylorState& state, const SurfaceSeries& surface) {
    pressed_.clear();
    // none was looked at where rounds of impacts and flights came to no end
    if (!possible_.empty())
        pressed_ = pressed_contacts(rubbing_as_now(state, surface), structure_.compliance, possible_);
    return pressed_.empty() ? Settled::inconsistent : Settled::pressed;
}

Settled Settling::go_on(TaylorState& state, const SurfaceSeries& surface) {
    possible_.clear();
    // what obeyed the laws before flights were ended: where nothing does afterwards they go on
    std::optional<Lawful> lawful;
    const auto finish = [&] {
        project(state, surface);
        for (std::size_t k = 0; k < state.set.size(); ++k)
            if (state.set[k] == ContactMode::open) state.friction_states[k] = 0.0;
        std::fill(begins_.begin(), begins_.end(), false);
        return Settled::done;
    };
    const auto give_up = [&] {
        if (!lawful) return failed(state, surface);
        state = lawful->state;
        begins_ = lawful->begins;
        losses_ = lawful->losses;
        impacts_ = lawful->impacts;
        completed_ = lawful->completed;
        return finish();
    };
    for (int round = 0; round < most_rounds; ++round) {
        correct_modes(state, surface);
        switch (find_forces(state, surface)) {
            case Forces::inconsistent:
                return give_up();
            case Forces::closing:
                if (!collide(state, surface, closing_)) return give_up();
                continue;
            case Forces::found:
                if (!lawful) lawful = Lawful{state, begins_, losses_, impacts_, completed_};
                if (complete(state, surface)) continue;
                return finish();
        }
    }
    return give_up();
}

Settled Settling::settle(TaylorState& state, const SurfaceSeries& surface) {
    correct_modes(state, surface);
    project(state, surface);
    return go_on(state, surface);
}

Settled Settling::fire(TaylorState& state, const SurfaceSeries& surface, std::size_t contact, std::size_t function) {
    ContactMode& mode = state.set[contact];
    if (mode == ContactMode::open) {
        if (!collide(state, surface, contact)) return failed(state, surface);
        return go_on(state, surface);
    }
    const bool is_stuck = mode == ContactMode::stick;
    if (is_slip(mode) && function == 1) {
        begins_[contact] = has_friction_state(structure_.contacts[contact].friction);
        mode = begins_[contact] ? turned(mode) : ContactMode::stick;
    }
    if (is_stuck && function > 0) {
        mode = slip_mode(function == 1 ? model::Slip::backward : model::Slip::forward);
        begins_[contact] = true;
    }
    project(state, surface);
    if (function == 0) mode = ContactMode::open;
    return go_on(state, surface);
}

}  // namespace stridor::integration
