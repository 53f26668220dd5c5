#include "stridor/model/linear/inertial_part.hpp"

#include "stridor/base/decompositions.hpp"
#include "stridor/base/error.hpp"

namespace stridor::model {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double massless_share = 1e-13;  // [1] of the largest mass: rounding

}  // namespace

InertialPart inertial_part(const MatrixXd& mass, const MatrixXd& stiffness) {
    const Index size = mass.rows();
    if (size == 0 || Eigen::LLT<MatrixXd>(mass).info() == Eigen::Success)
        return {MatrixXd::Identity(size, size), MatrixXd::Identity(size, size), MatrixXd::Zero(size, size)};
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(mass);
    const Eigen::VectorXd& masses = solver.eigenvalues();  // rising
    Index without = 0;
    while (without < size && masses(without) <= massless_share * masses(size - 1))
        ++without;
    const MatrixXd none = solver.eigenvectors().leftCols(without);
    InertialPart part;
    part.inertial = solver.eigenvectors().rightCols(size - without);
    const Eigen::LLT<MatrixXd> factor(none.transpose() * stiffness * none);
    if (factor.info() != Eigen::Success)
        base::refuse("the stiffness does not hold what has no mass", "where it is follows from its forces alone",
                     "Give those rows a mass, or a spring.");
    part.flexibility = none * factor.solve(none.transpose());
    part.shape = part.inertial - part.flexibility * (stiffness * part.inertial);
    return part;
}

}  // namespace stridor::model
