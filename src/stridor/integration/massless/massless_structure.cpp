// Reference: F. Monjaraz-Tec, J. Gross, M. Krack, A massless boundary component mode synthesis method for elastodynamic
// contact problems, Computers and Structures 260 (2022) 106698.

#include "stridor/integration/massless/massless_structure.hpp"

#include "stridor/base/decompositions.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/model/inertial_part.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace stridor::integration {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double damper_rounding = 1e-12;  // [1] of the largest damping
// [1] `own_flexibility`: below it forces are made of rounding; from it on they are good without a user's choice
constexpr double least_flexibility = 1e-9;
constexpr double good_flexibility = 1e-2;

// modes of all that has mass
struct AllModes {
    MatrixXd shapes;  // [1/√kg] shape [dof][mode]
    VectorXd square_frequency;
};

AllModes all_modes(const model::Structure& structure, const model::InertialPart& part) {
    const MatrixXd mass = part.inertial.transpose() * structure.mass * part.inertial;
    const MatrixXd stiffness = part.shape.transpose() * structure.stiffness * part.shape;
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(stiffness, mass);
    return {part.shape * solver.eigenvectors(), solver.eigenvalues()};
}

// directions of all contacts in their order, shape [dof][row]
MatrixXd contact_directions(const model::Structure& structure) {
    std::vector<VectorXd> columns;
    for (const std::size_t number : model::canonical_order(structure)) {
        const model::ContactPoint& contact = structure.contacts[number];
        columns.push_back(contact.normal);
        columns.push_back(contact.tangent);
        if (model::has_two_tangents(contact)) columns.push_back(contact.second_tangent);
    }
    MatrixXd directions(model::dofs_of(structure), static_cast<Index>(columns.size()));
    for (std::size_t k = 0; k < columns.size(); ++k)
        directions.col(static_cast<Index>(k)) = columns[k];
    return directions;
}

// flexibility of all that has no inertia where so many modes keep theirs, shape [dof][dof]
MatrixXd flexibility_beside(const AllModes& modes, const model::InertialPart& part, Index kept) {
    const Index without = modes.square_frequency.size() - kept;
    const MatrixXd stiff = modes.shapes.rightCols(without);
    return part.flexibility +
           stiff * modes.square_frequency.tail(without).cwiseInverse().asDiagonal() * stiff.transpose();
}

// how well contacts have a flexibility of their own: the least eigenvalue, each direction scaled by its own
double own_flexibility(const MatrixXd& flexibility) {
    const VectorXd size = flexibility.diagonal().cwiseMax(0.0).cwiseSqrt();
    if (!(size.minCoeff() > 0.0)) return 0.0;
    const MatrixXd scaled = size.cwiseInverse().asDiagonal() * flexibility * size.cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(scaled, Eigen::EigenvaluesOnly);
    return solver.eigenvalues()(0);
}

// as many modes as leave the contacts a flexibility of their own; it falls with their number
Index most_kept(const AllModes& modes, const model::InertialPart& part, const MatrixXd& directions) {
    Index enough = 0;
    Index too_many = modes.square_frequency.size();
    while (too_many - enough > 1) {
        const Index kept = (enough + too_many) / 2;
        const bool is_held = modes.square_frequency(kept) > 0.0;
        const MatrixXd flexibility = flexibility_beside(modes, part, kept);
        const bool is_well =
            is_held && own_flexibility(directions.transpose() * flexibility * directions) > good_flexibility;
        // a mode without stiffness must be kept
        (is_well || !is_held ? enough : too_many) = kept;
    }
    return enough;
}

Index kept_modes(const AllModes& modes, const model::InertialPart& part, const MatrixXd& directions, double above) {
    if (above > 0.0) {
        const double cut = base::two_pi * above;
        return (modes.square_frequency.array() <= cut * cut).count();
    }
    const bool has_massless_rows = modes.square_frequency.size() < part.shape.rows();
    return has_massless_rows ? modes.square_frequency.size() : most_kept(modes, part, directions);
}

}  // namespace

MasslessStructure massless_structure(const model::Structure& structure, double above) {
    const model::InertialPart part = model::inertial_part(structure.mass, structure.stiffness);
    const MatrixXd lost = structure.damping - part.inertial * (part.inertial.transpose() * structure.damping);
    if (lost.cwiseAbs().maxCoeff() > damper_rounding * structure.damping.cwiseAbs().maxCoeff())
        base::refuse("a row without mass has damping", "what has no inertia follows its springs alone",
                     "Take its damping out.");
    const AllModes modes = all_modes(structure, part);
    const MatrixXd directions = contact_directions(structure);
    const Index kept = kept_modes(modes, part, directions, above);
    if (kept == 0)
        base::refuse("no mode is left with inertia", "nothing would vibrate",
                     above > 0.0 ? "Raise run.massless_above." : "The contacts need the flexibility of all modes.");
    const Index without = modes.square_frequency.size() - kept;
    if (without > 0 && !(modes.square_frequency(kept) > 0.0))
        base::refuse("a mode without stiffness cannot move without inertia", "", "Raise run.massless_above.");
    const MatrixXd flexibility = flexibility_beside(modes, part, kept);
    MasslessStructure massless;
    massless.modal = in_modes(structure, modes.shapes.leftCols(kept), modes.square_frequency.head(kept));
    massless.plan = row_plan(massless.modal.contacts);
    const VectorXd shaken =
        structure.shaken.size() != 0 ? structure.shaken : VectorXd(VectorXd::Zero(model::dofs_of(structure)));
    massless.moved = flexibility * directions;
    massless.load_moved = flexibility * structure.load;
    massless.shaken_moved = flexibility * shaken;
    massless.flexibility = directions.transpose() * massless.moved;
    massless.load_place = directions.transpose() * massless.load_moved;
    massless.shaken_place = directions.transpose() * massless.shaken_moved;
    massless.load_by_load = structure.load.dot(massless.load_moved);
    massless.load_by_shaken = structure.load.dot(massless.shaken_moved);
    massless.shaken_by_shaken = shaken.dot(massless.shaken_moved);
    if (without > 0) massless.least_cut = std::sqrt(modes.square_frequency(kept));
    if (!(own_flexibility(massless.flexibility) > least_flexibility))
        base::refuse("too few modes move without inertia to carry the contacts",
                     "their flexibility is singular: forces at the contacts would follow from rounding",
                     "Lower run.massless_above.");
    return massless;
}

double longest_step(const MasslessStructure& structure) {
    const auto n = static_cast<Index>(structure.modal.modes());
    MatrixXd contacts(static_cast<Index>(structure.plan.rows()), n);
    for (Index row = 0; row < contacts.rows(); ++row)
        contacts.row(row) = Eigen::Map<const Eigen::RowVectorXd>(
            row_of(structure.modal.contacts, structure.plan, static_cast<std::size_t>(row)).data(), n);
    MatrixXd held = Eigen::Map<const VectorXd>(structure.modal.square_frequency.data(), n).asDiagonal();
    held += contacts.transpose() * structure.flexibility.ldlt().solve(contacts);
    const MatrixXd symmetric = 0.5 * (held + held.transpose());
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(symmetric, Eigen::EigenvaluesOnly);
    const double square = solver.eigenvalues()(n - 1);
    return square > 0.0 ? 2.0 / std::sqrt(square) : std::numeric_limits<double>::infinity();
}

}  // namespace stridor::integration
