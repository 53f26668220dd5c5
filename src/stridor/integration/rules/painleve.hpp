#pragma once

#include "stridor/integration/modal/modal_structure.hpp"
#include "stridor/integration/rules/contact_mode.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace stridor::integration {

/// Returns contacts that friction presses together without end: those closed in the smallest set of contact modes that
/// takes one of its possible modes for each contact (shape [contact][possible]; any contact may be open) and has
///
///     det R'B <= 0
///
/// with R the rows that the set holds and B its pushes. For one contact that is W_nn + ratio W_nt <= 0, Painleve's
/// paradox (1895). Where no set of those possible is such the map from forces to accelerations turns nothing round, and
/// some set obeys all laws (Scholtes 2012, coherently oriented maps). So forces that do not exist have their reason
/// here. None where there is no such set; of large structures only the first 65536 sets are looked at.
///
/// `compliance` is the modal structure's W, or the response of a time step; rows and columns n0, t0, n1, t1, ...
std::vector<std::size_t> pressed_contacts(const std::vector<ModalContact>& contacts, const Eigen::MatrixXd& compliance,
                                          const std::vector<std::vector<ContactMode>>& possible);

/// Returns all modes, of each contact that touches, else open alone.
std::vector<std::vector<ContactMode>> modes_of_touching(const std::vector<bool>& touches);

}  // namespace stridor::integration
