#include "stridor/integration/rules/contact_impulses.hpp"

#include "stridor/base/decompositions.hpp"
#include "stridor/integration/rules/contact_mode_of.hpp"
#include "stridor/integration/rules/fastest_slip.hpp"
#include "stridor/integration/rules/set_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stridor::integration {

namespace {

constexpr double impulse_rounding = 1e-12;        // [1] of the largest velocity or impulse
constexpr double least_pivot = 1e-13;             // [1] of the largest pivot: contacts with less depend on each other
constexpr double impulse_ratio_rounding = 1e-13;  // [1] of a ratio that belongs to its slip velocity
constexpr int most_impulse_rounds = 400;          // through all slips, one by one

Eigen::Index index(std::size_t k) {
    return static_cast<Eigen::Index>(k);
}

// one trial: impulses for these modes
class Trial {
public:
    Trial(const ModalStructure& structure, const Meeting& meeting)
        : structure_(structure),
          meeting_(meeting),
          limit_(meeting.mode.size(), StickLimit::whole) {
        result_.mode = meeting.mode;
    }

    bool solve();
    bool solve_with_ratios();
    bool settle_ratios();
    bool settle_ratio(std::size_t k);
    bool mend();
    bool solve_any();
    ContactImpulses result() const { return result_; }

private:
    // the slip begins with its own ratio, and takes that of the slip velocity that the impact leaves
    double begun(std::size_t k) const { return slip_ratio(structure_.contacts[k].friction, way_of(result_.mode[k])); }

