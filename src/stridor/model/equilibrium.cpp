#include "stridor/model/equilibrium.hpp"

#include "stridor/model/sized_structure.hpp"

#include <Eigen/LU>

namespace stridor::model {

Equilibrium equilibrium(const Structure& structure, const std::vector<double>& ratios) {
    const Eigen::Index dofs = dofs_of(structure);
    const auto contacts = static_cast<Eigen::Index>(structure.contacts.size());
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(dofs + contacts, dofs + contacts);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(dofs + contacts);
    system.topLeftCorner(dofs, dofs) = structure.stiffness;
    right.head(dofs) = structure.load;
    for (Eigen::Index k = 0; k < contacts; ++k) {
        const ContactPoint& contact = structure.contacts[static_cast<std::size_t>(k)];
        system.col(dofs + k).head(dofs) = -(contact.normal + ratios[static_cast<std::size_t>(k)] * contact.tangent);
        system.row(dofs + k).head(dofs) = contact.normal.transpose();
        right(dofs + k) = -contact.initial_gap;
    }
    const bool is_small = contacts == 1 && dofs <= 3;
    // no rank test: next to the boundary the system is badly scaled, and its solution still right
    const Eigen::VectorXd solution =
        with_size(is_small ? static_cast<int>(dofs) : 0, [&](auto size) -> Eigen::VectorXd {
            constexpr int rows = size == Eigen::Dynamic ? Eigen::Dynamic : size + 1;
            const Eigen::Matrix<double, rows, rows> sized_system = system;
            const Eigen::Matrix<double, rows, 1> sized_right = right;
            const Eigen::Matrix<double, rows, 1> found = sized_system.partialPivLu().solve(sized_right);
            return found;
        });
    return {solution.head(dofs), solution.tail(contacts)};
}

std::vector<double> sliding_ratios(const Structure& structure, double surface_velocity) {
    std::vector<double> ratios;
    for (const ContactPoint& contact : structure.contacts)
        ratios.push_back(slip_ratio(contact.friction, slip_of(-contact.drive_share * surface_velocity)));
    return ratios;
}

}  // namespace stridor::model
