#include "stridor/model/structure.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"

namespace stridor::model {

Structure structure_of_size(int dofs, int contacts) {
    const ContactPoint point{.normal = Eigen::VectorXd::Zero(dofs), .tangent = Eigen::VectorXd::Zero(dofs)};
    return {.mass = Eigen::MatrixXd::Zero(dofs, dofs),
            .damping = Eigen::MatrixXd::Zero(dofs, dofs),
            .stiffness = Eigen::MatrixXd::Zero(dofs, dofs),
            .load = Eigen::VectorXd::Zero(dofs),
            .contacts = std::vector<ContactPoint>(static_cast<std::size_t>(contacts), point)};
}

int dofs_of(const Structure& structure) {
    return static_cast<int>(structure.load.size());
}

const ContactPoint& only_contact(const Structure& structure, std::string_view solver) {
    const auto refusal = [solver](const std::string& why) {
        return Error(ErrorKind::input, {std::string(solver) + " cannot solve this structure", why, ""});
    };
    if (structure.contacts.size() != 1)
        throw refusal("it has " + std::to_string(structure.contacts.size()) + " contacts instead of one");
    const ContactPoint& contact = structure.contacts.front();
    if (contact.initial_gap != 0.0)
        throw refusal("its contact is open at rest: initial gap " + base::shortest(contact.initial_gap) + " m");
    if (contact.drive_share != 1.0)
        throw refusal("its contact has a share of the drive: " + base::shortest(contact.drive_share));
    return contact;
}

}  // namespace stridor::model
