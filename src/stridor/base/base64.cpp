#include "stridor/base/base64.hpp"

#include <cstddef>
#include <cstdint>

namespace stridor::base {

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
        std::uint32_t group = 0;
        for (std::size_t j = 0; j < 3; ++j)
            group = group << 8U | (k + j < bytes.size() ? static_cast<unsigned char>(bytes[k + j]) : 0U);
        for (std::size_t j = 0; j < 4; ++j)
            text += j <= bytes.size() - k ? digits[group >> (18U - 6U * j) & 63U] : '=';
    }
    return text;
}

}  // namespace stridor::base
