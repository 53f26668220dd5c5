// Rows and columns of the tableau are those of `ContactRowPlan`: the gap velocity and N of a contact, then its slip
// velocity and what T has beside ratio N. So a contact is open with none exchanged, slips with N exchanged (T = ratio
// N), sticks with all; a change of the ratio is a shear. Of two tangents each has its ratio, -mu_d times the direction.

#include "stridor/integration/steps/step_contacts.hpp"

#include "stridor/base/decompositions.hpp"
#include "stridor/integration/rules/contact_mode_of.hpp"
#include "stridor/integration/rules/fastest_slip.hpp"
#include "stridor/integration/rules/painleve.hpp"
#include "stridor/integration/rules/set_search.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace stridor::integration {

namespace {

constexpr double trial_rounding = 1e-10;     // [1] of the largest force or velocity: what a few hundred exchanges leave
constexpr double least_force_pivot = 1e-13;  // [1] of the diagonal: contacts with less depend on each other
constexpr long exchanges_per_row = 20;       // before the tableau begins anew: rounding adds up
constexpr double ratio_rounding = 1e-12;     // [1] of a T/N that changes with the slip velocity
constexpr int most_ratio_turns = 40;         // Newton's steps; two are usual: a step changes a velocity by little
constexpr int most_ratio_rounds = 400;       // through all slips, one by one

}  // namespace

StepContacts::StepContacts(const ModalStructure& structure, Eigen::MatrixXd response,
                           const std::vector<ContactMode>& set)
    : structure_(structure),
      plan_(row_plan(structure.contacts)),
      response_(std::move(response)),
      tableau_(response_),
      set_(set.size(), ContactMode::open),
      friction_(plan_.rows(), 0.0),
      direction_(set.size(), {1.0, 0.0}),
      tried_(set.size()),
      grown_(set.size(), 0.0),
      force_(plan_.rows(), 0.0),
      rate_(plan_.rows(), 0.0),
      is_state_wise_(std::all_of(structure.contacts.begin(), structure.contacts.end(),
                                 [](const ModalContact& contact) { return is_state_wise(contact.friction); })) {
    for (std::size_t k = 0; k < set.size(); ++k)
        pressed_.push_back({has_painleve(k, model::Slip::forward), has_painleve(k, model::Slip::backward)});
    // in a plane a slip has no sign: it begins as a stick, and finds its direction
    for (std::size_t k = 0; k < set.size(); ++k)
        change(k, is_slip(set[k]) && plan_.has_two_tangents(k) ? ContactMode::stick : set[k]);
}

void StepContacts::set_friction(std::size_t row, double ratio) {
    tableau_.shear(plan_.first[plan_.contact[row]], row, ratio - friction_[row]);
    friction_[row] = ratio;
}

// lets a force follow; a row that others make up has no force of its own
void StepContacts::take_up(std::size_t row) {
    const auto at = static_cast<Eigen::Index>(row);
    if (!(std::abs(tableau_.pivot(row)) > least_force_pivot * response_(at, at))) is_singular_ = true;
    tableau_.exchange(row);
}

void StepContacts::change(std::size_t contact, ContactMode mode) {
    const std::size_t normal = plan_.first[contact];
    const std::size_t end = plan_.first[contact + 1];
    if (set_[contact] == mode) return;
    // by way of stick, whose forces know no ratio
    if (set_[contact] == ContactMode::open) {
        for (std::size_t tangent = normal + 1; tangent < end; ++tangent)
            set_friction(tangent, 0.0);
        take_up(normal);
    }
    for (std::size_t tangent = normal + 1; tangent < end && set_[contact] != ContactMode::stick; ++tangent)
        take_up(tangent);
    set_[contact] = mode;
    if (mode == ContactMode::stick) return;
    if (is_slip(mode)) set_directions(contact);
    for (std::size_t tangent = normal + 1; tangent < end; ++tangent)
        tableau_.exchange(tangent);
    if (mode == ContactMode::open) tableau_.exchange(normal);
}

// the ratios of T and N of a contact that slips
void StepContacts::set_directions(std::size_t contact) {
    const std::size_t tangent = plan_.first[contact] + 1;
    const double ratio = slip_ratio(structure_.contacts[contact].friction, way_of(set_[contact]));
    if (!plan_.has_two_tangents(contact)) return set_friction(tangent, ratio);
    set_friction(tangent, -std::abs(ratio) * direction_[contact][0]);
    set_friction(tangent + 1, -std::abs(ratio) * direction_[contact][1]);
}

// Painleve: friction of this slip presses the contact together more than N parts it
bool StepContacts::has_painleve(std::size_t contact, model::Slip way) const {
    const auto at = static_cast<Eigen::Index>(plan_.first[contact]);
    const double ratio = slip_ratio(structure_.contacts[contact].friction, way);
    return !(response_(at, at) + ratio * response_(at, at + 1) > 0.0);
}

