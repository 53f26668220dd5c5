#pragma once

#include "stridor/integration/contact_mode.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

/// The search for a set of contact modes that obeys all laws, the same for every engine with several contacts: the
/// contact that is farthest from its law changes, until none breaks one. A limit of friction that broke is that of the
/// slip until the search has ended, so that limits only fall. Single changes may run in a circle all the same, where a
/// contact that stuck would be pulled open and one that was open would fall: then all sets are tried.
namespace stridor::integration {

/// All sets of contact modes that take one of its possible modes for each contact (shape [contact][possible]): those
/// that change the fewest of the present modes first; likewise in the order in which the modes are listed. None if they
/// are more than `most`: nobody waits for so many.
std::vector<std::vector<ContactMode>> contact_sets(const std::vector<std::vector<ContactMode>>& possible,
                                                   const std::vector<ContactMode>& present, std::size_t most = 65536);

/// Repeats a trial until it has a result, which is returned. A trial solves the present set and changes the contact that
/// is farthest from its law; it has a result if no contact breaks one, and if the set has no solution. Empty if 40
/// changes, and 20 for each contact, were not enough.
template <typename Trial>
auto change_one_by_one(std::size_t contacts, Trial trial) {
    const std::size_t most_changes = 40 + 20 * contacts;
    decltype(trial()) result;
    for (std::size_t change = 0; change < most_changes && !result; ++change)
        result = trial();
    return result;
}

/// Tries all sets of possible modes, those nearest to the present one first, until one obeys all laws; returns whether
/// one does.
template <typename Obeys>
bool try_all_sets(const std::vector<std::vector<ContactMode>>& possible, const std::vector<ContactMode>& present,
                  Obeys obeys) {
    const std::vector<std::vector<ContactMode>> sets = contact_sets(possible, present);
    return std::any_of(sets.begin(), sets.end(), obeys);
}

}  // namespace stridor::integration
