// Reference: F. Monjaraz-Tec, J. Gross, M. Krack, A massless boundary component mode synthesis method for elastodynamic
// contact problems, Computers and Structures 260 (2022) 106698.

#include "stridor/integration/steps/massless_structure.hpp"

#include "stridor/base/decompositions.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/model/contact/equilibrium.hpp"
#include "stridor/model/linear/complement.hpp"
#include "stridor/model/linear/inertial_part.hpp"
#include "stridor/model/linear/sliding_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numeric>
#include <string>
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
// [1] `doubt`: contacts held by what has no inertia are stiff springs, and vibrate with modes that are not there
constexpr double most_apart = 2.5;
constexpr double most_moved = 0.05;  // [1] of a frequency of sliding, up to half of the first mode without inertia

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

// the rows of some contacts' directions in the modes that keep their inertia, shape [row][mode]
MatrixXd rows_in_modes(const MasslessStructure& structure) {
    const auto modes = static_cast<Index>(structure.modal.modes());
    MatrixXd rows(static_cast<Index>(structure.plan.rows()), modes);
    for (Index row = 0; row < rows.rows(); ++row)
        rows.row(row) = Eigen::Map<const Eigen::RowVectorXd>(
            row_of(structure.modal.contacts, structure.plan, static_cast<std::size_t>(row)).data(), modes);
    return rows;
}

std::vector<Index> normals_of(const ContactRowPlan& plan) {
    return {plan.first.begin(), plan.first.end() - 1};
}

// [rad/s] with these rows held by their flexibility, rising
VectorXd held_frequencies(const MasslessStructure& structure, const std::vector<Index>& held) {
    const MatrixXd rows = rows_in_modes(structure)(held, Eigen::all);
    MatrixXd stiffness = Eigen::Map<const VectorXd>(structure.modal.square_frequency.data(), rows.cols()).asDiagonal();
    stiffness += rows.transpose() * structure.flexibility(held, held).ldlt().solve(rows);
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(0.5 * (stiffness + stiffness.transpose()),
                                                         Eigen::EigenvaluesOnly);
    return solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
}

// [rad/s] with all contacts held
double highest_held(const MasslessStructure& structure) {
    std::vector<Index> all(structure.plan.rows());
    std::iota(all.begin(), all.end(), Index{0});
    return held_frequencies(structure, all).maxCoeff();
}

// [rad/s] of the structure itself with these directions held, rising
VectorXd held_frequencies(const model::Structure& structure, const MatrixXd& held) {
    const MatrixXd along = model::orthogonal_complement(held);
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(along.transpose() * structure.stiffness * along,
                                                                    along.transpose() * structure.mass * along,
                                                                    Eigen::EigenvaluesOnly);
    return solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
}

// does the structure itself?
bool slides_unstably(const model::Structure& structure, const std::vector<double>& ratios) {
    const model::SlidingMotion motion = model::sliding_motion(
        structure, std::vector<model::ContactState>(ratios.size(), model::ContactState::slip), ratios);
    if (!has_inertia(motion)) return false;
    const std::vector<std::complex<double>> values = eigenvalues(motion);
    return std::any_of(values.begin(), values.end(), [&](const std::complex<double>& value) {
        return value.real() > model::growth_rounding(values);
    });
}

