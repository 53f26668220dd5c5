#include "stridor/integration/rules/painleve.hpp"

#include "stridor/base/decompositions.hpp"
#include "stridor/integration/rules/contact_mode_of.hpp"

#include <algorithm>

namespace stridor::integration {

namespace {

constexpr long most_looked_at = 65536;   // sets: nobody waits for more
constexpr double least_inertia = 1e-12;  // [1] of the diagonal's product: rows with less depend on each other
constexpr double share_rounding = 1e-9;  // [1] of the determinant without friction: what its rounding may be

// sets with a given number of closed contacts, one after the other
class PressedSearch {
public:
    PressedSearch(const std::vector<ModalContact>& contacts, const Eigen::MatrixXd& compliance,
                  const std::vector<std::vector<ContactMode>>& possible)
        : contacts_(contacts),
          compliance_(compliance),
          possible_(possible),
          set_(contacts.size(), ContactMode::open) {}

    /// Closes `count` contacts more, from this one on; returns whether friction presses any such set.
    bool close(std::size_t from, std::size_t count) {
        if (count == 0) return is_pressed();
        for (std::size_t k = from; k + count <= set_.size(); ++k) {
            for (const ContactMode mode : possible_[k]) {
                if (mode == ContactMode::open) continue;
                set_[k] = mode;
                if (close(k + 1, count - 1)) return true;
            }
            set_[k] = ContactMode::open;
        }
        return false;
    }

    bool has_looked_enough() const { return looked_at_ >= most_looked_at; }

    std::vector<std::size_t> closed() const {
        std::vector<std::size_t> result;
        for (std::size_t k = 0; k < set_.size(); ++k)
            if (set_[k] != ContactMode::open) result.push_back(k);
        return result;
    }

private:
    bool is_pressed() {
        if (std::none_of(set_.begin(), set_.end(), is_slip) || looked_at_ >= most_looked_at) return false;
        ++looked_at_;
        // rows of the set, normals and the tangents of the stuck, and the share of friction in the push of each
        std::vector<Eigen::Index> rows, beside;
        std::vector<double> share;
        for (std::size_t k = 0; k < set_.size(); ++k) {
            if (set_[k] == ContactMode::open) continue;
            const auto normal = static_cast<Eigen::Index>(2 * k);
            rows.push_back(normal);
            beside.push_back(normal + 1);
            share.push_back(is_slip(set_[k]) ? slip_ratio(contacts_[k].friction, way_of(set_[k])) : 0.0);
            if (set_[k] != ContactMode::stick) continue;
            rows.push_back(normal + 1);
            beside.push_back(normal + 1);
            share.push_back(0.0);
        }
        const auto size = static_cast<Eigen::Index>(rows.size());
        Eigen::MatrixXd without(size, size), with(size, size);
        for (Eigen::Index a = 0; a < size; ++a)
            for (Eigen::Index b = 0; b < size; ++b) {
                const auto column = static_cast<std::size_t>(b);
                const Eigen::Index row = rows[static_cast<std::size_t>(a)];
                without(a, b) = compliance_(row, rows[column]);
                with(a, b) = without(a, b) + share[column] * compliance_(row, beside[column]);
            }
        const double inertia = without.determinant();
        const bool is_determined = inertia > least_inertia * without.diagonal().prod();
        return is_determined && !(with.determinant() > share_rounding * inertia);
    }

    const std::vector<ModalContact>& contacts_;
    const Eigen::MatrixXd& compliance_;
    const std::vector<std::vector<ContactMode>>& possible_;
    std::vector<ContactMode> set_;
    long looked_at_ = 0;
};

}  // namespace

std::vector<std::size_t> pressed_contacts(const std::vector<ModalContact>& contacts, const Eigen::MatrixXd& compliance,
                                          const std::vector<std::vector<ContactMode>>& possible) {
    PressedSearch search(contacts, compliance, possible);
    for (std::size_t count = 1; count <= contacts.size() && !search.has_looked_enough(); ++count)
        if (search.close(0, count)) return search.closed();
    return {};
}

std::vector<std::vector<ContactMode>> modes_of_touching(const std::vector<bool>& touches) {
    std::vector<std::vector<ContactMode>> possible(touches.size(), std::vector<ContactMode>{ContactMode::open});
    for (std::size_t k = 0; k < touches.size(); ++k)
        if (touches[k])
            possible[k] = {ContactMode::stick, ContactMode::slip_forward, ContactMode::slip_backward,
                           ContactMode::open};
    return possible;
}

}  // namespace stridor::integration
