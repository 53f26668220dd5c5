#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

/// Numbers and words one after the other in bytes. They are read back bit for bit.
///
/// The bytes are those of this machine, for processes on machines of one kind and files that stay on one.
namespace stridor::base {

/// Puts numbers and words in.
class Packing {
public:
    /// Adds a number.
    void add(double value);
    /// Adds a count.
    void add(std::uint64_t value);
    /// Adds words; any bytes will do.
    void add(std::string_view words);
    /// Adds one of a few kinds, at most 256.
    template <typename Enumeration>
    requires std::is_enum_v<Enumeration>
    void add(Enumeration kind) { bytes_ += static_cast<char>(kind); }

    /// Hands out the bytes.
    std::string take();

private:
    std::string bytes_;
};

/// Takes numbers and words out again, in their order.
class Unpacking {
public:
    /// Begins at the first byte. The bytes must outlive this object.
    explicit Unpacking(std::string_view bytes) : rest_(bytes) {}

    /// Takes a number.
    double number();
    /// Takes a count.
    std::uint64_t count();
    /// Takes words.
    std::string words();
    /// Takes one of `kinds` kinds; the first if the byte is none of them.
    template <typename Enumeration>
    requires std::is_enum_v<Enumeration> Enumeration kind(std::size_t kinds) {
        return static_cast<Enumeration>(kind_below(kinds));
    }

    /// Says whether all that was asked for was there, and no more.
    bool is_complete() const { return is_good_ && rest_.empty(); }

    /// Says whether all that was asked for so far was there.
    bool is_good() const { return is_good_; }

private:
    std::string_view next(std::size_t size);
    std::uint8_t kind_below(std::size_t kinds);

    std::string_view rest_;
    bool is_good_ = true;
};

/// Returns bytes in Base64 (RFC 4648, section 4).
std::string base64(std::string_view bytes);

}  // namespace stridor::base
