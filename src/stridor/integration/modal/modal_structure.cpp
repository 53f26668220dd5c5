#include "stridor/integration/modal/modal_structure.hpp"

#include "stridor/base/decompositions.hpp"
#include "stridor/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace stridor::integration {

namespace {

constexpr double symmetry_rounding = 1e-10;  // [1] of the largest entry
constexpr double diagonal_rounding = 1e-13;  // [1] likewise: what a transform leaves beside the diagonal

std::vector<double> numbers_of(const Eigen::VectorXd& vector) {
    return {vector.data(), vector.data() + vector.size()};
}

void require_symmetric(const Eigen::MatrixXd& matrix, const char* name) {
    const double most = matrix.cwiseAbs().maxCoeff();
    if ((matrix - matrix.transpose()).cwiseAbs().maxCoeff() > symmetry_rounding * most || !matrix.allFinite())
        throw Error(ErrorKind::input, {std::string("the ") + name + " matrix is not symmetric",
                                       "both halves of it must be given, or one half said to be all", ""});
}

ModalContact modal_contact(const model::ContactPoint& contact, const Eigen::MatrixXd& shapes) {
    ModalContact result;
    result.normal = numbers_of(shapes.transpose() * contact.normal);
    result.tangent = numbers_of(shapes.transpose() * contact.tangent);
    if (model::has_two_tangents(contact)) {
        result.second_tangent = numbers_of(shapes.transpose() * contact.second_tangent);
        result.second_drive_share = contact.second_drive_share;
    }
    result.initial_gap = contact.initial_gap;
    result.drive_share = contact.drive_share;
    result.friction = contact.friction;
    result.rest = contact.rest;
    if (has_friction_state(contact.friction)) result.creep_speed = contact.creep_speed;
    return result;
}

Eigen::MatrixXd compliance_of(const std::vector<ModalContact>& contacts, std::size_t modes) {
    Eigen::MatrixXd rows(2 * contacts.size(), modes);
    for (std::size_t k = 0; k < contacts.size(); ++k)
        for (std::size_t j = 0; j < modes; ++j) {
            rows(static_cast<Eigen::Index>(2 * k), static_cast<Eigen::Index>(j)) = contacts[k].normal[j];
            rows(static_cast<Eigen::Index>(2 * k + 1), static_cast<Eigen::Index>(j)) = contacts[k].tangent[j];
        }
    return rows * rows.transpose();
}

template <typename Term>
double sum_of_terms(std::size_t count, Term term) {
    constexpr std::size_t lanes = 8;
    double sum[lanes] = {};
    std::size_t j = 0;
    for (; j + lanes <= count; j += lanes)
        for (std::size_t lane = 0; lane < lanes; ++lane)
            sum[lane] += term(j + lane);
    for (std::size_t lane = 0; j < count; ++j, ++lane)
        sum[lane] += term(j);
    return ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
}

}  // namespace

ContactRowPlan row_plan(const std::vector<ModalContact>& contacts) {
    ContactRowPlan plan;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        plan.first.push_back(plan.rows());
        plan.contact.insert(plan.contact.end(), contacts[k].second_tangent.empty() ? 2 : 3, k);
    }
    plan.first.push_back(plan.rows());
    return plan;
}

std::span<const double> row_of(const std::vector<ModalContact>& contacts, const ContactRowPlan& plan, std::size_t row) {
    const ModalContact& contact = contacts[plan.contact[row]];
    const std::size_t place = row - plan.first[plan.contact[row]];
    return place == 0 ? contact.normal : place == 1 ? contact.tangent : contact.second_tangent;
}

double drive_share_of(const std::vector<ModalContact>& contacts, const ContactRowPlan& plan, std::size_t row) {
    const ModalContact& contact = contacts[plan.contact[row]];
    const std::size_t place = row - plan.first[plan.contact[row]];
    return place == 0 ? 0.0 : place == 1 ? contact.drive_share : contact.second_drive_share;
}

double dot(std::span<const double> a, std::span<const double> b) {
    return sum_of_terms(a.size(), [&](std::size_t j) { return a[j] * b[j]; });
}

