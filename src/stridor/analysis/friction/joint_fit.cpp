// With the numbers b of a law by the slips, their covariance C, and the steady points y_p with weights w,
//
//     Q(theta) = sum w (y_p - law(theta, speed_p))^2 + (theta - b)' C^-1 (theta - b)
//
// is least at the law of both, and its curvature is the inverse covariance there. v_s is taken by its logarithm, as the
// slips have it. Akaike's criterion of the slips grows by the second sum, and that of the points is added: they are
// independent, and each number counts once.

#include "stridor/analysis/friction/joint_fit.hpp"

#include "stridor/analysis/friction/regression.hpp"
#include "stridor/analysis/friction/slip_fit.hpp"
#include "stridor/base/decompositions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace stridor::analysis {

namespace {

using parameters::Contact;

constexpr int most_joint_steps = 60;
constexpr double joint_difference = 1e-6;  // [1] of a number, for the slopes of the law over it

// what the steady points say
struct SteadyPoints {
    const std::vector<FrictionPoint>& points;
    double weight = 1.0;       // [1] over variance, of one
    double independent = 1.0;  // [1]
};

// the numbers of a law that are free, and where a contact keeps them
struct JointNumbers {
    std::vector<double Contact::*> members;
    Eigen::VectorXd slips;    // by the slips
    Eigen::MatrixXd inverse;  // of their covariance
};

bool is_by_logarithm(double Contact::*member) {
    return member == &Contact::stribeck_velocity;
}

Contact contact_with(Contact contact, const JointNumbers& numbers, const Eigen::VectorXd& values) {
    for (std::size_t k = 0; k < numbers.members.size(); ++k) {
        const double value = values(static_cast<Eigen::Index>(k));
        contact.*numbers.members[k] = is_by_logarithm(numbers.members[k]) ? std::exp(value) : std::max(0.0, value);
    }
    contact.static_friction = std::max(contact.static_friction, contact.kinetic_friction);
    return contact;
}

Eigen::VectorXd frictions(const FittedLaw& law, const JointNumbers& numbers, const Eigen::VectorXd& values,
                          const SteadyPoints& steady) {
    FittedLaw there;
    there.contact = contact_with(law.contact, numbers, values);
    Eigen::VectorXd all(static_cast<Eigen::Index>(steady.points.size()));
    for (Eigen::Index k = 0; k < all.size(); ++k)
        all(k) = friction_at(there, steady.points[static_cast<std::size_t>(k)]);
    return all;
}

JointNumbers joint_numbers(const FittedLaw& law) {
    JointNumbers numbers;
    for (const FittedNumber& number : law.numbers)
        if (number.member != &Contact::stribeck_exponent) numbers.members.push_back(number.member);
    const auto size = static_cast<Eigen::Index>(numbers.members.size());
    numbers.slips.resize(size);
    for (Eigen::Index k = 0; k < size; ++k) {
        double Contact::*const member = numbers.members[static_cast<std::size_t>(k)];
        numbers.slips(k) = is_by_logarithm(member) ? std::log(law.contact.*member) : law.contact.*member;
    }
    const Eigen::MatrixXd covariance = Eigen::Map<const Eigen::MatrixXd>(law.covariance.data(), size, size);
    numbers.inverse = covariance.fullPivLu().inverse();
    return numbers;
}

// the law of both, from that of the slips
FittedLaw joint_law(FittedLaw law, const SteadyPoints& steady, double slips) {
    const JointNumbers numbers = joint_numbers(law);
    const Eigen::Index size = numbers.slips.size();
    Eigen::VectorXd measured(static_cast<Eigen::Index>(steady.points.size()));
    for (Eigen::Index k = 0; k < measured.size(); ++k)
        measured(k) = steady.points[static_cast<std::size_t>(k)].friction;
    const auto apart = [&](const Eigen::VectorXd& values) {
        const Eigen::VectorXd away = values - numbers.slips;
        return away.dot(numbers.inverse * away);
    };
    const auto cost = [&](const Eigen::VectorXd& values) {
        return steady.weight * (measured - frictions(law, numbers, values, steady)).squaredNorm() + apart(values);
    };
    Eigen::VectorXd values = numbers.slips;
    Eigen::MatrixXd curvature = numbers.inverse;
    double least = cost(values), damping = 1e-3;
    for (int turn = 0; turn < most_joint_steps; ++turn) {
        const Eigen::VectorXd here = frictions(law, numbers, values, steady);
        Eigen::MatrixXd slopes(measured.size(), size);
        for (Eigen::Index k = 0; k < size; ++k) {
            Eigen::VectorXd moved = values;
            const double by = joint_difference * std::max(1e-3, std::abs(values(k)));
            moved(k) += by;
            slopes.col(k) = (frictions(law, numbers, moved, steady) - here) / by;
        }
        curvature = steady.weight * slopes.transpose() * slopes + numbers.inverse;
        const Eigen::VectorXd pull =
            steady.weight * (slopes.transpose() * (measured - here)) - numbers.inverse * (values - numbers.slips);
        Eigen::MatrixXd damped = curvature;
        damped.diagonal() *= 1.0 + damping;
        const Eigen::VectorXd next = values + damped.fullPivLu().solve(pull);
        const double found = cost(next);
        damping *= found < least ? 0.1 : 10.0;
        if (!(found < least)) {
            if (damping > 1e8) break;
            continue;
        }
        const bool is_done = least - found < 1e-9 * found;
        values = next;
        least = found;
        if (is_done) break;
    }
    const Eigen::MatrixXd covariance = curvature.fullPivLu().inverse();
    law.contact = contact_with(law.contact, numbers, values);
    law.residuals.clear();
    const Eigen::VectorXd left = measured - frictions(law, numbers, values, steady);
    law.residuals.assign(left.data(), left.data() + left.size());
    const double t = student_975(std::max(1.0, slips - static_cast<double>(size)));
    for (Eigen::Index k = 0; k < size; ++k) {
        double Contact::*const member = numbers.members[static_cast<std::size_t>(k)];
        const double half = t * std::sqrt(covariance(k, k));
        const std::pair<double, double> interval =
            is_by_logarithm(member) ? std::pair{std::exp(values(k) - half), std::exp(values(k) + half)}
                                    : std::pair{std::max(0.0, values(k) - half), values(k) + half};
        for (FittedNumber& number : law.numbers)
            if (number.member == member) number = number_called(member, law.contact.*member, interval);
    }
    const auto points = static_cast<double>(steady.points.size());
    law.criterion += apart(values) + steady.independent * std::log(left.squaredNorm() / points);
    law.deviation = std::sqrt(left.squaredNorm() / points);
    return law;
}

}  // namespace