    const ModalStructure& structure_;
    const Meeting& meeting_;
    std::vector<StickLimit> limit_;
    std::vector<double> ratio_;  // [1] P_t/P_n of the slipping, shape [contact]
    ContactImpulses result_;
};

bool Trial::solve() {
    ratio_.assign(result_.mode.size(), 0.0);
    for (std::size_t k = 0; k < ratio_.size(); ++k)
        if (is_slip(result_.mode[k])) ratio_[k] = begun(k);
    return solve_with_ratios() && settle_ratios();
}

// one slip after the other; one that is pulled opens later, and its ratio says nothing
bool Trial::settle_ratios() {
    std::vector<std::size_t> slips;
    for (std::size_t k = 0; k < ratio_.size(); ++k)
        if (meeting_.touches[k] && is_slip(result_.mode[k]) && !is_state_wise(structure_.contacts[k].friction))
            slips.push_back(k);
    for (int round = 0; round < most_impulse_rounds; ++round) {
        double changed = 0.0;
        for (const std::size_t k : slips) {
            if (!(result_.normal[k] > 0.0)) continue;
            const double before = ratio_[k];
            if (!settle_ratio(k)) return false;
            changed = std::max(changed, std::abs(ratio_[k] - before));
        }
        if (changed <= impulse_ratio_rounding) return true;
    }
    return false;
}

// the ratio that belongs to the slip velocity which it leaves, beside what the others have
bool Trial::settle_ratio(std::size_t k) {
    const auto velocity_at = [&](double ratio) {
        ratio_[k] = ratio;
        return solve_with_ratios() ? result_.slip_velocity[k] : std::numeric_limits<double>::quiet_NaN();
    };
    const double reach = std::abs(structure_.compliance(index(2 * k + 1), index(2 * k + 1)) * result_.normal[k]);
    const std::optional<double> ratio =
        ratio_of_fastest_slip(structure_.contacts[k].friction, way_of(result_.mode[k]), reach, velocity_at);
    if (!ratio) return false;
    ratio_[k] = *ratio;
    return solve_with_ratios();
}

bool Trial::solve_with_ratios() {
    const std::size_t p = result_.mode.size();
    std::vector<std::size_t> active, stuck;
    for (std::size_t k = 0; k < p; ++k) {
        if (!meeting_.touches[k] || result_.mode[k] == ContactMode::open) continue;
        active.push_back(k);
        if (result_.mode[k] == ContactMode::stick) stuck.push_back(k);
    }
    const std::size_t rows = active.size() + stuck.size();
    // unknown impulses as combinations of all P_n and P_t
    Eigen::MatrixXd push = Eigen::MatrixXd::Zero(index(2 * p), index(rows));
    Eigen::MatrixXd pick = Eigen::MatrixXd::Zero(index(rows), index(2 * p));
    Eigen::VectorXd before(index(2 * p));
    for (std::size_t k = 0; k < p; ++k) {
        before(index(2 * k)) = meeting_.gap_velocity[k];
        before(index(2 * k + 1)) = meeting_.slip_velocity[k];
    }
    for (std::size_t r = 0; r < active.size(); ++r) {
        const std::size_t k = active[r];
        push(index(2 * k), index(r)) = pick(index(r), index(2 * k)) = 1.0;
        if (is_slip(result_.mode[k])) push(index(2 * k + 1), index(r)) = ratio_[k];
    }
    for (std::size_t r = 0; r < stuck.size(); ++r) {
        const std::size_t row = active.size() + r;
        push(index(2 * stuck[r] + 1), index(row)) = pick(index(row), index(2 * stuck[r] + 1)) = 1.0;
    }
    Eigen::VectorXd impulse = Eigen::VectorXd::Zero(index(2 * p));
    if (rows > 0) {
        const Eigen::MatrixXd system = pick * structure_.compliance * push;
        Eigen::FullPivLU<Eigen::MatrixXd> factor(system);
        factor.setThreshold(least_pivot);
        if (!factor.isInvertible()) return false;
        const Eigen::VectorXd solution = factor.solve(Eigen::VectorXd(-(pick * before)));
        impulse = push * solution;
    }
    const Eigen::VectorXd after = before + structure_.compliance * impulse;
    result_.normal.resize(p);
    result_.tangential.resize(p);
    result_.gap_velocity.resize(p);
    result_.slip_velocity.resize(p);
    for (std::size_t k = 0; k < p; ++k) {
        const bool is_active = meeting_.touches[k] && result_.mode[k] != ContactMode::open;
        result_.normal[k] = impulse(index(2 * k));
        result_.tangential[k] = impulse(index(2 * k + 1));
        result_.gap_velocity[k] = is_active ? 0.0 : after(index(2 * k));
        result_.slip_velocity[k] = is_active && result_.mode[k] == ContactMode::stick ? 0.0 : after(index(2 * k + 1));
    }
    return true;
}

// changes the worst violated contact; returns false if none is
bool Trial::mend() {
    TrialScale scale{.rounding = impulse_rounding};
    for (std::size_t k = 0; k < result_.mode.size(); ++k) {
        if (!meeting_.touches[k]) continue;
        scale.speed = std::max({scale.speed, std::abs(meeting_.gap_velocity[k]), std::abs(meeting_.slip_velocity[k]),
                                std::abs(result_.gap_velocity[k]), std::abs(result_.slip_velocity[k])});
        scale.push = std::max({scale.push, std::abs(result_.normal[k]), std::abs(result_.tangential[k])});
    }
    std::vector<TriedContact> tried;
    for (std::size_t k = 0; k < result_.mode.size(); ++k)
        tried.push_back({result_.mode[k], limit_[k], result_.normal[k], result_.tangential[k], result_.gap_velocity[k],
                         result_.slip_velocity[k], meeting_.grown.empty() ? 0.0 : meeting_.grown[k]});
    const auto [contact, worst] = worst_contact(structure_.contacts, tried, meeting_.touches, scale);
    if (worst.size == 0.0) return false;
    if (result_.mode[contact] == ContactMode::stick && is_slip(worst.mode)) limit_[contact] = StickLimit::fallen;
    result_.mode[contact] = worst.mode;
    return true;
}

// tries all sets of modes, those nearest to the first one first; returns whether one obeys the laws
bool Trial::solve_any() {
    std::vector<std::vector<ContactMode>> possible(meeting_.mode.size());
    for (std::size_t k = 0; k < possible.size(); ++k)
        possible[k] = meeting_.touches[k] ? std::vector{ContactMode::stick, ContactMode::slip_forward,
                                                        ContactMode::slip_backward, ContactMode::open}
                                          : std::vector{meeting_.mode[k]};
    return try_all_sets(possible, meeting_.mode, [&](const std::vector<ContactMode>& set) {
        std::fill(limit_.begin(), limit_.end(), StickLimit::whole);
        result_.mode = set;
        return solve() && !mend();
    });
}

}  // namespace

std::optional<ContactImpulses> contact_impulses(const ModalStructure& structure, const Meeting& meeting) {
    Trial trial(structure, meeting);
    std::optional<bool> is_found = change_one_by_one(meeting.mode.size(), [&]() -> std::optional<bool> {
        if (!trial.solve()) return false;
        if (trial.mend()) return std::nullopt;
        return true;
    });
    if (!is_found) is_found = trial.solve_any();
    return *is_found ? std::optional(trial.result()) : std::nullopt;
}

}  // namespace stridor::integration
