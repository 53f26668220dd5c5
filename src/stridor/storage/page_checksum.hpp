#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

/// Checksums of the pages of a database: the last bytes of each page, which SQLite leaves to others ("reserved
/// bytes"), hold a checksum of the page's number and of the bytes before. A changed bit changes it for certain,
/// anything else but for one case in 2^64. docs/formats/chart.md has the definition.
namespace stridor::storage {

inline constexpr std::size_t page_size = 4096;   // [bytes]
inline constexpr std::size_t checksum_size = 8;  // [bytes] at the end of each page, the lowest first
inline constexpr std::size_t reserved_place =
    20;  // of the byte of a database that says how many bytes each page reserves

/// The checksum of a page but its last bytes; pages count from 1.
std::uint64_t page_checksum(std::span<const std::uint8_t, page_size> page, std::uint32_t number);

/// Writes the checksum into the page's end.
void put_checksum(std::span<std::uint8_t, page_size> page, std::uint32_t number);

/// Does the page hold its checksum?
bool has_checksum(std::span<const std::uint8_t, page_size> page, std::uint32_t number);

}  // namespace stridor::storage
