// Moreau's time stepping with an exact free structure. A step from n to n+1:
//
//     q*, v*   the free structure's exact motion under the load (`FreePropagation`)
//     touching those closed before, and those open with g* = n.q* + g0 <= 0
//     N, T     constant in the step, so that (g', w) at its end = (n.v*, t.v* - V) + W_h (N, T) obey the laws
//     q, v     = q*, v* + what constant N, T do in a step
//
// A contact that closes has a gap of the size of the step's travel; it is set to zero, and so is every 64 steps what
// has gathered in closed gaps: q -= n W_nn⁻¹ g over all closed contacts, at right angles under the mass.

#include "stridor/integration/steps/moreau.hpp"

#include "stridor/integration/rules/contact_mode_of.hpp"
#include "stridor/integration/rules/expect_solvable.hpp"
#include "stridor/integration/run/imposed_motion.hpp"
#include "stridor/integration/run/step_loop.hpp"
#include "stridor/integration/steps/moreau_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace stridor::integration {

namespace {

constexpr long steps_between_projections = 64;
constexpr double closed_rounding = 1e-9;  // [1] of a gap's terms: closed at the start
constexpr double still_rounding = 1e-12;
constexpr std::size_t modes_per_watched_step = 16;  // velocities of all degrees of freedom cost modes² operations

// what contacts do at the start, from their gaps and velocities
std::vector<ContactMode> first_set(const ModalStructure& structure, const std::vector<double>& q,
                                   const std::vector<double>& v, double surface_velocity) {
    std::vector<ContactMode> set;
    const std::size_t n = structure.modes();
    for (const ModalContact& c : structure.contacts) {
        // of a slip in a plane the first step finds the direction
        const double second = std::abs(c.second_tangent.empty() ? 0.0 : dot(c.second_tangent, {v.data(), n}));
        const double size = dot_of_sizes(c.normal, {q.data(), n}) + std::abs(c.initial_gap);
        const double w = slip_velocity(c, {v.data(), n}, surface_velocity);
        const double speed = dot_of_sizes(c.tangent, {v.data(), n}) + std::abs(c.drive_share * surface_velocity);
        if (gap(c, {q.data(), n}) > closed_rounding * size)
            set.push_back(ContactMode::open);
        else
            set.push_back(std::abs(w) + second > still_rounding * speed ? slip_mode(model::slip_of(w))
                                                                        : ContactMode::stick);
    }
    return set;
}

Eigen::MatrixXd normal_part(const Eigen::MatrixXd& compliance) {
    const Eigen::Index p = compliance.rows() / 2;
    Eigen::MatrixXd part(p, p);
    for (Eigen::Index a = 0; a < p; ++a)
        for (Eigen::Index b = 0; b < p; ++b)
            part(a, b) = compliance(2 * a, 2 * b);
    return part;
}

}  // namespace

double longest_step(const ModalStructure& structure) {
    const double square = structure.square_frequency.back();
    return square > 0.0 ? std::numbers::pi / std::sqrt(square) : std::numeric_limits<double>::infinity();
}

