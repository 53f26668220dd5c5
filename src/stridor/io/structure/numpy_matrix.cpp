#include "stridor/io/structure/numpy_matrix.hpp"

#include "stridor/io/structure/numpy_array.hpp"
#include "stridor/io/structure/zip_archive.hpp"
#include "stridor/recordings/raw_signal.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace stridor::io::structure {

namespace {

using recordings::refusal;

using Members = std::map<std::string, std::string>;
using Entries = std::vector<Eigen::Triplet<double>>;

constexpr std::uint64_t largest_npy = std::uint64_t{2} << 30U;  // [bytes]

// zeros are left out: a dense matrix of a structure is nearly empty
ListedMatrix dense_matrix(const NumpyArray& array, const std::string& file) {
    if (array.shape.size() != 2 || array.shape[0] != array.shape[1])
        throw refusal(array.shown, "the array is not square", "a matrix of a structure is");
    const std::vector<double> values = reals_of(array);
    const auto rows = static_cast<int>(array.shape[0]);
    ListedMatrix matrix{.file = file, .triangles = Triangles::both, .rows = rows};
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < rows; ++column) {
            const int slow = array.is_column_major ? column : row;
            const int fast = array.is_column_major ? row : column;
            const double value = values[static_cast<std::size_t>(slow) * static_cast<std::size_t>(rows) +
                                        static_cast<std::size_t>(fast)];
            if (value != 0.0) matrix.entries.emplace_back(row, column, value);
        }
    return matrix;
}

/// A sparse matrix of SciPy: arrays by name.
class ScipyMatrix {
public:
    ScipyMatrix(const Members& members, const std::string& file) : members_(members), file_(file) {}

    ListedMatrix read() const {
        const std::string format(array("format").bytes);
        const std::vector<std::int64_t> shape = integers("shape");
        constexpr std::int64_t most_rows = 0x7fffffff;
        if (shape.size() != 2 || shape[0] != shape[1] || shape[0] < 1 || shape[0] > most_rows)
            throw refusal(file_, "the matrix is not square", "those of a structure are");
        const auto rows = static_cast<Eigen::Index>(shape[0]);
        ListedMatrix matrix{.file = file_, .rows = rows};
        if (format == "csr" || format == "csc")
            matrix.entries = compressed(rows, format == "csr");
        else if (format == "coo")
            matrix.entries = listed(rows);
        else
            throw refusal(file_, fmt::format("it holds a matrix in SciPy's format \"{}\"", printable(format)),
                          "csr, csc and coo are read", "Save it as scipy.sparse.save_npz(FILE, matrix.tocsr()).");
        sum_equal_places(matrix.entries);
        return matrix;
    }

private:
    static std::string printable(const std::string& text) {
        const bool is_plain = std::all_of(text.begin(), text.end(), [](char c) { return c >= 'a' && c <= 'z'; });
        return is_plain ? text : "?";
    }

    NumpyArray array(const std::string& name) const {
        const auto found = members_.find(name + ".npy");
        if (found == members_.end())
            throw refusal(file_, fmt::format("it lacks the array \"{}\"", name),
                          "scipy.sparse.save_npz writes data, format, shape and where each number stands");
        return read_numpy_array(found->second, file_ + ": " + name);
    }

    std::vector<std::int64_t> integers(const std::string& name) const { return integers_of(array(name)); }

    int checked(std::int64_t index, Eigen::Index rows) const {
        if (index < 0 || index >= rows)
            throw refusal(file_, fmt::format("there is no row {}", index),
                          fmt::format("they count from 0 to {}", rows - 1));
        return static_cast<int>(index);
    }

    [[noreturn]] void refuse_lengths() const {
        throw refusal(file_, "its arrays do not fit each other", "each number needs its row and its column",
                      "Is the file damaged?");
    }

