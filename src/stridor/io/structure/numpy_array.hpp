#pragma once

// NumPy's file of one array, .npy (NEP 1; versions 1 to 3): "\x93NUMPY", version, length of a header, the header as a
// literal of Python, the numbers.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::io::structure {

/// An array as the file holds it.
struct NumpyArray {
    std::string shown;                   // file and array, for messages: "k.npz: data"
    char kind = 'f';                     // NumPy's: f real, i and u whole, b truth, S bytes
    std::size_t width = 8;               // [bytes] of an element
    bool is_big_endian = false;          // the first byte of an element is its highest
    bool is_column_major = false;        // the first index runs fastest
    std::vector<std::uint64_t> shape{};  // [1]
    std::uint64_t size = 1;              // [1] elements
    std::string_view bytes{};            // of all elements; they belong to the caller
};

/// Says whether a file begins as .npy does.
bool is_numpy_array(std::string_view beginning);

/// Reads the header. Throws `Error` (input) for any other file, for elements that are not numbers (complex, pickled,
/// structured), more than two indices, and bytes that do not fit the shape.
NumpyArray read_numpy_array(std::string_view bytes, const std::string& shown);

/// Returns all elements in the order of the file. Throws `Error` (input) for an element that is not a number or not
/// finite.
std::vector<double> reals_of(const NumpyArray& array);

/// Returns all elements as whole numbers, in the order of the file. Throws `Error` (input) for other kinds.
std::vector<std::int64_t> integers_of(const NumpyArray& array);

}  // namespace stridor::io::structure
