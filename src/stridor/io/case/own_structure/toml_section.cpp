#include "stridor/io/case/own_structure/toml_section.hpp"

#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"

#include <cmath>
#include <filesystem>

namespace stridor::io {

namespace {

Error wrong_value(const TomlEntry& entry, std::string what, std::string why) {
    return {ErrorKind::input, {std::move(what), std::move(why), ""}, entry.value_place};
}

}  // namespace

void TomlSection::refuse_kind(const TomlEntry& entry, std::string_view expected) const {
    throw wrong_value(entry, entry.key + " is " + std::string(type_name(entry.value)),
                      "expected " + std::string(expected));
}

base::Place TomlSection::place() const {
    const TomlEntry* table = document_->find(std::string_view(prefix_).substr(0, prefix_.size() - 1));
    return table != nullptr ? table->key_place : base::Place{document_->name, 0, 0, ""};
}

const TomlEntry& TomlSection::need(std::string_view name) const {
    if (const TomlEntry* entry = find(name)) return *entry;
    throw Error(ErrorKind::input, {"missing key " + prefix_ + std::string(name), "it has no sensible default", ""},
                place());
}

double TomlSection::quantity(std::string_view name, std::string_view unit, Bound bound) const {
    const TomlEntry& entry = need(name);
    double value = 0.0;
    if (const auto* number = std::get_if<double>(&entry.value)) {
        value = *number;
    } else if (const auto* words = std::get_if<std::string>(&entry.value)) {
        try {
            value = base::parse_quantity(*words, unit);
        } catch (const Error& error) {
            throw located(error, entry.key, entry.value_place);
        }
    } else {
        refuse_kind(entry, unit == "1" ? "a number" : "a number in " + std::string(unit));
    }
    const bool fits = bound == Bound::any || (bound == Bound::positive ? value > 0.0 : value >= 0.0);
    if (!std::isfinite(value) || !fits)
        throw wrong_value(entry, entry.key + " = " + base::shortest(value) + " is out of range",
                          bound == Bound::positive       ? "it must be above 0"
                          : bound == Bound::not_negative ? "it must be at least 0"
                                                         : "it must be finite");
    return value;
}

std::optional<double> TomlSection::find_quantity(std::string_view name, std::string_view unit, Bound bound) const {
    return has(name) ? std::optional(quantity(name, unit, bound)) : std::nullopt;
}

int TomlSection::count(std::string_view name, int least, int most) const {
    const double value = quantity(name, "1", Bound::any);
    if (value != std::floor(value) || value < least || value > most)
        throw wrong_value(need(name), need(name).key + " = " + base::shortest(value) + " is out of range",
                          "it must be a whole number from " + std::to_string(least) + " to " + std::to_string(most));
    return static_cast<int>(value);
}

std::string TomlSection::text(std::string_view name) const {
    const TomlEntry& entry = need(name);
    if (const auto* words = std::get_if<std::string>(&entry.value)) return *words;
    if (const auto* number = std::get_if<double>(&entry.value)) return base::shortest(*number);
    refuse_kind(entry, "text");
}

std::string TomlSection::text_or(std::string_view name, std::string fallback) const {
    return has(name) ? text(name) : std::move(fallback);
}

std::vector<std::string> TomlSection::texts(std::string_view name) const {
    const TomlEntry& entry = need(name);
    if (const auto* words = std::get_if<std::string>(&entry.value)) return {*words};
    if (const auto* list = std::get_if<std::vector<std::string>>(&entry.value)) return *list;
    refuse_kind(entry, "text or a list of texts");
}

std::vector<double> TomlSection::numbers(std::string_view name, std::size_t size) const {
    const TomlEntry& entry = need(name);
    const auto* list = std::get_if<std::vector<double>>(&entry.value);
    if (list == nullptr) refuse_kind(entry, "a list of numbers");
    if (size != 0 && list->size() != size)
        throw wrong_value(entry, entry.key + " has " + std::to_string(list->size()) + " numbers",
                          "there must be " + std::to_string(size));
    for (const double value : *list)
        if (!std::isfinite(value)) throw wrong_value(entry, entry.key + " holds a number that is not finite", "");
    return *list;
}

std::string TomlSection::path(const TomlEntry& entry, const std::string& name) const {
    const std::filesystem::path folder =
        entry.origin == TomlOrigin::file ? std::filesystem::path(document_->name).parent_path() : "";
    return (folder / name).string();
}

}  // namespace stridor::io
