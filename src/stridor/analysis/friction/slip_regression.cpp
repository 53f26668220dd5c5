// A law's numbers over mu_s are its shape: rho = mu_d/mu_s, sigma = s_mu/mu_s, v_s. Slip i lets go at the time t_i and
// the force F_i, and its friction is F_i times the shape: so whatever makes a slip's friction higher or lower is its
// own. With residuals r_i and their derivatives J_i over the shape and E_i over (t_i, F_i),
//
//     P_i = I - E_i (E_i' E_i)^-1 E_i'      A = sum J_i' P_i J_i      step = A^-1 sum J_i' P_i r_i
//
// mu_s is the mean of F_i/N_i. The influence of slip i on the shape is A^-1 J_i' P_i r_i; that on mu_s is its own
// deviation over n and what the shape does to all F_j. A number's variance is n/(n - p) times the sum of their squares,
// p being the count of numbers.

#include "stridor/analysis/friction/slip_regression.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace stridor::analysis {

namespace {

using parameters::Contact;

constexpr double no_squares = std::numeric_limits<double>::infinity();  // no sum of squares
constexpr double least_gain = 1e-7;  // [1] of the sum of squares: numbers are good to a hundredth of their deviation
constexpr int onsets_tried = 8;
constexpr int most_release_steps = 12;
constexpr double steps_per_swing = 80.0;  // of the rig, at least

// of one slip at a fit
struct SlipTerms {
    Eigen::VectorXd residual;
    Eigen::MatrixXd shape;  // J
    Eigen::MatrixXd own;    // E
};

struct ShapeNow {
    model::FrictionLaw law;
    MeasuringRig rig;
};

ShapeNow shape_now(const SlipModel& model, const std::vector<double>& shape) {
    Contact contact;
    contact.friction = model.kind;
    contact.static_friction = contact.kinetic_friction = 1.0;
    contact.friction_slope = 0.0;
    contact.stribeck_exponent = model.exponent;
    MeasuringRig rig = model.rig;
    for (std::size_t k = 0; k < shape.size(); ++k)
        switch (model.numbers[k]) {
            case ShapeNumber::ratio:
                contact.kinetic_friction = shape[k];
                break;
            case ShapeNumber::slope:
                contact.friction_slope = shape[k];
                break;
            case ShapeNumber::velocity:
                contact.stribeck_velocity = std::exp(shape[k]);
                break;
            case ShapeNumber::stiffness:
                rig.stiffness = std::exp(shape[k]);
                break;
            case ShapeNumber::mass:
                rig.mass = std::exp(shape[k]);
        }
    return {model::friction_law(contact), rig};
}

double step_of(const RecordedSlip& slip, const SlipModel& model) {
    // of the rig as it is first taken, so that a fit's steps do not change
    const double swing = 2.0 * std::numbers::pi * std::sqrt(model.rig.mass / model.rig.stiffness);
    return std::min(0.5 / slip.rate, swing / steps_per_swing);
}

SlipTrack track_of(const RecordedSlip& slip, const SlipModel& model, const ShapeNow& now, double onset, double limit) {
    std::vector<double> times(slip.force.size());
    for (std::size_t k = 0; k < times.size(); ++k)
        times[k] = static_cast<double>(k) / slip.rate - onset;
    return slip_track(now.law, now.rig, {slip.velocity, limit, step_of(slip, model)}, times);
}

double squares_of(const RecordedSlip& slip, const SlipTrack& track) {
    double sum = 0.0;
    for (std::size_t k = 0; k < slip.force.size(); ++k)
        sum += (slip.force[k] - track.force[k]) * (slip.force[k] - track.force[k]);
    return std::isfinite(sum) ? sum : no_squares;
}

SlipTerms terms_of(const RecordedSlip& slip, const SlipModel& model, const SlipFit& fit, std::size_t number) {
    const auto samples = static_cast<Eigen::Index>(slip.force.size());
    SlipTerms terms{Eigen::VectorXd(samples), Eigen::MatrixXd(samples, static_cast<Eigen::Index>(fit.shape.size())),
                    Eigen::MatrixXd(samples, 2)};
    const double onset = fit.onset[number], limit = fit.limit[number];
    const ShapeNow now = shape_now(model, fit.shape);
    const SlipTrack track = track_of(slip, model, now, onset, limit);
    const auto put = [&](auto column, const SlipTrack& moved, double by) {
        for (Eigen::Index k = 0; k < samples; ++k)
            column(k) = (moved.force[static_cast<std::size_t>(k)] - track.force[static_cast<std::size_t>(k)]) / by;
    };
    for (std::size_t j = 0; j < fit.shape.size(); ++j) {
        std::vector<double> shape = fit.shape;
        const double by = 1e-6;
        shape[j] += by;
        put(terms.shape.col(static_cast<Eigen::Index>(j)), track_of(slip, model, shape_now(model, shape), onset, limit),
            by);
    }
    const double by = 1e-6 * limit;
    put(terms.own.col(1), track_of(slip, model, now, onset, limit + by), by);
    for (Eigen::Index k = 0; k < samples; ++k) {
        const auto at = static_cast<std::size_t>(k);
        terms.own(k, 0) = -track.rate[at];
        terms.residual(k) = slip.force[at] - track.force[at];
    }
    return terms;
}

// what eliminating a slip's own numbers, damped, needs
struct Eliminated {
    Eigen::Matrix2d own_inverse;
    Eigen::MatrixXd coupling;  // (E'E)^-1 E'J
    Eigen::Vector2d own_step;  // (E'E)^-1 E'r
};

Eliminated eliminated(const SlipTerms& terms, double damping) {
    Eigen::Matrix2d own = terms.own.transpose() * terms.own;
    own(0, 0) *= 1.0 + damping;
    own(1, 1) *= 1.0 + damping;
    Eliminated result{own.inverse(), {}, {}};
    result.coupling = result.own_inverse * (terms.own.transpose() * terms.shape);
    result.own_step = result.own_inverse * (terms.own.transpose() * terms.residual);
    return result;
}

double squares_at(const std::vector<RecordedSlip>& slips, const SlipModel& model, const SlipFit& fit) {
    const ShapeNow now = shape_now(model, fit.shape);
    double sum = 0.0;
    for (std::size_t i = 0; i < slips.size(); ++i)
        sum += squares_of(slips[i], track_of(slips[i], model, now, fit.onset[i], fit.limit[i]));
    return sum;
}

double bounded(ShapeNumber number, double value) {
    if (number == ShapeNumber::ratio) return std::clamp(value, 0.0, 1.0);
    return number == ShapeNumber::slope ? std::max(0.0, value) : value;
}

// may a slip let go then, at this force? Far from it nothing is followed
bool is_within(const RecordedSlip& slip, double onset, double limit) {
    const double time = static_cast<double>(slip.force.size()) / slip.rate;
    return std::abs(onset - slip.onset) < time && limit > 0.5 * slip.limit && limit < 2.0 * slip.limit;
}

// one damped step from a fit; its squares are `no_squares` where it leads astray
SlipFit stepped(const std::vector<RecordedSlip>& slips, const SlipModel& model, const SlipFit& fit,
                const std::vector<SlipTerms>& terms, double damping) {
    const auto size = static_cast<Eigen::Index>(fit.shape.size());
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
    std::vector<Eliminated> own;
    for (const SlipTerms& each : terms) {
        own.push_back(eliminated(each, damping));
        const Eigen::MatrixXd mixed = each.shape.transpose() * each.own;
        normal += each.shape.transpose() * each.shape - mixed * own.back().coupling;
        right += each.shape.transpose() * each.residual - mixed * own.back().own_step;
    }
    normal.diagonal() *= 1.0 + damping;
    const Eigen::VectorXd step = normal.fullPivLu().solve(right);
    SlipFit moved = fit;
    Eigen::VectorXd taken(size);
    for (Eigen::Index j = 0; j < size; ++j) {
        const auto at = static_cast<std::size_t>(j);
        moved.shape[at] = bounded(model.numbers[at], fit.shape[at] + std::clamp(step(j), -1.0, 1.0));
        taken(j) = moved.shape[at] - fit.shape[at];
    }
    moved.squares = no_squares;
    for (std::size_t i = 0; i < slips.size(); ++i) {
        const Eigen::Vector2d change = own[i].own_step - own[i].coupling * taken;
        moved.onset[i] += change(0);
        moved.limit[i] += change(1);
        if (!is_within(slips[i], moved.onset[i], moved.limit[i])) return moved;
    }
    moved.squares = squares_at(slips, model, moved);
    return moved;
}

// the release of one slip that suits a shape best: first among times that lie two samples apart, as friction that falls
// softly lets the force fall long after it
void set_release(SlipFit& fit, const RecordedSlip& slip, const SlipModel& model, const ShapeNow& now, std::size_t i) {
    const auto squares_with = [&](double onset, double limit) {
        return squares_of(slip, track_of(slip, model, now, onset, limit));
    };
    double least = no_squares;
    for (int k = 0; k < onsets_tried; ++k) {
        const double earlier = 2.0 * k / slip.rate, limit = slip.limit - slip.climb * earlier;
        const double squares = squares_with(slip.onset - earlier, limit);
        if (!(squares < least)) continue;
        least = squares;
        fit.onset[i] = slip.onset - earlier;
        fit.limit[i] = limit;
    }
    double damping = 1e-3;
    for (int turn = 0; turn < most_release_steps; ++turn) {
        const SlipTrack track = track_of(slip, model, now, fit.onset[i], fit.limit[i]);
        const double by = 1e-6 * fit.limit[i];
        const SlipTrack moved = track_of(slip, model, now, fit.onset[i], fit.limit[i] + by);
        Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
        Eigen::Vector2d right = Eigen::Vector2d::Zero();
        for (std::size_t k = 0; k < slip.force.size(); ++k) {
            const Eigen::Vector2d row(-track.rate[k], (moved.force[k] - track.force[k]) / by);
            normal += row * row.transpose();
            right += row * (slip.force[k] - track.force[k]);
        }
        normal.diagonal() *= 1.0 + damping;
        const Eigen::Vector2d step = normal.inverse() * right;
        const double onset = fit.onset[i] + step(0), limit = fit.limit[i] + step(1);
        const double squares = is_within(slip, onset, limit) ? squares_with(onset, limit) : no_squares;
        damping *= squares < least ? 0.1 : 10.0;
        if (!(squares < least)) continue;
        const bool is_done = least - squares < 1e-3 * squares;
        least = squares;
        fit.onset[i] = onset;
        fit.limit[i] = limit;
        if (is_done) break;
    }
}

}  // namespace