bool StepContacts::is_pressed_by(std::size_t contact, ContactMode mode) const {
    if (!is_slip(mode)) return false;
    if (!plan_.has_two_tangents(contact)) return pressed_[contact][index_of(way_of(mode))];
    const auto at = static_cast<Eigen::Index>(plan_.first[contact]);
    const double ratio = slip_ratio(structure_.contacts[contact].friction, way_of(mode));
    const std::array<double, 2>& along = direction_[contact];
    const double across = along[0] * response_(at, at + 1) + along[1] * response_(at, at + 2);
    return !(response_(at, at) - std::abs(ratio) * across > 0.0);
}

// the slips whose friction changes with their velocity
std::vector<std::size_t> StepContacts::changing_slips() const {
    std::vector<std::size_t> slips;
    if (is_state_wise_) return slips;
    for (std::size_t k = 0; k < set_.size(); ++k)
        if (is_slip(set_[k]) && !is_state_wise(structure_.contacts[k].friction)) slips.push_back(k);
    return slips;
}

// does Newton's method alone find the ratios?
bool StepContacts::is_gentle_step(const std::vector<std::size_t>& slips) const {
    return std::all_of(slips.begin(), slips.end(), [&](std::size_t k) {
        const std::size_t normal = plan_.first[k];
        const double reach = std::abs(tableau_.entry(normal + 1, normal + 1) * tableau_.follows(normal));
        return is_gentle(slope_range(structure_.contacts[k].friction), reach);
    });
}

bool StepContacts::settle_ratios() {
    const std::vector<std::size_t> slips = changing_slips();
    return slips.empty() || (is_gentle_step(slips) && settle_together(slips)) || settle_one_by_one(slips);
}

// from no friction; a contact that is pulled opens later, and its ratio says nothing
bool StepContacts::settle_one_by_one(const std::vector<std::size_t>& slips) {
    for (const std::size_t k : slips)
        set_friction(plan_.first[k] + 1, 0.0);
    for (int round = 0; round < most_ratio_rounds; ++round) {
        double changed = 0.0;
        for (const std::size_t k : slips) {
            const std::size_t normal = plan_.first[k], row = normal + 1;
            const double before = friction_[row], N = tableau_.follows(normal);
            if (!(N > 0.0)) continue;
            const auto velocity_at = [&](double ratio) {
                set_friction(row, ratio);
                return tableau_.follows(row);
            };
            const std::optional<double> ratio = ratio_of_fastest_slip(
                structure_.contacts[k].friction, way_of(set_[k]), std::abs(tableau_.entry(row, row) * N), velocity_at);
            if (!ratio) return false;
            set_friction(row, *ratio);
            changed = std::max(changed, std::abs(*ratio - before));
        }
        if (changed <= ratio_rounding) return true;
    }
    return false;
}

// Newton's method for ratios that are those of the slip velocities they leave. A change dr of contact l changes T there
// by N dr beside ratio N (D: slip velocities per unit of that), so r_k - ratio_k(w_k) changes by
//
//     dr_k - ratio_k' sum D_kl N_l dr_l
bool StepContacts::settle_together(const std::vector<std::size_t>& slips) {
    const auto count = static_cast<Eigen::Index>(slips.size());
    for (int turn = 0; turn < most_ratio_turns; ++turn) {
        Eigen::MatrixXd slope = Eigen::MatrixXd::Identity(count, count);
        Eigen::VectorXd off(count);
        for (Eigen::Index a = 0; a < count; ++a) {
            const std::size_t k = slips[static_cast<std::size_t>(a)];
            const std::size_t row = plan_.first[k] + 1;
            const model::FrictionLaw& law = structure_.contacts[k].friction;
            const double w = tableau_.follows(row);
            off(a) = friction_[row] - slip_ratio(law, way_of(set_[k]), w);
            const double change = slip_ratio_slope(law, way_of(set_[k]), w);
            for (Eigen::Index b = 0; b < count; ++b) {
                const std::size_t normal = plan_.first[slips[static_cast<std::size_t>(b)]];
                slope(a, b) -= change * tableau_.entry(row, normal + 1) * tableau_.follows(normal);
            }
        }
        if (off.cwiseAbs().maxCoeff() <= ratio_rounding) return true;
        const Eigen::VectorXd turned = slope.partialPivLu().solve(off);
        if (!turned.allFinite()) return false;
        for (Eigen::Index a = 0; a < count; ++a) {
            const std::size_t row = plan_.first[slips[static_cast<std::size_t>(a)]] + 1;
            set_friction(row, friction_[row] - turned(a));
        }
    }
    return false;
}

