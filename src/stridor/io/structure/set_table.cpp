#include "stridor/io/structure/set_table.hpp"

#include <fmt/format.h>

#include <utility>

namespace stridor::io::structure {

namespace {

constexpr std::size_t most_sets = 100'000;
constexpr std::size_t most_set_nodes = 4'000'000;  // [1] of all sets, some 130 MB; a model has a set of all its nodes

}  // namespace

std::size_t SetTable::place_of(const std::string& key, const std::string& name) {
    const auto [found, is_new] = places_.try_emplace(key, sets_.size());
    if (is_new) sets_.push_back({name, {}});
    return found->second;
}

std::optional<std::size_t> SetTable::find(const std::string& key) const {
    const auto found = places_.find(key);
    return found == places_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<base::Problem> SetTable::excess(std::size_t nodes) const {
    if (sets_.size() > most_sets)
        return base::Problem{fmt::format("there are more than {} node sets", most_sets), "so many are not read",
                             "Leave out those that no contact and no force needs."};
    if (nodes > most_set_nodes - nodes_)
        return base::Problem{fmt::format("the node sets hold more than {} nodes together", most_set_nodes),
                             "so many are not read", "Leave out the sets that no contact and no force needs."};
    return std::nullopt;
}

void SetTable::add(std::size_t place, std::string node) {
    sets_[place].nodes.push_back(std::move(node));
    ++nodes_;
}

}  // namespace stridor::io::structure
