#include "stridor/base/field_table.hpp"

#include "stridor/base/text.hpp"

#include <limits>
#include <utility>
#include <vector>

namespace stridor::base {

namespace {

std::string quoted(std::string_view word) {
    return "\"" + std::string(word) + "\"";
}

std::string with_unit(std::string number, std::string_view unit) {
    return unit == "1" ? std::move(number) : std::move(number) + " " + std::string(unit);
}

}  // namespace

std::string did_you_mean(std::string_view name, std::span<const std::string_view> names, std::string otherwise) {
    const std::string_view near = nearest_name(name, names);
    return near.empty() ? std::move(otherwise) : "Did you mean " + quoted(near) + "?";
}

std::string did_you_mean(std::string_view name, std::span<const std::string> names, std::string otherwise) {
    return did_you_mean(name, std::vector<std::string_view>(names.begin(), names.end()), std::move(otherwise));
}

std::size_t place_of_choice(std::string_view key, std::string_view choice, std::span<const std::string_view> names,
                            std::optional<Place> place) {
    const auto found = std::find(names.begin(), names.end(), choice);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    std::string choices;
    for (const std::string_view name : names)
        choices += (choices.empty() ? "" : ", ") + quoted(name);
    throw Error(ErrorKind::input,
                {std::string(key) + " = " + quoted(choice) + " is not one of its choices", "choices: " + choices,
                 did_you_mean(choice, names)},
                std::move(place));
}

std::string quantity_text(double value, std::string_view unit) {
    return with_unit(shortest(value), unit);
}

std::string limits_text(double low, double high, std::string_view unit, LowEnd low_end) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (high < infinity) return with_unit("between " + shortest(low) + " and " + shortest(high), unit);
    if (!(low > -infinity)) return "finite";
    return with_unit((low_end == LowEnd::open ? "above " : "at least ") + shortest(low), unit);
}

}  // namespace stridor::base
