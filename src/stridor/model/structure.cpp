#include "stridor/model/structure.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"

#include <algorithm>
#include <numeric>

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

std::vector<int> interfaces_of(const Structure& structure) {
    std::vector<int> numbers;
    for (const ContactPoint& contact : structure.contacts)
        numbers.push_back(contact.interface);
    return numbers;
}

int channels_of(const Structure& structure) {
    return structure.measured.size() == 0 ? dofs_of(structure) : static_cast<int>(structure.measured.rows());
}

std::vector<std::size_t> canonical_order(const Structure& structure) {
    std::vector<std::size_t> order(structure.contacts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto is_before = [](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
        return std::lexicographical_compare(a.data(), a.data() + a.size(), b.data(), b.data() + b.size());
    };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t first, std::size_t second) {
        const ContactPoint& a = structure.contacts[first];
        const ContactPoint& b = structure.contacts[second];
        if (a.normal != b.normal) return is_before(a.normal, b.normal);
        if (a.tangent != b.tangent) return is_before(a.tangent, b.tangent);
        if (a.second_tangent.size() != b.second_tangent.size())
            return a.second_tangent.size() < b.second_tangent.size();
        if (a.second_tangent != b.second_tangent) return is_before(a.second_tangent, b.second_tangent);
        if (a.second_drive_share != b.second_drive_share) return a.second_drive_share < b.second_drive_share;
        if (a.initial_gap != b.initial_gap) return a.initial_gap < b.initial_gap;
        return a.drive_share < b.drive_share;
    });
    return order;
}

Structure in_canonical_order(const Structure& structure) {
    Structure ordered = structure;
    ordered.contacts.clear();
    for (const std::size_t k : canonical_order(structure))
        ordered.contacts.push_back(structure.contacts[k]);
    return ordered;
}

void expect_one_tangent(const Structure& structure, std::string_view solver) {
    if (std::none_of(structure.contacts.begin(), structure.contacts.end(), has_two_tangents)) return;
    throw Error(ErrorKind::input, {std::string(solver) + " cannot solve this structure",
                                   "a contact of it slips in two directions, it knows one", ""});
}

const ContactPoint& only_contact(const Structure& structure, std::string_view solver) {
    expect_one_tangent(structure, solver);
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