SlipFit released(const std::vector<RecordedSlip>& slips, const SlipModel& model, std::vector<double> shape) {
    SlipFit fit{std::move(shape), std::vector<double>(slips.size()), std::vector<double>(slips.size())};
    const ShapeNow now = shape_now(model, fit.shape);
    for (std::size_t i = 0; i < slips.size(); ++i)
        set_release(fit, slips[i], model, now, i);
    return fit;
}

SlipFit refined(const std::vector<RecordedSlip>& slips, const SlipModel& model, SlipFit fit, int most_steps) {
    fit.squares = squares_at(slips, model, fit);
    double damping = 1e-2;
    for (int turn = 0; turn < most_steps; ++turn) {
        std::vector<SlipTerms> terms;
        for (std::size_t i = 0; i < slips.size(); ++i)
            terms.push_back(terms_of(slips[i], model, fit, i));
        double gain = 0.0;
        for (int attempt = 0; attempt < 8 && gain == 0.0; ++attempt) {
            SlipFit moved = stepped(slips, model, fit, terms, damping);
            const bool is_better = moved.squares < fit.squares;
            damping *= is_better ? 0.1 : 10.0;
            if (!is_better) continue;
            gain = fit.squares - moved.squares;
            fit = std::move(moved);
        }
        if (!(gain > least_gain * fit.squares)) break;
    }
    return fit;
}

