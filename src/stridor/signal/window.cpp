#include "stridor/signal/window.hpp"

#include "stridor/base/elementary.hpp"

#include <numeric>

namespace stridor::signal {

namespace {

using Terms = std::array<double, 5>;

constexpr std::array<Terms, 4> terms_of{{
    {1.0, 0.0, 0.0, 0.0, 0.0},
    {0.5, 0.5, 0.0, 0.0, 0.0},
    {0.35875, 0.48829, 0.14128, 0.01168, 0.0},
    {1.0, 1.933, 1.286, 0.388, 0.0322},
}};

}  // namespace

std::vector<double> window(Window kind, std::size_t size) {
    const Terms& terms = terms_of[static_cast<std::size_t>(kind)];
    std::vector<double> values(size);
    for (std::size_t n = 0; n < size; ++n) {
        double sign = 1.0;
        for (std::size_t j = 0; j < terms.size(); ++j) {
            const double turns = static_cast<double>(j * n % size) / static_cast<double>(size);
            values[n] += sign * terms[j] * base::sine_cosine_of_turns(turns).cosine;
            sign = -sign;
        }
    }
    return values;
}

const std::vector<double>& Windows::of(std::size_t size) {
    constexpr std::size_t most = 256;
    const auto found = made_.find(size);
    if (found != made_.end()) return found->second;
    if (made_.size() >= most) made_.clear();
    return made_.emplace(size, window(kind_, size)).first->second;
}

double noise_bandwidth(const std::vector<double>& window) {
    const double sum = std::accumulate(window.begin(), window.end(), 0.0);
    const double squares = std::inner_product(window.begin(), window.end(), window.begin(), 0.0);
    return static_cast<double>(window.size()) * squares / (sum * sum);
}

}  // namespace stridor::signal
