#include "stridor/integration/contact_sets/set_search.hpp"

#include <algorithm>

namespace stridor::integration {

std::vector<std::vector<ContactMode>> contact_sets(const std::vector<std::vector<ContactMode>>& possible,
                                                   const std::vector<ContactMode>& present, std::size_t most) {
    std::size_t count = 1;
    for (const std::vector<ContactMode>& each : possible) {
        count *= each.size();
        if (count == 0 || count > most) return {};
    }
    std::vector<std::vector<ContactMode>> sets(count, std::vector<ContactMode>(possible.size()));
    for (std::size_t number = 0; number < count; ++number) {
        std::size_t rest = number;
        for (std::size_t k = possible.size(); k-- > 0;) {
            sets[number][k] = possible[k][rest % possible[k].size()];
            rest /= possible[k].size();
        }
    }
    const auto changes = [&](const std::vector<ContactMode>& set) {
        std::size_t sum = 0;
        for (std::size_t k = 0; k < set.size(); ++k)
            sum += set[k] == present[k] ? 0U : 1U;
        return sum;
    };
    std::stable_sort(sets.begin(), sets.end(), [&](const auto& a, const auto& b) { return changes(a) < changes(b); });
    return sets;
}

}  // namespace stridor::integration
