#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace stridor::base {

/// Returns the 64-bit FNV-1a hash of bytes (Fowler, Noll, Vo), for naming and for noticing changes; not for security.
std::uint64_t fnv1a(std::string_view bytes);

/// Returns that hash as 16 hexadecimal digits.
std::string hash_text(std::string_view bytes);

/// The SHA-256 digest (FIPS 180-4, 2015) of bytes that arrive in pieces.
///
/// It names content: no two different files with one digest are known, which cannot be said of `fnv1a`.
class Sha256 {
public:
    /// Adds the next piece.
    void add(std::string_view bytes);

    /// Returns the digest as 64 lower-case hexadecimal digits. Nothing may be added afterwards.
    std::string text();

private:
    void compress(const unsigned char* block);

    std::array<std::uint32_t, 8> state_{0x6a09e667U, 0xbb67ae85U, 0x3c6ef372U, 0xa54ff53aU,
                                        0x510e527fU, 0x9b05688cU, 0x1f83d9abU, 0x5be0cd19U};
    std::array<unsigned char, 64> block_{};
    std::uint64_t length_ = 0;  // [bytes] added so far
};

/// Returns the SHA-256 digest of bytes as 64 lower-case hexadecimal digits.
std::string sha256_text(std::string_view bytes);

}  // namespace stridor::base
