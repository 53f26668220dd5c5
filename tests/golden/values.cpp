#include "golden/values.hpp"

#include <fmt/format.h>

#include <cmath>

namespace stridor::golden {

void Values::add(std::string_view name, double value) {
    add(name, std::isnan(value) ? std::string("nan") : fmt::format("{:a}", value));
}

void Values::add(std::string_view name, std::string_view word) {
    text_ += fmt::format("{} {}\n", name, word);
}

void Values::add(std::string_view name, std::span<const double> values) {
    for (const double value : values)
        add(name, value);
}

}  // namespace stridor::golden