// [rad/s] of the fastest mode of sliding that friction feeds, one way and the other, where the structure slides stably:
// above the modes that keep their inertia it is none of the structure
double fastest_fed(const model::Structure& structure, const MasslessStructure& massless) {
    const MatrixXd rows = rows_in_modes(massless);
    const std::vector<Index> normals = normals_of(massless.plan);
    const Index n = rows.cols();
    const MatrixXd modal_damping =
        massless.modal.is_damped_by_mode()
            ? MatrixXd(Eigen::Map<const VectorXd>(massless.modal.damping.data(), n).asDiagonal())
            : MatrixXd(Eigen::Map<const MatrixXd>(massless.modal.damping.data(), n, n));
    double fastest = 0.0;
    for (const double velocity : {1.0, -1.0}) {
        const std::vector<double> ratios = model::sliding_ratios(structure, velocity);
        if (slides_unstably(structure, ratios)) continue;
        MatrixXd pushes = rows(normals, Eigen::all);
        MatrixXd coupling = massless.flexibility(normals, normals);
        for (std::size_t k = 0; k < normals.size(); ++k) {
            const double ratio = ratios[massless.modal.number[k]];
            const auto at = static_cast<Index>(k);
            pushes.row(at) += ratio * rows.row(normals[k] + 1);
            coupling.col(at) += ratio * massless.flexibility(normals, normals[k] + 1);
        }
        MatrixXd stiffness = Eigen::Map<const VectorXd>(massless.modal.square_frequency.data(), n).asDiagonal();
        stiffness += pushes.transpose() * coupling.partialPivLu().solve(rows(normals, Eigen::all));
        const double rate = std::sqrt(std::max(1.0, stiffness.cwiseAbs().rowwise().sum().maxCoeff()));
        MatrixXd motion = MatrixXd::Zero(2 * n, 2 * n);
        motion.topRightCorner(n, n).diagonal().setConstant(rate);
        motion.bottomLeftCorner(n, n) = -stiffness / rate;
        motion.bottomRightCorner(n, n) = -modal_damping;
        const Eigen::EigenSolver<MatrixXd> solver(motion, false);
        const std::vector<std::complex<double>> values(solver.eigenvalues().begin(), solver.eigenvalues().end());
        for (const std::complex<double>& value : values)
            if (value.real() > model::growth_rounding(values)) fastest = std::max(fastest, value.imag());
    }
    return fastest;
}

std::string in_hertz(double rate) {
    return fmt::format("{:.4g} Hz", rate / base::two_pi);
}

// why the motion of its modes would not be that of the structure; empty where it is, up to half of the first one that
// lost its inertia
std::string doubt(const model::Structure& structure, const MasslessStructure& massless) {
    const double cut = massless.least_cut;
    if (cut == 0.0) return "";
    if (massless.modal.modes() < massless.plan.rows())
        return fmt::format("{} modes with inertia are fewer than the {} directions of the contacts",
                           massless.modal.modes(), massless.plan.rows());
    if (!(own_flexibility(massless.flexibility) > good_flexibility))
        return "they leave no contact a flexibility of its own";
    if (const double held = highest_held(massless); held > most_apart * cut)
        return fmt::format(
            "with all contacts held those with inertia would vibrate at up to {}, and inertia is left "
            "out from {} on",
            in_hertz(held), in_hertz(cut));
    if (structure.mass.llt().info() == Eigen::Success) {
        MatrixXd normals(model::dofs_of(structure), static_cast<Index>(structure.contacts.size()));
        for (std::size_t k = 0; k < structure.contacts.size(); ++k)
            normals.col(static_cast<Index>(k)) = structure.contacts[k].normal;
        const VectorXd wanted = held_frequencies(structure, normals);
        const VectorXd found = held_frequencies(massless, normals_of(massless.plan));
        if (wanted.size() > 0 && !(wanted(0) < 0.5 * cut))
            return fmt::format("it slides at {} at least, and inertia is left out from {} on", in_hertz(wanted(0)),
                               in_hertz(cut));
        for (Index k = 0; k < std::min(wanted.size(), found.size()) && wanted(k) < 0.5 * cut; ++k)
            if (std::abs(found(k) - wanted(k)) > most_moved * wanted(k))
                return fmt::format("it slides at {} instead of {}", in_hertz(found(k)), in_hertz(wanted(k)));
    }
    return "";
}

// where so many modes keep their inertia
MasslessStructure without_inertia(const model::Structure& structure, const AllModes& modes,
                                  const model::InertialPart& part, Index kept) {
    const MatrixXd directions = contact_directions(structure);
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
    const bool is_cut = kept < modes.square_frequency.size();
    massless.least_cut = is_cut ? std::sqrt(modes.square_frequency(kept)) : base::two_pi * structure.left_out_above;
    return massless;
}