MoreauRun::MoreauRun(const model::Structure& structure, ModalStructure modal_one, const parameters::Drive& drive,
                     const InitialState& start, double step, record::Recorder& recorder)
    : whole_(structure),
      structure_(std::move(modal_one)),
      step_(step),
      motion_(drive, step, record::end_of(recorder.schedule())),
      drive_(drive),
      recorder_(recorder),
      propagation_(structure_, step),
      rows_(structure_),
      contacts_(structure_, propagation_.response(),
                first_set(structure_, padded(modal(structure_, structure, start.displacement), rows_.padded_modes()),
                          padded(modal(structure_, structure, start.velocity), rows_.padded_modes()),
                          motion_.at(0.0).velocity)),
      closing_(normal_part(structure_.compliance)),
      q_(padded(modal(structure_, structure, start.displacement), rows_.padded_modes())),
      v_(padded(modal(structure_, structure, start.velocity), rows_.padded_modes())),
      q_before_(q_),
      v_before_(v_),
      push_(q_.size(), 0.0),
      scratch_(push_),
      set_(contacts_.set()),
      touches_(set_.size(), 0),
      touched_(set_.size(), 0),
      rates_(rows_.plan().rows(), 0.0),
      free_rates_(rates_),
      products_(rates_),
      forces_(rates_),
      watch_every_(static_cast<long>(1 + structure_.modes() / modes_per_watched_step)),
      vibration_(static_cast<std::size_t>(model::channels_of(structure))),
      load_(structure.contacts.size()),
      travel_{q_, std::vector<double>(structure_.modes(), 0.0), std::vector<double>(structure_.modes(), 0.0)} {
    for (std::size_t row = 0; row < rates_.size(); ++row)
        share_.push_back(drive_share_of(structure_.contacts, rows_.plan(), row));
    if (structure.shaken.size() != 0)
        shaken_ = padded(structure_.shapes.transpose() * structure.shaken, rows_.padded_modes());
    surface_velocity_ = motion_.at(0.0).velocity;
    dashpot_power_ = dashpot_power(structure_, v_);
    initial_energy_ = stored_energy(structure_, q_, v_);
}

// who takes part: the closed ones, and the open ones whose gap would close
void MoreauRun::find_touching() {
    const std::vector<std::size_t>& first = rows_.plan().first;
    which_.clear();
    for (std::size_t k = 0; k < set_.size(); ++k)
        if (set_[k] == ContactMode::open) which_.push_back(first[k]);
    if (!which_.empty()) rows_.multiply(which_, q_, products_);
    for (std::size_t k = 0; k < set_.size(); ++k)
        touches_[k] =
            set_[k] != ContactMode::open || products_[first[k]] + structure_.contacts[k].initial_gap <= 0.0 ? 1 : 0;
}

// puts the rows of a contact into those that are asked for
void MoreauRun::ask_for(std::size_t contact) {
    for (std::size_t row = rows_.plan().first[contact]; row < rows_.plan().first[contact + 1]; ++row)
        which_.push_back(row);
}

// takes the surface's velocity from the rates at tangents
void MoreauRun::subtract_surface(double velocity, std::vector<double>& rates) const {
    for (const std::size_t row : which_)
        if (!rows_.plan().is_normal(row)) rates[row] -= share_[row] * velocity;
}

// rates of those that take part: at the free end, and where they are not known at the begin, too
void MoreauRun::find_free_rates(double surface_velocity) {
    which_.clear();
    for (std::size_t k = 0; k < set_.size(); ++k)
        if (touches_[k] != 0 && touched_[k] == 0) ask_for(k);
    if (!which_.empty()) {
        rows_.multiply(which_, v_before_, rates_);
        subtract_surface(surface_velocity_, rates_);
    }
    which_.clear();
    for (std::size_t k = 0; k < set_.size(); ++k)
        if (touches_[k] != 0) ask_for(k);
    std::fill(free_rates_.begin(), free_rates_.end(), 0.0);
    if (!which_.empty()) rows_.multiply(which_, v_, free_rates_);
    subtract_surface(surface_velocity, free_rates_);
}

// sets the gaps of closed contacts to zero
void MoreauRun::project() {
    const std::vector<ContactMode>& set = contacts_.set();
    which_.clear();
    for (std::size_t k = 0; k < set.size(); ++k) {
        const bool is_closed = set[k] != ContactMode::open;
        if (is_closed) which_.push_back(rows_.plan().first[k]);
        if (closing_.is_exchanged(k) != is_closed) closing_.exchange(k);
    }
    if (which_.empty()) return;
    rows_.multiply(which_, q_, products_);
    std::vector<double> gaps(set.size(), 0.0), share(products_.size(), 0.0);
    for (const std::size_t row : which_)
        gaps[rows_.plan().contact[row]] = products_[row] + structure_.contacts[rows_.plan().contact[row]].initial_gap;
    closing_.set(gaps);
    for (const std::size_t row : which_)
        share[row] = closing_.follows(rows_.plan().contact[row]);
    const double before = elastic();
    rows_.combine(which_, share, scratch_);
    for (std::size_t j = 0; j < q_.size(); ++j)
        q_[j] += scratch_[j];
    work_.impact_loss += before - elastic();
}

