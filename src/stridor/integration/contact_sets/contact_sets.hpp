#pragma once

#include "stridor/integration/contact_mode.hpp"

#include <cstddef>
#include <vector>

namespace stridor::integration {

/// All sets of contact modes that take one of its possible modes for each contact (shape [contact][possible]): those
/// that change the fewest of the present modes first; likewise in the order in which the modes are listed. None if they
/// are more than `most`: nobody waits for so many.
std::vector<std::vector<ContactMode>> contact_sets(const std::vector<std::vector<ContactMode>>& possible,
                                                   const std::vector<ContactMode>& present, std::size_t most = 65536);

}  // namespace stridor::integration