// modes that keep their inertia, from the most on, until one number of them is carried; 0: none is
Index most_carried(const model::Structure& structure, const AllModes& modes, const model::InertialPart& part) {
    const MatrixXd directions = contact_directions(structure);
    const MatrixXd rows = directions.transpose() * modes.shapes;  // shape [row][mode]
    const Index count = modes.square_frequency.size();
    const bool has_massless_rows = count < part.shape.rows();
    MatrixXd flexibility = directions.transpose() * part.flexibility * directions;
    for (Index kept = count; kept >= directions.cols(); --kept) {
        if (kept < count) {
            if (!(modes.square_frequency(kept) > 0.0)) return 0;
            flexibility += rows.col(kept) * rows.col(kept).transpose() / modes.square_frequency(kept);
        } else if (!has_massless_rows) {
            continue;
        }
        // most are refused by the contacts alone, without the modes
        if (!(own_flexibility(flexibility) > good_flexibility)) continue;
        const MatrixXd driven = rows.leftCols(kept) * rows.leftCols(kept).transpose();
        const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> springs(driven, flexibility, Eigen::EigenvaluesOnly);
        const double cut =
            kept < count ? std::sqrt(modes.square_frequency(kept)) : base::two_pi * structure.left_out_above;
        if (springs.eigenvalues().maxCoeff() > most_apart * most_apart * cut * cut) continue;
        const MasslessStructure massless = without_inertia(structure, modes, part, kept);
        if (doubt(structure, massless).empty() && !(fastest_fed(structure, massless) > cut)) return kept;
    }
    return 0;
}

Index kept_modes(const model::Structure& structure, const AllModes& modes, const model::InertialPart& part,
                 double above) {
    if (above > 0.0) {
        const double cut = base::two_pi * above;
        return (modes.square_frequency.array() <= cut * cut).count();
    }
    // rows without mass and no mode left out: so it is
    const bool has_massless_rows = modes.square_frequency.size() < part.shape.rows();
    if (has_massless_rows && !(structure.left_out_above > 0.0)) return modes.square_frequency.size();
    return most_carried(structure, modes, part);
}

}  // namespace

MasslessStructure massless_structure(const model::Structure& structure, double above) {
    const model::InertialPart part = model::inertial_part(structure.mass, structure.stiffness);
    const MatrixXd lost = structure.damping - part.inertial * (part.inertial.transpose() * structure.damping);
    if (lost.cwiseAbs().maxCoeff() > damper_rounding * structure.damping.cwiseAbs().maxCoeff())
        base::refuse("a row without mass has damping", "what has no inertia follows its springs alone",
                     "Take its damping out.");
    const AllModes modes = all_modes(structure, part);
    const Index kept = kept_modes(structure, modes, part, above);
    if (kept == 0 && !(above > 0.0))
        base::refuse("no number of modes without inertia carries the contacts",
                     "where contacts close, the modes that are left move otherwise than the structure",
                     "Use run.formulation = \"standard\".");
    if (kept == 0) base::refuse("no mode is left with inertia", "nothing would vibrate", "Raise run.massless_above.");
    if (kept < modes.square_frequency.size() && !(modes.square_frequency(kept) > 0.0))
        base::refuse("a mode without stiffness cannot move without inertia", "", "Raise run.massless_above.");
    MasslessStructure massless = without_inertia(structure, modes, part, kept);
    if (!(own_flexibility(massless.flexibility) > least_flexibility))
        base::refuse("too few modes move without inertia to carry the contacts",
                     "their flexibility is singular: forces at the contacts would follow from rounding",
                     "Lower run.massless_above.");
    if (const std::string why = doubt(structure, massless); above > 0.0 && !why.empty())
        base::refuse("the modes without inertia do not carry the contacts", why,
                     "Set run.massless_above = 0, which looks for a number of modes that does.");
    return massless;
}

double longest_step(const MasslessStructure& structure) {
    const double fastest = highest_held(structure);
    return fastest > 0.0 ? 2.0 / fastest : std::numeric_limits<double>::infinity();
}

}  // namespace stridor::integration
