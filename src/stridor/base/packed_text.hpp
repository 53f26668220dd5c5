#pragma once

#include <cstdint>
#include <string>
#include <string_view>

/// Numbers and words one after the other in a text, each as LENGTH:TEXT: what is taken out is what was put in, bit for
/// bit but for the payload of a NaN.
namespace stridor::base {

/// Puts numbers and words in.
class Packing {
public:
    /// Adds a number, as its shortest text that reads back alike.
    void add(double value);
    /// Adds a count.
    void add(std::uint64_t value);
    /// Adds words; any bytes will do.
    void add(std::string_view words);

    /// Hands out the text.
    std::string take();

private:
    std::string text_;
};

/// Takes them out again, in their order.
class Unpacking {
public:
    /// The text must outlive this.
    explicit Unpacking(std::string_view text) : rest_(text) {}

    /// Takes a number.
    double number();
    /// Takes a count.
    std::uint64_t count();
    /// Takes words.
    std::string words();

    /// Was everything there that was asked for, of the kind it was asked for, and nothing else?
    bool is_complete() const { return is_good_ && rest_.empty(); }

    /// Is everything so far of the kind it was asked for?
    bool is_good() const { return is_good_; }

private:
    std::string_view next();

    std::string_view rest_;
    bool is_good_ = true;
};

}  // namespace stridor::base
