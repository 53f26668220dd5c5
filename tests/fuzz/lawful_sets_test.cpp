// What contacts do at an event, held against all that they could do: of all sets of states exactly one obeys the laws
// of contact and lets what has no slip velocity stick if it can. It is the one that the Taylor engine finds, which
// searches by single changes. The forces of each set are solved here anew, in the rows of the structure.

#include "stridor/integration/modal/modal_structure.hpp"
#include "stridor/integration/rules/contact_mode_of.hpp"
#include "stridor/integration/rules/set_search.hpp"
#include "stridor/integration/series/settling.hpp"
#include "support/counter_random.hpp"
#include "support/effort.hpp"
#include "support/runs.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <optional>

namespace stridor {
namespace {

using integration::ContactMode;
using integration::ContactSet;
using support::CounterRandom;

constexpr double surface_velocity = 0.1;  // [m/s]
constexpr double undecided = 1e-6;        // [1] of the largest force or acceleration: no law is this close

// p nodes that may touch a surface, tied to each other and to further masses
model::Structure random_structure(std::size_t contacts, CounterRandom& random) {
    const auto p = static_cast<Eigen::Index>(contacts);
    const Eigen::Index n = 2 * p + 2;
    model::Structure structure = model::structure_of_size(static_cast<int>(n), static_cast<int>(contacts));
    const auto random_matrix = [&] {
        Eigen::MatrixXd matrix(n, n);
        for (Eigen::Index i = 0; i < n; ++i)
            for (Eigen::Index j = 0; j < n; ++j)
                matrix(i, j) = random.between(-1.0, 1.0);
        return matrix;
    };
    // one in two couples its contacts by inertia, too
    const Eigen::MatrixXd mix = random_matrix();
    structure.mass = Eigen::MatrixXd::Identity(n, n);
    if (random.one_in(2)) structure.mass += 0.2 / static_cast<double>(n) * mix * mix.transpose();
    const Eigen::MatrixXd springs = random_matrix(), dashpots = random_matrix();
    structure.stiffness = springs * springs.transpose();
    structure.damping = 0.05 * dashpots * dashpots.transpose();
    structure.load = Eigen::VectorXd::Zero(n);
    for (Eigen::Index k = 0; k < p; ++k) {
        model::ContactPoint& contact = structure.contacts[static_cast<std::size_t>(k)];
        contact.normal = Eigen::VectorXd::Unit(n, 2 * k);
        contact.tangent = Eigen::VectorXd::Unit(n, 2 * k + 1);
        const double limit = random.between(0.05, 0.8);
        contact.friction = model::Coulomb{limit, limit * random.between(0.2, 1.0)};
        structure.load -= random.between(0.0, 2.0) * contact.normal;
        structure.load += random.between(-1.0, 1.0) * contact.tangent;
    }
    return structure;
}

// an instant at which contacts touch: what each did before, and whether it slips
struct Instant {
    Eigen::VectorXd u, v;
    ContactSet before;
    std::vector<bool> touches, is_at_rest;
};

Instant random_instant(const model::Structure& structure, CounterRandom& random) {
    Instant now;
    now.u = Eigen::VectorXd(structure.load.size());
    now.v = now.u;
    for (Eigen::Index j = 0; j < now.u.size(); ++j) {
        now.u(j) = random.between(-1.0, 1.0);
        now.v(j) = random.between(-0.3, 0.3);
    }
    for (std::size_t k = 0; k < structure.contacts.size(); ++k) {
        const auto normal = static_cast<Eigen::Index>(2 * k);
        now.touches.push_back(!random.one_in(6));
        now.is_at_rest.push_back(random.one_in(2));
        now.u(normal) = now.touches[k] ? 0.0 : 0.5;
        if (now.touches[k]) now.v(normal) = 0.0;
        if (now.is_at_rest[k]) now.v(normal + 1) = surface_velocity;
        const double w = now.v(normal + 1) - surface_velocity;
        const bool was_open = !now.touches[k] || random.one_in(4);
        now.before.push_back(was_open            ? ContactMode::open
                             : now.is_at_rest[k] ? ContactMode::stick
                                                 : integration::slip_mode(model::slip_of(w)));
    }
    return now;
}

// how a set stands to the laws
enum class Finding { lawful, broken, too_close };

// forces and accelerations of one set, solved in the structure's rows
struct Solved {
    Eigen::VectorXd normal, friction, rise, slide;  // N, T [N]; g'', w' [m/s²]; shape [contact]
};

std::optional<Solved> solve(const model::Structure& structure, const Instant& now, const ContactSet& set) {
    const auto p = static_cast<Eigen::Index>(set.size());
    const Eigen::MatrixXd flexible = structure.mass.inverse();
    const Eigen::VectorXd free = flexible * (structure.load - structure.stiffness * now.u - structure.damping * now.v);
    // unknown N and T of each contact, one equation for each
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(2 * p, 2 * p), effect(2 * p, 2 * p);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * p), begin(2 * p);
    Eigen::MatrixXd rows(2 * p, now.u.size());
    for (Eigen::Index k = 0; k < p; ++k) {
        rows.row(2 * k) = structure.contacts[static_cast<std::size_t>(k)].normal.transpose();
        rows.row(2 * k + 1) = structure.contacts[static_cast<std::size_t>(k)].tangent.transpose();
    }
    effect = rows * flexible * rows.transpose();
    begin = rows * free;
    for (Eigen::Index k = 0; k < p; ++k) {
        const ContactMode mode = set[static_cast<std::size_t>(k)];
        const Eigen::Index N = 2 * k, T = 2 * k + 1;
        if (mode == ContactMode::open) {
            system(N, N) = system(T, T) = 1.0;
            continue;
        }
        system.row(N) = effect.row(N);
        right(N) = -begin(N);
        if (mode == ContactMode::stick) {
            system.row(T) = effect.row(T);
            right(T) = -begin(T);
        } else {
            system(T, T) = 1.0;
            system(T, N) =
                -slip_ratio(structure.contacts[static_cast<std::size_t>(k)].friction, integration::way_of(mode));
        }
    }
    const Eigen::FullPivLU<Eigen::MatrixXd> factor(system);
    if (!factor.isInvertible()) return std::nullopt;
    const Eigen::VectorXd force = factor.solve(right), rate = begin + effect * force;
    Solved solved{Eigen::VectorXd(p), Eigen::VectorXd(p), Eigen::VectorXd(p), Eigen::VectorXd(p)};
    for (Eigen::Index k = 0; k < p; ++k) {
        solved.normal(k) = force(2 * k);
        solved.friction(k) = force(2 * k + 1);
        solved.rise(k) = rate(2 * k);
        solved.slide(k) = rate(2 * k + 1);
    }
    return solved;
}

// do N and T of a contact obey the law of its stick?
Finding sticks(const model::ContactPoint& contact, double N, double T, double least) {
    const double left = stick_limit(contact.friction, model::slip_against(T)) * N - std::abs(T);
    if (std::abs(left) < least || std::abs(N) < least) return Finding::too_close;
    return N > 0.0 && left > 0.0 ? Finding::lawful : Finding::broken;
}

Finding judged(const model::Structure& structure, const Instant& now, const ContactSet& set) {
    const std::optional<Solved> solved = solve(structure, now, set);
    if (!solved) return Finding::too_close;
    const double least =
        undecided * std::max({1.0, solved->normal.cwiseAbs().maxCoeff(), solved->friction.cwiseAbs().maxCoeff(),
                              solved->slide.cwiseAbs().maxCoeff()});
    bool is_close = false;
    for (std::size_t k = 0; k < set.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        const auto must = [&](double value) {
            is_close = is_close || std::abs(value) < least;
            return value > 0.0 || std::abs(value) < least;
        };
        if (!now.touches[k]) continue;
        if (set[k] == ContactMode::open) {
            if (!must(solved->rise(i))) return Finding::broken;
            continue;
        }
        if (!must(solved->normal(i))) return Finding::broken;
        if (set[k] == ContactMode::stick) {
            const Finding found = sticks(structure.contacts[k], solved->normal(i), solved->friction(i), least);
            if (found == Finding::broken) return found;
            is_close = is_close || found == Finding::too_close;
        } else if (now.is_at_rest[k]) {
            const double sign = set[k] == ContactMode::slip_forward ? 1.0 : -1.0;
            if (!must(sign * solved->slide(i))) return Finding::broken;
            // it sticks if it can
            ContactSet stuck = set;
            stuck[k] = ContactMode::stick;
            const std::optional<Solved> held = solve(structure, now, stuck);
            if (!held) return Finding::too_close;
            const Finding found = sticks(structure.contacts[k], held->normal(i), held->friction(i), least);
            if (found == Finding::lawful) return Finding::broken;
            is_close = is_close || found == Finding::too_close;
        }
    }
    return is_close ? Finding::too_close : Finding::lawful;
}

std::vector<ContactSet> all_sets(const Instant& now) {
    std::vector<std::vector<ContactMode>> possible;
    for (std::size_t k = 0; k < now.before.size(); ++k) {
        const double w = now.v(static_cast<Eigen::Index>(2 * k + 1)) - surface_velocity;
        if (!now.touches[k])
            possible.push_back({ContactMode::open});
        else if (now.is_at_rest[k])
            possible.push_back(
                {ContactMode::open, ContactMode::stick, ContactMode::slip_forward, ContactMode::slip_backward});
        else
            possible.push_back({ContactMode::open, integration::slip_mode(model::slip_of(w))});
    }
    return integration::contact_sets(possible, now.before);
}

// what the engine makes of the instant
std::optional<ContactSet> settled(const model::Structure& structure, const Instant& now) {
    const integration::ModalStructure modal = integration::modal_structure(structure);
    integration::Settling settling(modal, 2.0 / modal.fastest);
    const Eigen::VectorXd q = integration::modal(modal, structure, now.u),
                          v = integration::modal(modal, structure, now.v);
    integration::TaylorState state;
    state.q.assign(q.data(), q.data() + q.size());
    state.v.assign(v.data(), v.data() + v.size());
    state.dropped.resize(now.before.size());
    state.friction_states.resize(now.before.size());
    for (const std::size_t k : modal.number)
        state.set.push_back(now.before[k]);
    integration::SurfaceSeries surface{};
    surface[0] = surface_velocity;
    if (settling.settle(state, surface) != integration::Settled::done) return std::nullopt;
    ContactSet found(now.before.size());
    for (std::size_t m = 0; m < found.size(); ++m)
        found[modal.number[m]] = state.set[m];
    return found;
}

class LawfulSets : public testing::TestWithParam<std::size_t> {};

TEST_P(LawfulSets, AreOneAndTheEnginesAtEachEvent) {
    std::array<long, 4> lawful_sets{};
    long close = 0, other = 0, slips_begun = 0;
    const support::Runs runs = support::runs(support::effort(2000, 50));
    for (std::uint64_t number = runs.first; number < runs.first + runs.count; ++number) {
        CounterRandom random(7000000 + number);
        const model::Structure structure = random_structure(GetParam(), random);
        const Instant now = random_instant(structure, random);
        std::vector<ContactSet> lawful;
        bool is_close = false;
        for (const ContactSet& set : all_sets(now)) {
            const Finding finding = judged(structure, now, set);
            is_close = is_close || finding == Finding::too_close;
            if (finding == Finding::lawful) lawful.push_back(set);
        }
        if (is_close) {
            ++close;
            continue;
        }
        ++lawful_sets[std::min<std::size_t>(lawful.size(), 3)];
        const std::optional<ContactSet> found = settled(structure, now);
        const bool is_lawful = found && std::find(lawful.begin(), lawful.end(), *found) != lawful.end();
        if (!is_lawful) std::cout << "event " << number << ": another set, of " << lawful.size() << " lawful ones\n";
        if (!is_lawful) ++other;
        for (std::size_t k = 0; found && k < found->size(); ++k)
            if (now.is_at_rest[k] && is_slip((*found)[k])) ++slips_begun;
    }
    std::cout << "lawful sets: none " << lawful_sets[0] << ", one " << lawful_sets[1] << ", two " << lawful_sets[2]
              << ", more " << lawful_sets[3] << "; too close to tell " << close << "; slips begun " << slips_begun
              << "\n";
    EXPECT_EQ(other, 0);
    EXPECT_EQ(lawful_sets[0] + lawful_sets[2] + lawful_sets[3], 0);
    EXPECT_LT(100 * close, static_cast<long>(runs.count) + 100);
    EXPECT_GT(10 * slips_begun, static_cast<long>(runs.count));
}

INSTANTIATE_TEST_SUITE_P(Contacts, LawfulSets, testing::Values(2U, 3U));

}  // namespace
}  // namespace stridor
