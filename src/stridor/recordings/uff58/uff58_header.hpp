#pragma once

// Datasets 58 and 58b of the Universal File Format: finding them in a file, and their headers. Private to this folder.

#include "stridor/recordings/line_reader.hpp"
#include "stridor/recordings/raw_signal.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::recordings::uff58 {

/// The form of the numbers of a dataset in the file.
enum class Form { ascii, little_endian, big_endian };

/// Type of a function (record 6, field 1).
inline constexpr int general_function = 0;
inline constexpr int time_response = 1;

/// Type of an abscissa (record 8, field 1).
inline constexpr int time_abscissa = 17;

/// Type of an ordinate (record 7, field 1).
inline constexpr int real_single = 2;
inline constexpr int real_double = 4;

/// One function of the file.
struct Dataset {
    Form form = Form::ascii;
    int number = 1;  // [1] of all time histories of the file
    std::array<std::string, 5> id{};
    std::string response;  // node and direction, "12:3"
    std::string label;     // of the ordinate's axis; may be empty
    std::string unit;      // its label; may be empty
    int ordinate = real_single;
    std::uint64_t count = 0;        // [1] values
    double start = 0.0;             // [s] of the first value
    double rate = 0.0;              // [Hz]
    std::string rate_note;          // to the user; may be empty
    std::string count_note;         // to the user; may be empty
    std::uint64_t data_offset = 0;  // [bytes]
    int data_line = 1;              // [1] of the first line of values
};

/// The datasets found in a file.
struct Contents {
    std::vector<Dataset> histories;  // functions over time
    std::size_t left_out = 0;        // other datasets and functions
};

/// Walks through a file. If a header states another number of values than stand before the mark, the existing ones
/// count, and a note says so. Throws `Error` (input) with file and line for a header that cannot be understood, for
/// time histories of uneven step or complex values, and for those that end without their mark.
Contents find_datasets(const SignalInput& input);

/// Returns the numbers in a line of ASCII values. Values without blanks between are split into columns of 13, or of 20
/// for doubles. Throws `Error` (input) with line and column for a text that is not a number.
std::vector<double> values_in(const TextLine& line, int ordinate, const std::string& file);

/// Says whether this line is the mark between datasets, "    -1".
bool is_mark(std::string_view line);

}  // namespace stridor::recordings::uff58