FrictionFit fit_of_both(FrictionPoints data, const MeasuringRig& rig, std::optional<double> exponent) {
    FrictionPoints sliding = data, slipping = data;
    sliding.slips.clear();
    slipping.points.clear();
    const FrictionFit steady_fit = friction_fit(std::move(sliding));
    const auto points = static_cast<double>(data.points.size());
    const FittedLaw& bearing = steady_fit.laws[steady_fit.best];
    const double variance = bearing.deviation * bearing.deviation * points /
                            std::max(1.0, points - static_cast<double>(bearing.free_numbers));
    const SteadyPoints steady{data.points, steady_fit.independent / points / variance, steady_fit.independent};
    FrictionFit fit;
    for (const double each : {1.0, 2.0}) {
        if (exponent && each != *exponent) continue;
        const FrictionFit slips = fit_of_slips(slipping, rig, each);
        fit.slips = slips.slips;
        fit.independent = steady_fit.independent + slips.independent;
        fit.data.slips = slips.data.slips;
        for (const FittedLaw& law : slips.laws) {
            FittedLaw joint = joint_law(law, steady, static_cast<double>(slips.slips));
            const auto same = std::find_if(fit.laws.begin(), fit.laws.end(),
                                           [&](const FittedLaw& other) { return other.kind == law.kind; });
            if (same == fit.laws.end())
                fit.laws.push_back(std::move(joint));
            else if (joint.criterion < same->criterion)
                *same = std::move(joint);
        }
        fit.unfitted = slips.unfitted;
    }
    fit.speeds = steady_fit.speeds;
    std::vector<RecordedSlip> slips = std::move(fit.data.slips);
    fit.data = std::move(data);
    fit.data.slips = std::move(slips);
    return fit;
}

}  // namespace stridor::analysis
