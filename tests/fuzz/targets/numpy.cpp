#include "fuzz/targets/targets.hpp"
#include "stridor/base/error.hpp"
#include "stridor/io/structure/numpy_matrix.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace stridor::fuzz {

namespace {

using io::structure::ListedMatrix;

constexpr std::string_view begin_of_array = "\x93NUMPY";

/// Arrays that stand one behind the other: nobody guesses the checksums of a zip archive.
std::vector<std::string> arrays_in(std::string_view bytes) {
    std::vector<std::string> arrays;
    for (std::size_t from = bytes.find(begin_of_array); from < bytes.size();) {
        const std::size_t end = std::min(bytes.find(begin_of_array, from + 1), bytes.size());
        arrays.emplace_back(bytes.substr(from, end - from));
        from = end;
    }
    return arrays;
}

// whatever is read has its entries within its rows, none beside another
template <typename Read>
void expect_matrices(Read read) {
    try {
        for (const ListedMatrix& matrix : read()) {
            for (const auto& entry : matrix.entries)
                require(entry.row() >= 0 && entry.row() < matrix.rows && entry.col() >= 0 && entry.col() < matrix.rows);
            symmetric_matrix(matrix);
        }
    } catch (const Error& error) {
        require(error.kind() == ErrorKind::input && error.place().has_value() && !error.problem().what.empty());
    }
}

}  // namespace

void numpy(std::string_view bytes) {
    const io::structure::StructureInput input{recordings::bytes_of(std::string(bytes)), "input"};
    expect_matrices([&] { return std::vector{io::structure::read_npy(input)}; });
    expect_matrices([&] { return io::structure::read_npz(input); });
    const std::vector<std::string> arrays = arrays_in(bytes);
    std::map<std::string, std::string> members;
    for (std::size_t k = 0; k < arrays.size() && k < 26; ++k)
        members[std::string(1, static_cast<char>('A' + k)) + ".npy"] = arrays[k];
    expect_matrices([&] { return io::structure::numpy_matrices(members, "input"); });
    if (arrays.size() < 5) return;
    expect_matrices([&] {
        return io::structure::numpy_matrices({{"format.npy", arrays[0]},
                                              {"shape.npy", arrays[1]},
                                              {"data.npy", arrays[2]},
                                              {"indices.npy", arrays[3]},
                                              {"indptr.npy", arrays[4]},
                                              {"row.npy", arrays[3]},
                                              {"col.npy", arrays[4]}},
                                             "input");
    });
}

}  // namespace stridor::fuzz