    Entries compressed(Eigen::Index rows, bool by_rows) const {
        const std::vector<double> values = reals_of(array("data"));
        const std::vector<std::int64_t> others = integers("indices");
        const std::vector<std::int64_t> pointers = integers("indptr");
        const auto count = static_cast<std::int64_t>(values.size());
        if (others.size() != values.size() || pointers.size() != static_cast<std::size_t>(rows) + 1 ||
            pointers.front() != 0 || pointers.back() != count || !std::is_sorted(pointers.begin(), pointers.end()))
            refuse_lengths();
        Entries entries;
        entries.reserve(values.size());
        for (std::size_t line = 0; line + 1 < pointers.size(); ++line)
            for (auto k = static_cast<std::size_t>(pointers[line]); k < static_cast<std::size_t>(pointers[line + 1]);
                 ++k) {
                const int here = static_cast<int>(line);
                const int other = checked(others[k], rows);
                entries.emplace_back(by_rows ? here : other, by_rows ? other : here, values[k]);
            }
        return entries;
    }

    Entries listed(Eigen::Index rows) const {
        const std::vector<double> values = reals_of(array("data"));
        const std::vector<std::int64_t> down = integers("row");
        const std::vector<std::int64_t> across = integers("col");
        if (down.size() != values.size() || across.size() != values.size()) refuse_lengths();
        Entries entries;
        entries.reserve(values.size());
        for (std::size_t k = 0; k < values.size(); ++k)
            entries.emplace_back(checked(down[k], rows), checked(across[k], rows), values[k]);
        return entries;
    }

    // what assembles elements leaves a number for each of them; SciPy means their sum, in their order
    static void sum_equal_places(Entries& entries) {
        const auto place = [](const auto& entry) { return std::pair(entry.col(), entry.row()); };
        std::stable_sort(entries.begin(), entries.end(),
                         [&](const auto& a, const auto& b) { return place(a) < place(b); });
        Entries sums;
        for (const auto& entry : entries)
            if (!sums.empty() && place(sums.back()) == place(entry))
                sums.back() = {entry.row(), entry.col(), sums.back().value() + entry.value()};
            else
                sums.push_back(entry);
        entries = std::move(sums);
    }

    const Members& members_;
    const std::string& file_;
};

MatrixRole role_of_array(std::string_view name) {
    const std::string large = upper(name);
    if (large == "STIFFNESS") return MatrixRole::stiffness;
    if (large == "C" || large == "DAMPING") return MatrixRole::damping;
    return role_of_name(large);
}

// what has another name may be of any kind: it is left out unless it is asked for
ListedMatrix named_array(const std::string& name, const std::string& bytes, const std::string& file) {
    ListedMatrix matrix{.file = file, .name = name, .is_passed_over = true};
    const MatrixRole role = role_of_array(name);
    try {
        const NumpyArray array = read_numpy_array(bytes, file + ": " + name);
        const bool is_square = array.shape.size() == 2 && array.shape[0] == array.shape[1];
        if (is_square || role != MatrixRole::other) matrix = dense_matrix(array, file);
    } catch (const base::Error&) {
        if (role != MatrixRole::other) throw;
    }
    matrix.name = name;
    matrix.role = role;
    return matrix;
}

}  // namespace

std::vector<ListedMatrix> numpy_matrices(const Members& members, const std::string& file) {
    if (members.contains("format.npy")) return {ScipyMatrix(members, file).read()};
    std::vector<ListedMatrix> matrices;
    for (const auto& [name, bytes] : members) {
        if (!name.ends_with(".npy"))
            throw refusal(file, "it holds something else than arrays of NumPy", "a .npz holds files .npy");
        const std::string bare = name.substr(0, name.size() - 4);
        matrices.push_back(named_array(bare, bytes, file));
    }
    if (std::all_of(matrices.begin(), matrices.end(), [](const auto& each) { return each.is_passed_over; }))
        throw refusal(file, "there is no matrix in it");
    return matrices;
}

std::vector<ListedMatrix> read_npz(const StructureInput& input) {
    return numpy_matrices(read_zip(input), input.name);
}

ListedMatrix read_npy(const StructureInput& input) {
    if (input.bytes->size() > largest_npy)
        throw refusal(input.name, "it is larger than 2 GiB", "its matrix would not fit into memory",
                      "Save it as a sparse matrix: scipy.sparse.save_npz.");
    const std::string bytes = recordings::text_at(*input.bytes, 0, static_cast<std::size_t>(input.bytes->size()));
    return dense_matrix(read_numpy_array(bytes, input.name), input.name);
}

}  // namespace stridor::io::structure
