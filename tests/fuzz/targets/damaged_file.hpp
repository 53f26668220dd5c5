#pragma once

#include "stridor/storage/checked_files.hpp"
#include "support/scratch_folder.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <string_view>

namespace stridor::fuzz {

/// What an input makes of a sound database.
///
/// Its first byte says how: 0 changes bytes, 1 changes them and then gives each page a checksum that is right, so that
/// what lies behind the checksums is met, 2 takes the rest of the input for the whole file, 3 the same with right
/// checksums. Changes are a place (three bytes, the lowest first), a length, and so many bytes; a length of zero cuts
/// the file off there. So an input stays small.
struct Damage {
    std::string bytes{};
    bool is_mended = false;
};

inline void mend_pages(std::string& bytes) {
    auto* data = reinterpret_cast<std::uint8_t*>(bytes.data());
    for (std::size_t place = 0; place + storage::page_size <= bytes.size(); place += storage::page_size)
        storage::put_checksum(std::span<std::uint8_t, storage::page_size>(data + place, storage::page_size),
                              static_cast<std::uint32_t>(place / storage::page_size + 1));
}

inline Damage damaged(const std::string& sound, std::string_view input) {
    Damage damage{sound, false};
    if (input.empty()) return damage;
    const int mode = static_cast<unsigned char>(input.front()) % 4;
    input.remove_prefix(1);
    damage.is_mended = mode % 2 == 1;
    if (mode >= 2) damage.bytes = input;
    while (mode < 2 && input.size() >= 4 && !damage.bytes.empty()) {
        const auto byte = [&](std::size_t k) { return std::size_t{static_cast<unsigned char>(input[k])}; };
        const std::size_t place = (byte(0) | byte(1) << 8U | byte(2) << 16U) % damage.bytes.size();
        const std::size_t length = std::min({byte(3), input.size() - 4, damage.bytes.size() - place});
        if (byte(3) == 0)
            damage.bytes.resize(place);
        else
            damage.bytes.replace(place, length, input.substr(4, length));
        input.remove_prefix(4 + length);
    }
    if (damage.is_mended) mend_pages(damage.bytes);
    return damage;
}

inline std::string file_bytes(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Puts bytes in the place of a database, with nothing of another one beside it.
inline void put_database(const std::filesystem::path& file, const std::string& bytes) {
    std::error_code ignored;
    std::filesystem::remove(file.string() + "-journal", ignored);
    std::ofstream(file, std::ios::binary) << bytes;
}

}  // namespace stridor::fuzz