SlipDeviations deviations_of(const std::vector<RecordedSlip>& slips, const SlipModel& model, const SlipFit& fit) {
    const auto count = static_cast<Eigen::Index>(slips.size()), size = static_cast<Eigen::Index>(fit.shape.size());
    SlipDeviations found{Eigen::VectorXd(count), Eigen::VectorXd(count), Eigen::MatrixXd::Zero(count, size), {}};
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd follows = Eigen::VectorXd::Zero(size);  // of mu_s, what the shape moves it by
    for (Eigen::Index i = 0; i < count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const SlipTerms terms = terms_of(slips[at], model, fit, at);
        const Eliminated own = eliminated(terms, 0.0);
        const Eigen::MatrixXd mixed = terms.shape.transpose() * terms.own;
        normal += terms.shape.transpose() * terms.shape - mixed * own.coupling;
        found.shape.row(i) = (terms.shape.transpose() * terms.residual - mixed * own.own_step).transpose();
        follows -= own.coupling.row(1).transpose() / slips[at].normal_force / static_cast<double>(count);
        found.ratios(i) = fit.limit[at] / slips[at].normal_force;
        found.residuals.emplace_back(terms.residual.data(), terms.residual.data() + terms.residual.size());
    }
    const Eigen::MatrixXd inverse = normal.fullPivLu().inverse();
    const Eigen::MatrixXd pulls = found.shape * inverse;
    found.shape = pulls.rowwise() - pulls.colwise().mean();
    const Eigen::VectorXd apart = found.ratios - Eigen::VectorXd::Constant(count, found.ratios.mean());
    found.limits = apart / static_cast<double>(count) + found.shape * follows;
    return found;
}

}  // namespace stridor::analysis
