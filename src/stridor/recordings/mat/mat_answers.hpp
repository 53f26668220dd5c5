#pragma once

// The answers of a process that reads a MAT file to the process that asks, byte by byte. Private to this folder.
//
//   -> Opened, then so many times VariableHead and a name
//   <- so many columns: std::uint64_t, then Column each
//   -> std::uint32_t 1, then the columns' numbers as doubles, shape [frame][column]; or 0 where they cannot be read
//   <- the next columns, and so on

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace stridor::recordings::mat {

inline constexpr std::uint32_t most_variables = 4096;  // in a file
inline constexpr std::uint32_t longest_name = 255;     // [bytes]; MATLAB's own are up to 63

/// The content of a variable. Only numbers can be samples.
enum class MatKind : std::uint32_t {
    doubles,
    singles,
    integers,
    truth_values,
    complex,
    sparse,
    text,
    cells,
    structure,
    several_dimensions,
    nothing,
    object,
    count
};

/// The first answer: whether the file opened, and how many variables it has.
struct Opened {
    std::uint32_t is_open = 0;
    std::uint32_t variables = 0;
};

/// The properties of a variable before its numbers are read; its name follows.
struct VariableHead {
    MatKind kind = MatKind::object;
    std::uint32_t name_length = 0;  // [bytes]
    std::uint64_t rows = 0;
    std::uint64_t columns = 0;
    double value = 0.0;  // of a single number
};

/// One channel of a variable.
struct MatColumn {
    std::uint64_t variable = 0;  // from 0, as the file lists them
    std::uint64_t index = 0;     // from 0
    std::uint64_t is_flat = 0;   // whether its rows are the channels, and its columns the instants
    friend bool operator==(const MatColumn&, const MatColumn&) = default;
};

/// The process that answers.
class Answers {
public:
    virtual ~Answers() = default;
    /// Sends a question.
    virtual void send(std::span<const std::byte> bytes) = 0;
    /// Fills the bytes; returns false if there are no more.
    virtual bool receive(std::span<std::byte> into) = 0;
    /// Returns why there are no more: "it crashed (signal 11)".
    virtual std::string ending() = 0;
};

}  // namespace stridor::recordings::mat
