#pragma once

#include "stridor/model/laws/spring.hpp"
#include "stridor/model/structure.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <vector>

namespace stridor::integration {

/// A contact as the modes of its structure see it.
struct ModalContact {
    std::vector<double> normal;   // [1/√kg] n, shape [mode]
    std::vector<double> tangent;  // [1/√kg] t, shape [mode]
    double initial_gap = 0.0;     // [m] g0
    double drive_share = 1.0;     // [1] of V(t)
    model::FrictionLaw friction{};
    std::vector<double> second_tangent{};  // [1/√kg] shape [mode]; empty: slip has one direction
    double second_drive_share = 0.0;       // [1] of V(t) along it
    model::RestGrowth rest{};              // of its static friction
    double creep_speed = 0.0;              // [m/s] below which a slip counts as a stick; 0: never
};

/// A spring as the modes of its structure see it.
struct ModalSpring {
    std::vector<double> row;  // [1/√kg] of its elongation, shape [mode]
    model::SpringLaw law{};
    double rest = 0.0;  // [m] its elongation where q = 0
};

/// Where normals and tangents of contacts stand in one list of rows: n0, t0, n1, t1, ...; a second tangent stands
/// behind the first.
struct ContactRowPlan {
    std::vector<std::size_t> first;    // row of each contact's normal, and behind them the number of rows
    std::vector<std::size_t> contact;  // of each row

    std::size_t rows() const { return contact.size(); }
    bool is_normal(std::size_t row) const { return first[contact[row]] == row; }
    bool has_two_tangents(std::size_t k) const { return first[k + 1] - first[k] > 2; }
};
ContactRowPlan row_plan(const std::vector<ModalContact>& contacts);

/// Returns the normal or tangent [1/√kg] at a row, shape [mode], and the share of V(t) that the surface has along it
/// [1].
std::span<const double> row_of(const std::vector<ModalContact>& contacts, const ContactRowPlan& plan, std::size_t row);
double drive_share_of(const std::vector<ModalContact>& contacts, const ContactRowPlan& plan, std::size_t row);

/// Returns sum of products [1], and that of their sizes: what rounding works on. Eight sums side by side that do not
/// wait for each other become one at the end.
double dot(std::span<const double> a, std::span<const double> b);
double dot_of_sizes(std::span<const double> a, std::span<const double> b);

/// Returns the elongation of a spring [m] from coordinates, and the sum of its terms' sizes, which rounding works on.
double elongation(const ModalSpring& spring, std::span<const double> q);
double elongation_size(const ModalSpring& spring, std::span<const double> q);

/// Returns the gap [m], its rate [m/s] and the slip velocity [m/s] of a contact, from coordinates or their rates and
/// the surface's velocity [m/s].
double gap(const ModalContact& contact, std::span<const double> q);
double gap_velocity(const ModalContact& contact, std::span<const double> v);
double slip_velocity(const ModalContact& contact, std::span<const double> v, double surface_velocity);

/// A structure in the coordinates of its free eigenmodes, u = Φ q with Φ'M Φ = 1 and Φ'K Φ = diag(ω²):
///
///     q'' = f - ω² q - C q' - Σ d F(e0 + d.q) + Σ (n N + t T)
///
/// Its contacts stand in an order of their own, by their rows, so that results do not depend on how a user numbers
/// them.
struct ModalStructure {
    Eigen::MatrixXd shapes;                // [1/√kg] Φ, shape [dof][mode]
    Eigen::MatrixXd channels;              // [1/√kg] their velocities from those of the modes, shape [channel][mode]
    std::vector<double> square_frequency;  // [rad²/s²] ω², shape [mode], rising
    std::vector<double> damping;           // [1/s] C, shape [mode] if it is diagonal, else [mode][mode]
    std::vector<double> load;              // [N/√kg] f, shape [mode]
    std::vector<ModalContact> contacts;
    std::vector<ModalSpring> springs;
    std::vector<std::size_t> number;  // of each contact in the structure's list
    Eigen::MatrixXd compliance;       // [1/kg] W, rows and columns n0, t0, n1, t1, ...
    double fastest = 0.0;             // [1/s] bound of the rates of its free motion without its springs

    std::size_t modes() const { return square_frequency.size(); }
    bool is_damped_by_mode() const { return damping.size() == modes(); }
};

/// Returns a structure in the coordinates of these modes alone, M-orthonormal: `shapes` [1/√kg], shape [dof][mode],
/// with ω² [rad²/s²], rising.
ModalStructure in_modes(const model::Structure& structure, const Eigen::MatrixXd& shapes,
                        const Eigen::VectorXd& square_frequency);

/// Returns those contacts as the structure's list numbers them, rising.
std::vector<std::size_t> numbered(const ModalStructure& structure, const std::vector<std::size_t>& contacts);

/// Throws `Error` (input) where the mass matrix is not positive definite or a matrix is not symmetric.
ModalStructure modal_structure(const model::Structure& structure);

/// Coordinates of displacements or velocities: Φ'M u.
Eigen::VectorXd modal(const ModalStructure& modal, const model::Structure& structure, const Eigen::VectorXd& u);

/// Returns the numbers of a vector, filled up with zeros to a size.
std::vector<double> padded(const Eigen::VectorXd& x, std::size_t size);

/// Says whether all of them are finite numbers.
bool is_finite(std::span<const double> q, std::span<const double> v);

}  // namespace stridor::integration
