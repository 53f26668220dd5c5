#include "stridor/storage/page_checksum.hpp"

namespace stridor::storage {

namespace {

constexpr std::size_t word_size = 8;  // [bytes]
constexpr std::size_t covered = page_size - checksum_size;

// the same on every machine
std::uint64_t word_at(std::span<const std::uint8_t, page_size> page, std::size_t place) {
    std::uint64_t word = 0;
    for (std::size_t k = 0; k < word_size; ++k)
        word |= std::uint64_t{page[place + k]} << (8 * k);
    return word;
}

// Each step is one to one in the hash and in the word: what differs in one word differs at the end. The odd factor is
// that of Knuth's linear congruential generator (MMIX); the shift carries high bits back to the low ones.
std::uint64_t stirred(std::uint64_t hash, std::uint64_t word) {
    hash = (hash ^ word) * 6364136223846793005U;
    return hash ^ (hash >> 29U);
}

}  // namespace

std::uint64_t page_checksum(std::span<const std::uint8_t, page_size> page, std::uint32_t number) {
    // the number tells a page from another one's copy; a page of zeros is none
    std::uint64_t hash = stirred(1442695040888963407U, number);
    for (std::size_t place = 0; place < covered; place += word_size)
        hash = stirred(hash, word_at(page, place));
    return stirred(hash, covered);
}

void put_checksum(std::span<std::uint8_t, page_size> page, std::uint32_t number) {
    const std::uint64_t sum = page_checksum(page, number);
    for (std::size_t k = 0; k < checksum_size; ++k)
        page[covered + k] = static_cast<std::uint8_t>(sum >> (8 * k));
}

bool has_checksum(std::span<const std::uint8_t, page_size> page, std::uint32_t number) {
    return word_at(page, covered) == page_checksum(page, number);
}

}  // namespace stridor::storage
