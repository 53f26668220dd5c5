#pragma once

#include <algorithm>
#include <span>
#include <tuple>

namespace stridor::signal {

/// Returns the states behind samples, each as its own `next` takes them. They are values here, so that the loop keeps
/// them in registers.
template <typename... States>
std::tuple<States...> states_behind(std::span<const double> samples, States... states) {
    for (const double x : samples)
        (states.next(x), ...);
    return {states...};
}

/// Hands samples to running figures of which each waits for its own last result: filters, exponential means. Several
/// side by side take hardly longer than the slowest, for they do not wait for each other.
///
/// A figure has `room()`, the samples until its part ends; `begin(samples)`, its state before them, which has
/// `next(sample)`; and `end(state, count)`, which takes the state back and ends a whole part.
template <typename... Figures>
void push_side_by_side(std::span<const double> samples, Figures&... figures) {
    while (!samples.empty()) {
        const auto here = samples.first(std::min({samples.size(), figures.room()...}));
        const auto states = states_behind(here, figures.begin(here)...);
        std::apply([&](const auto&... state) { (figures.end(state, here.size()), ...); }, states);
        samples = samples.subspan(here.size());
    }
}

}  // namespace stridor::signal