void StepContacts::rebuild() {
    const std::vector<ContactMode> set = set_;
    tableau_ = ExchangeTableau(response_);
    std::fill(friction_.begin(), friction_.end(), 0.0);
    std::fill(set_.begin(), set_.end(), ContactMode::open);
    for (std::size_t k = 0; k < set.size(); ++k)
        change(k, set[k]);
}

void StepContacts::look(std::size_t contact) {
    if (plan_.has_two_tangents(contact)) return look_at_plane(contact);
    TriedContact& tried = tried_[contact];
    const std::size_t row = plan_.first[contact];
    const double at_normal = tableau_.follows(row);
    const double at_tangent = tableau_.follows(row + 1);
    tried.mode = set_[contact];
    const bool is_open = tried.mode == ContactMode::open;
    const bool is_stuck = tried.mode == ContactMode::stick;
    tried.normal = is_open ? 0.0 : at_normal;
    tried.tangential = friction_[row + 1] * tried.normal + (is_stuck ? at_tangent : 0.0);
    tried.gap_velocity = is_open ? at_normal : 0.0;
    tried.slip_velocity = is_stuck ? 0.0 : at_tangent;
    force_[row] = tried.normal;
    force_[row + 1] = tried.tangential;
    rate_[row] = tried.gap_velocity;
    rate_[row + 1] = tried.slip_velocity;
}

// a contact that does not take part
void StepContacts::forget(std::size_t contact) {
    change(contact, ContactMode::open);
    tried_[contact] = {};
    for (std::size_t row = plan_.first[contact]; row < plan_.first[contact + 1]; ++row)
        force_[row] = rate_[row] = 0.0;
}

StepContacts::Search StepContacts::search(const std::vector<double>& free_rates, const std::vector<char>& touches) {
    const std::size_t p = set_.size();
    for (std::size_t k = 0; k < p; ++k) {
        tried_[k].limit = StickLimit::whole;
        tried_[k].grown = grown_[k];
    }
    for (std::size_t k = 0; k < p; ++k)
        if (is_pressed_by(k, set_[k])) return Search::singular;
    tableau_.set(free_rates);
    speed_ = 0.0;
    for (const double rate : free_rates)
        speed_ = std::max(speed_, std::abs(rate));
    const auto trial = [&]() -> std::optional<Search> {
        if (!settle_directions() || !settle_ratios()) return Search::endless;
        TrialScale scale{.rounding = trial_rounding};
        for (std::size_t k = 0; k < p; ++k) {
            if (touches[k] == 0) continue;
            look(k);
            const TriedContact& tried = tried_[k];
            scale.push = std::max({scale.push, std::abs(tried.normal), std::abs(tried.tangential)});
            scale.speed = std::max({scale.speed, std::abs(tried.gap_velocity), std::abs(tried.slip_velocity)});
            for (std::size_t row = plan_.first[k]; row < plan_.first[k + 1]; ++row)
                scale.speed = std::max(scale.speed, std::abs(free_rates[row]));
        }
        auto [contact, worst] = worst_contact(structure_.contacts, tried_, touches, scale);
        if (worst.size == 0.0) return Search::found;
        if (plan_.has_two_tangents(contact) && is_slip(worst.mode)) worst.mode = begin_slip(contact);
        if (is_pressed_by(contact, worst.mode)) return Search::singular;
        if (set_[contact] == ContactMode::stick && is_slip(worst.mode)) tried_[contact].limit = StickLimit::fallen;
        change(contact, worst.mode);
        ++changes_;
        if (is_singular_) return Search::singular;
        return std::nullopt;
    };
    return change_one_by_one(p, trial).value_or(Search::endless);
}

bool StepContacts::solve(const std::vector<double>& free_rates, const std::vector<char>& touches) {
    for (std::size_t k = 0; k < set_.size(); ++k)
        if (touches[k] == 0) forget(k);
    if (tableau_.exchanges() > exchanges_per_row * static_cast<long>(tableau_.size())) rebuild();
    Search result = is_singular_ ? Search::singular : search(free_rates, touches);
    if (result == Search::endless) {
        ++restarts_;
        for (std::size_t k = 0; k < set_.size(); ++k)
            if (touches[k] != 0) set_[k] = ContactMode::stick;
        rebuild();
        result = search(free_rates, touches);
    }
    return result == Search::found;
}

std::vector<std::size_t> StepContacts::pressed(const std::vector<char>& touches) const {
    const std::vector<bool> takes_part(touches.begin(), touches.end());
    return pressed_contacts(structure_.contacts, response_, modes_of_touching(takes_part));
}

}  // namespace stridor::integration