double dot_of_sizes(std::span<const double> a, std::span<const double> b) {
    return sum_of_terms(a.size(), [&](std::size_t j) { return std::abs(a[j] * b[j]); });
}

double elongation(const ModalSpring& spring, std::span<const double> q) {
    return dot(spring.row, q) + spring.rest;
}

double elongation_size(const ModalSpring& spring, std::span<const double> q) {
    return dot_of_sizes(spring.row, q) + std::abs(spring.rest);
}

double gap(const ModalContact& contact, std::span<const double> q) {
    return dot(contact.normal, q) + contact.initial_gap;
}

double gap_velocity(const ModalContact& contact, std::span<const double> v) {
    return dot(contact.normal, v);
}

double slip_velocity(const ModalContact& contact, std::span<const double> v, double surface_velocity) {
    return dot(contact.tangent, v) - contact.drive_share * surface_velocity;
}

ModalStructure modal_structure(const model::Structure& structure) {
    require_symmetric(structure.mass, "mass");
    require_symmetric(structure.stiffness, "stiffness");
    require_symmetric(structure.damping, "damping");
    const Eigen::LLT<Eigen::MatrixXd> factor(structure.mass);
    if (factor.info() != Eigen::Success)
        throw Error(ErrorKind::input,
                    {"the mass matrix is not positive definite", "some motion of the structure would have no inertia",
                     "Give every degree of freedom a mass, or remove those without."});
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(structure.stiffness, structure.mass);
    return in_modes(structure, solver.eigenvectors(), solver.eigenvalues());
}

ModalStructure in_modes(const model::Structure& structure, const Eigen::MatrixXd& shapes,
                        const Eigen::VectorXd& square_frequency) {
    ModalStructure modal;
    modal.shapes = shapes;
    modal.channels = structure.measured.size() == 0 ? modal.shapes : structure.measured * modal.shapes;
    modal.square_frequency = numbers_of(square_frequency);
    modal.load = numbers_of(modal.shapes.transpose() * structure.load);
    const Eigen::MatrixXd damping = modal.shapes.transpose() * structure.damping * modal.shapes;
    const Eigen::MatrixXd beside = damping - Eigen::MatrixXd(damping.diagonal().asDiagonal());
    const double most = damping.cwiseAbs().maxCoeff();
    modal.damping = beside.cwiseAbs().maxCoeff() <= diagonal_rounding * most
                        ? numbers_of(damping.diagonal())
                        : std::vector<double>(damping.data(), damping.data() + damping.size());
    for (const std::size_t k : model::canonical_order(structure)) {
        modal.contacts.push_back(modal_contact(structure.contacts[k], modal.shapes));
        modal.number.push_back(k);
    }
    for (const model::Spring& spring : structure.springs)
        modal.springs.push_back({numbers_of(modal.shapes.transpose() * spring.direction), spring.law, spring.rest});
    modal.compliance = compliance_of(modal.contacts, modal.modes());
    const double square = std::max(std::abs(modal.square_frequency.front()), modal.square_frequency.back());
    modal.fastest = 1.1 * std::sqrt(square) + damping.cwiseAbs().rowwise().sum().maxCoeff();
    return modal;
}

std::vector<std::size_t> numbered(const ModalStructure& structure, const std::vector<std::size_t>& contacts) {
    std::vector<std::size_t> numbers;
    for (const std::size_t k : contacts)
        numbers.push_back(structure.number[k]);
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

Eigen::VectorXd modal(const ModalStructure& modal, const model::Structure& structure, const Eigen::VectorXd& u) {
    return modal.shapes.transpose() * (structure.mass * u);
}

std::vector<double> padded(const Eigen::VectorXd& x, std::size_t size) {
    std::vector<double> numbers(size, 0.0);
    std::copy_n(x.data(), x.size(), numbers.begin());
    return numbers;
}

bool is_finite(std::span<const double> q, std::span<const double> v) {
    double sum = 0.0;
    for (std::size_t j = 0; j < q.size(); ++j)
        sum += q[j] * 0.0 + v[j] * 0.0;
    return sum == 0.0;
}

}  // namespace stridor::integration
