#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace stridor::golden {

/// Named values, a line each; numbers in hexadecimal, so that they keep all their bits. All NaN are alike.
class Values {
public:
    void add(std::string_view name, double value);
    void add(std::string_view name, std::string_view word);
    void add(std::string_view name, std::span<const double> values);

    template <typename Count>
    requires std::is_integral_v<Count> || std::is_enum_v<Count>
    void add(std::string_view name, Count value) { add(name, static_cast<double>(value)); }

    const std::string& text() const { return text_; }

private:
    std::string text_{};
};

}  // namespace stridor::golden
