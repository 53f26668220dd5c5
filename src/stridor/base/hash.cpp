#include "stridor/base/hash.hpp"

namespace stridor::base {

std::uint64_t fnv1a(std::string_view bytes) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char byte : bytes) {
        hash ^= static_cast<unsigned char>(byte);
        hash *= 0x100000001b3U;
    }
    return hash;
}

std::string hash_text(std::string_view bytes) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::uint64_t hash = fnv1a(bytes);
    std::string text(16, '0');
    for (auto digit = text.rbegin(); digit != text.rend(); ++digit, hash >>= 4U)
        *digit = digits[hash & 15U];
    return text;
}

}  // namespace stridor::base