// the force in the middle of the step, as if it were that all the time
void MoreauRun::shake() {
    force_ = imposed_force(drive_, (static_cast<double>(n_) + 0.5) * step_);
    for (std::size_t j = 0; j < shaken_.size(); ++j)
        scratch_[j] = force_ * shaken_[j];
    propagation_.push(scratch_, q_, v_);
}

// one step; returns false if no contact forces obey the laws
bool MoreauRun::advance() {
    const double end_velocity = motion_.at(static_cast<double>(n_ + 1) * step_).velocity;
    q_before_ = q_;
    v_before_ = v_;
    propagation_.advance(q_, v_);
    if (!shaken_.empty()) shake();
    find_touching();
    find_free_rates(end_velocity);
    if (!contacts_.solve(free_rates_, touches_)) return false;
    const std::vector<ContactMode>& set = contacts_.set();
    if (set != set_) press();
    which_.clear();
    bool has_closed = false;
    for (std::size_t k = 0; k < set.size(); ++k) {
        for (std::size_t row = rows_.plan().first[k]; row < rows_.plan().first[k + 1]; ++row)
            forces_[row] = contacts_.force(row);
        if (set[k] == ContactMode::open) continue;
        ask_for(k);
        has_closed = has_closed || set_[k] == ContactMode::open;
    }
    rows_.combine(which_, forces_, push_);
    propagation_.push(push_, q_, v_);
    note(surface_velocity_, end_velocity);
    if (has_closed || n_ % steps_between_projections == 0) project();
    has_impact_ = has_closed;
    surface_velocity_ = end_velocity;
    touched_ = touches_;
    set_ = set;
    ++n_;
    return true;
}

Outcome MoreauRun::without_forces() {
    pressed_ = numbered(structure_, contacts_.pressed(touches_));
    return {pressed_.empty() ? Reason::no_forces : Reason::painleve, time()};
}

void MoreauRun::begin_span() {
    std::fill(vibration_.begin(), vibration_.end(), record::Vibration());
    std::fill(load_.begin(), load_.end(), record::Load());
    press();
    watched_ = 0;
}

void MoreauRun::end_span(std::size_t span, long, double length) {
    if (watched_ == 0) watch();  // a span between two steps has the velocities of the next one
    for (record::Vibration& sum : vibration_)
        sum.square_time *= length / static_cast<double>(watched_);
    recorder_.vibrate(span, length, vibration_);
    press();
    recorder_.load(span, load_);
}

Outcome MoreauRun::run(const std::stop_token& stop) {
    const auto go = [&](long end, record::Use use, StepSamples& samples) {
        return step_to(*this, end, use, samples, stop);
    };
    if (const auto ended = run_spans(*this, recorder_, step_, go)) return *ended;
    return is_finite() ? Outcome{Reason::completed, time()} : Outcome{Reason::diverged, time()};
}

Motion integrate_moreau(const model::Structure& structure, const parameters::Drive& drive, const InitialState& start,
                        const Moreau& settings, record::Recorder recorder, const std::stop_token& stop) {
    expect_solvable(structure, parameters::Method::moreau);
    ModalStructure modal = modal_structure(structure);
    if (settings.step > longest_step(modal)) return {{Reason::step_limit, 0.0}, {}, recorder.finish(0.0)};
    MoreauRun runner(structure, std::move(modal), drive, start, settings.step, recorder);
    const Outcome ended = runner.run(stop);
    const EnergyBalance balance = runner.energy();
    const Outcome outcome = weighed(ended, balance, std::numeric_limits<double>::infinity());
    Motion motion{outcome, balance, recorder.finish(outcome.time, runner.outlooks(outcome))};
    motion.pressed = runner.pressed();
    return motion;
}

}  // namespace stridor::integration
