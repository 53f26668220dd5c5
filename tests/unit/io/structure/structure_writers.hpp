#pragma once

// Small writers of the formats that programs store matrices in, independent of the readers.

#include "structure_texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>

namespace stridor::io::structure {

/// Calls back with row and column from 0 for each entry of one triangle (row >= column), or of both.
inline void each_entry(const reduction::SparseMatrix& matrix, bool both,
                       const std::function<void(int, int, double)>& take) {
    for (int column = 0; column < matrix.outerSize(); ++column)
        for (reduction::SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
            if (both || entry.row() >= column) take(static_cast<int>(entry.row()), column, entry.value());
}

inline std::string matrix_market(const reduction::SparseMatrix& matrix, bool both) {
    std::string lines;
    int count = 0;
    each_entry(matrix, both, [&](int row, int column, double value) {
        lines += fmt::format("{} {} {:.17g}\n", row + 1, column + 1, value);
        ++count;
    });
    return fmt::format("%%MatrixMarket matrix coordinate real {}\n% a comment\n{} {} {}\n{}",
                       both ? "general" : "symmetric", matrix.rows(), matrix.rows(), count, lines);
}

inline std::string matrix_market_array(const reduction::SparseMatrix& matrix) {
    std::string text = fmt::format("%%MatrixMarket matrix array real general\n{} {}\n", matrix.rows(), matrix.cols());
    const Eigen::MatrixXd dense(matrix);
    for (Eigen::Index k = 0; k < dense.size(); ++k)
        text += fmt::format("{:.17g}\n", dense.data()[k]);
    return text;
}

inline std::string label_table(const reduction::ElasticPart& part, char mark) {
    std::string text = fmt::format("node{0}component{0}x [mm]{0}y [mm]{0}z [mm]{0}set\n", mark);
    for (const auto& label : part.labels) {
        const Eigen::Vector3d place = 1e3 * part.positions.at(label.node);
        const bool is_foot = std::stoi(label.node) < 1012;
        text += fmt::format("{1}{0}{2}{0}{3}{0}{4}{0}{5}{0}{6}\n", mark, label.node, label.component, place[0],
                            place[1], place[2], is_foot ? "FOOT NALL" : "NALL");
    }
    return text;
}

inline std::string abaqus(const reduction::ElasticPart& part, const reduction::SparseMatrix& matrix) {
    std::string text = "** ASSEMBLED MATRIX\n";
    each_entry(matrix, false, [&](int row, int column, double value) {
        const auto& a = part.labels[static_cast<std::size_t>(row)];
        const auto& b = part.labels[static_cast<std::size_t>(column)];
        text += fmt::format("{},{}, {},{}, {:.17e}\n", a.node, a.component, b.node, b.component, value);
    });
    return text;
}

inline std::string parted_by_blanks(std::string text) {
    std::replace(text.begin(), text.end(), ',', ' ');
    return text;
}

// a substructure: one node per row, as CalculiX writes them
inline std::string user_element(const reduction::ElasticPart& part) {
    std::string text = fmt::format(
        "**\n** GENERATION OF SUBSTRUCTURE\n*USER ELEMENT,NODES={:11},LINEAR\n** ELEMENT NODES", part.labels.size());
    for (std::size_t k = 0; k < part.labels.size(); ++k)
        text += fmt::format("{}{:>10},", k % 10 == 0 ? "\n**" : "", part.labels[k].node);
    text += fmt::format("\n{:10}\n", part.labels.front().component);
    for (std::size_t k = 1; k < part.labels.size(); ++k)
        text += fmt::format("{:10},{:10}\n", k + 1, part.labels[k].component);
    for (const auto& [type, matrix] : {std::pair("STIFFNESS", part.stiffness), std::pair("MASS", part.mass)}) {
        text += fmt::format("*MATRIX,TYPE={}\n", type);
        const Eigen::MatrixXd dense(matrix);
        int count = 0;
        for (Eigen::Index row = 0; row < dense.rows(); ++row)
            for (Eigen::Index column = 0; column <= row; ++column)
                text += fmt::format("{:24.16e},{}", dense(row, column), ++count % 4 == 0 ? "\n" : "");
        text += "\n";
    }
    return text;
}

inline std::string coordinates(const reduction::SparseMatrix& matrix) {
    std::string text;
    each_entry(matrix, true, [&](int row, int column, double value) {
        text += fmt::format("{:>8} {:>8}  {:.16E}\n", row + 1, column + 1, value);
    });
    return text;
}

// a field of 16 columns holds some ten digits: so that the same numbers come back, they are rounded before
inline double rounded(double value) {
    return std::stod(fmt::format("{:.8e}", value));
}

inline reduction::SparseMatrix rounded(reduction::SparseMatrix matrix) {
    for (int column = 0; column < matrix.outerSize(); ++column)
        for (reduction::SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
            entry.valueRef() = rounded(entry.value());
    return matrix;
}

inline std::string fortran(double value) {
    std::string text = fmt::format("{:.8e}", value);
    text.replace(text.find('e'), 1, "D");
    return text;
}

inline std::string dmig(const reduction::ElasticPart& part, const reduction::SparseMatrix& matrix,
                        const std::string& name) {
    std::string text =
        fmt::format("DMIG    {:8}       0       6       2       0                {:>8}\n", name, matrix.cols());
    for (int column = 0; column < matrix.outerSize(); ++column) {
        const auto& label = part.labels[static_cast<std::size_t>(column)];
        text += fmt::format("DMIG*   {:16}{:>16}{:>16}\n", name, label.node, label.component);
        for (reduction::SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
            if (entry.row() >= column)
                text +=
                    fmt::format("*       {:>16}{:>16}{:>16}\n", part.labels[static_cast<std::size_t>(entry.row())].node,
                                part.labels[static_cast<std::size_t>(entry.row())].component, fortran(entry.value()));
    }
    return text;
}

inline std::string grids(const reduction::ElasticPart& part) {
    std::string text = "$ places\n";
    for (const auto& [node, place] : part.positions)
        text += fmt::format("GRID*   {:>16}{:>16}{:>16.9E}{:>16.9E}\n*       {:>16.9E}\n", node, "", place[0], place[1],
                            place[2]);
    return text;
}

enum class Sparse { none, packed, big };

inline std::string output4(const reduction::SparseMatrix& matrix, const std::string& name, Sparse sparse) {
    const auto rows = matrix.rows();
    std::string text =
        fmt::format("{:8}{:8}{:8}{:8}{:<8}1P,3E23.16\n", rows, sparse == Sparse::big ? -rows : rows, 6, 2, name);
    const auto values = [&](const std::vector<double>& numbers) {
        for (std::size_t k = 0; k < numbers.size(); ++k)
            text += fmt::format("{:23.16E}{}", numbers[k], k % 3 == 2 || k + 1 == numbers.size() ? "\n" : "");
    };
    const Eigen::MatrixXd dense(matrix);
    for (Eigen::Index column = 0; column < rows; ++column) {
        if (sparse == Sparse::none) {
            text += fmt::format("{:8}{:8}{:8}\n", column + 1, 1, rows);
            values({dense.col(column).begin(), dense.col(column).end()});
            continue;
        }
        std::vector<std::pair<Eigen::Index, std::vector<double>>> strings;
        for (reduction::SparseMatrix::InnerIterator entry(matrix, static_cast<int>(column)); entry; ++entry) {
            if (strings.empty() ||
                strings.back().first + static_cast<Eigen::Index>(strings.back().second.size()) != entry.row())
                strings.push_back({entry.row(), {}});
            strings.back().second.push_back(entry.value());
        }
        std::size_t words = 0;
        for (const auto& each : strings)
            words += 2 * each.second.size() + (sparse == Sparse::big ? 2 : 1);
        text += fmt::format("{:8}{:8}{:8}\n", column + 1, 0, words);
        for (const auto& [first, numbers] : strings) {
            if (sparse == Sparse::big)
                text += fmt::format("{:8}{:8}\n", 2 * numbers.size() + 1, first + 1);
            else
                text += fmt::format("{:12}\n", first + 1 + 65536 * static_cast<Eigen::Index>(2 * numbers.size() + 1));
            values(numbers);
        }
    }
    return text + fmt::format("{:8}{:8}{:8}\n{:23.16E}\n", rows + 1, 1, 1, 1.0);
}

inline std::string harwell_boeing(const reduction::SparseMatrix& matrix, const std::string& title) {
    std::vector<int> pointers{1};
    std::vector<int> rows;
    std::vector<double> values;
    for (int column = 0; column < matrix.outerSize(); ++column) {
        for (reduction::SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
            if (entry.row() >= column) {
                rows.push_back(static_cast<int>(entry.row()) + 1);
                values.push_back(entry.value());
            }
        pointers.push_back(static_cast<int>(rows.size()) + 1);
    }
    std::string text = title + " matrix from ANSYS FULL file dumped into Harwell-Boeing format\n";
    text += fmt::format("{:14}{:14}{:14}{:14}{:14}\n", pointers.size() + 2 * rows.size() + 2, pointers.size(),
                        rows.size(), values.size(), 2);
    text += fmt::format("RSA           {:14}{:14}{:14}{:14}\n", matrix.rows(), matrix.rows(), rows.size(), 0);
    text +=
        "(I14)           (I14)           (d25.15)            (d25.15)\nF                          1             2\n";
    for (const int each : pointers)
        text += fmt::format("{:14}\n", each);
    for (const int each : rows)
        text += fmt::format("{:14}\n", each);
    for (const double each : values) {
        std::string number = fmt::format("{:25.17e}", each);
        text += number.replace(number.find('e'), 1, "D") + "\n";
    }
    return text + "    0.0D+00\n    0.0D+00\n";
}

inline std::string mapping(const reduction::ElasticPart& part) {
    std::string text = "    Matrix Eqn          Node    DOF     \n";
    const std::array<const char*, 3> names{"UX", "UY", "UZ"};
    for (std::size_t row = 0; row < part.labels.size(); ++row)
        text += fmt::format("{:14}{:>14}    {}\n", row + 1, part.labels[row].node,
                            names.at(static_cast<std::size_t>(part.labels[row].component - 1)));
    return text;
}

inline void expect_same(const reduction::ElasticPart& part, const reduction::ElasticPart& block,
                        const std::string& format) {
    EXPECT_NO_THROW(expect_sound(part)) << format;
    ASSERT_EQ(part.labels, block.labels) << format;
    EXPECT_EQ((part.stiffness - block.stiffness).norm(), 0.0) << format;
    EXPECT_EQ((part.mass - block.mass).norm(), 0.0) << format;
}

/// The bytes of numbers, lowest first.
template <typename Number>
std::string little(const std::vector<Number>& numbers) {
    std::string bytes(numbers.size() * sizeof(Number), '\0');
    std::memcpy(bytes.data(), numbers.data(), bytes.size());
    return bytes;
}

/// Highest first.
template <typename Number>
std::string big(const std::vector<Number>& numbers) {
    std::string bytes = little(numbers);
    for (std::size_t at = 0; at < bytes.size(); at += sizeof(Number))
        std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                     bytes.begin() + static_cast<std::ptrdiff_t>(at + sizeof(Number)));
    return bytes;
}

/// How a binary OUTPUT4 file is written.
struct Output4Words {
    bool is_big_endian = false;
    bool is_wide = false;    // words of eight bytes
    bool is_single = false;  // type 1
    Sparse sparse = Sparse::none;
};

/// Words of one Fortran record.
class Output4Record {
public:
    explicit Output4Record(Output4Words words) : words_(words) {}

    Output4Record& integer(std::int64_t value) {
        bytes_ += words_.is_wide ? ordered(std::vector{value}) : ordered(std::vector{static_cast<std::int32_t>(value)});
        return *this;
    }
    Output4Record& real(double value) {
        bytes_ += words_.is_single && !words_.is_wide ? ordered(std::vector{static_cast<float>(value)})
                                                      : ordered(std::vector{value});
        return *this;
    }
    Output4Record& text(std::string name) {
        name.resize(words_.is_wide ? 16 : 8, ' ');
        bytes_ += name;
        return *this;
    }
    std::string take() const {
        const std::string marker = ordered(std::vector{static_cast<std::uint32_t>(bytes_.size())});
        return marker + bytes_ + marker;
    }

private:
    template <typename Number>
    std::string ordered(const std::vector<Number>& numbers) const {
        return words_.is_big_endian ? big(numbers) : little(numbers);
    }

    Output4Words words_;
    std::string bytes_;
};

inline std::string output4_binary(const reduction::SparseMatrix& matrix, const std::string& name, Output4Words how) {
    const auto rows = static_cast<std::int64_t>(matrix.rows());
    const std::int64_t words_of_value = how.is_wide || how.is_single ? 1 : 2;
    std::string file = Output4Record(how)
                           .integer(rows)
                           .integer(how.sparse == Sparse::big ? -rows : rows)
                           .integer(6)
                           .integer(how.is_single ? 1 : 2)
                           .text(name)
                           .take();
    const Eigen::MatrixXd dense(matrix);
    for (std::int64_t column = 0; column < rows; ++column) {
        Output4Record record(how);
        if (how.sparse == Sparse::none) {
            record.integer(column + 1).integer(1).integer(words_of_value * rows);
            for (const double value : dense.col(column))
                record.real(value);
        } else {  // each entry as a string of its own
            const std::int64_t head = how.sparse == Sparse::big ? 2 : 1;
            const auto count = static_cast<std::int64_t>(matrix.col(column).nonZeros());
            record.integer(column + 1).integer(0).integer(count * (head + words_of_value));
            for (reduction::SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry) {
                if (how.sparse == Sparse::big)
                    record.integer(words_of_value + 1).integer(entry.row() + 1);
                else
                    record.integer(entry.row() + 1 + 65536 * (words_of_value + 1));
                record.real(entry.value());
            }
        }
        file += record.take();
    }
    return file + Output4Record(how).integer(rows + 1).integer(1).integer(words_of_value).real(1.0).take();
}

/// NumPy's file of one array, whose header is a literal of Python.
inline std::string npy_of(std::string header, const std::string& bytes) {
    header.resize((header.size() + 11 + 63) / 64 * 64 - 11, ' ');
    header += '\n';
    return "\x93NUMPY\x01" + std::string(1, '\0') + little<std::uint16_t>({static_cast<std::uint16_t>(header.size())}) +
           header + bytes;
}

inline std::string npy(const std::string& descr, const std::string& shape, const std::string& bytes,
                       const std::string& is_by_columns = "False") {
    return npy_of(fmt::format("{{'descr': '{}', 'fortran_order': {}, 'shape': {}, }}", descr, is_by_columns, shape),
                  bytes);
}

/// CRC-32 as zip wants it.
inline std::uint32_t checksum(const std::string& bytes) {
    std::uint32_t sum = 0xffffffffU;
    for (const char byte : bytes) {
        sum ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit)
            sum = (sum >> 1U) ^ ((sum & 1U) != 0U ? 0xedb88320U : 0U);
    }
    return ~sum;
}

/// A zip archive of stored files (APPNOTE 6.3: local headers, central directory, its end).
inline std::string zip(const std::map<std::string, std::string>& members) {
    std::string archive;
    std::string directory;
    const auto words = [](std::vector<std::uint16_t> numbers) { return little(numbers); };
    const auto longs = [](std::vector<std::uint32_t> numbers) { return little(numbers); };
    for (const auto& [name, bytes] : members) {
        const auto size = static_cast<std::uint32_t>(bytes.size());
        const std::string facts = words({20, 0, 0, 0, 33}) + longs({checksum(bytes), size, size}) +
                                  words({static_cast<std::uint16_t>(name.size()), 0});
        directory += "PK\x01\x02" + words({20}) + facts + words({0, 0, 0}) +
                     longs({0, static_cast<std::uint32_t>(archive.size())}) + name;
        archive += "PK\x03\x04" + facts + name + bytes;
    }
    const auto count = static_cast<std::uint16_t>(members.size());
    return archive + directory + "PK\x05\x06" + words({0, 0, count, count}) +
           longs({static_cast<std::uint32_t>(directory.size()), static_cast<std::uint32_t>(archive.size())}) +
           words({0});
}

/// What `scipy.sparse.save_npz` writes of a matrix, uncompressed.
inline std::string scipy(const reduction::SparseMatrix& matrix) {
    std::vector<double> data;
    std::vector<std::int32_t> indices;
    std::vector<std::int32_t> pointers{0};
    for (int column = 0; column < matrix.outerSize(); ++column) {
        for (reduction::SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry) {
            data.push_back(entry.value());
            indices.push_back(static_cast<std::int32_t>(entry.row()));
        }
        pointers.push_back(static_cast<std::int32_t>(data.size()));
    }
    const auto length = [](std::size_t count) { return fmt::format("({},)", count); };
    return zip({{"data.npy", npy("<f8", length(data.size()), little(data))},
                {"indices.npy", npy("<i4", length(indices.size()), little(indices))},
                {"indptr.npy", npy("<i4", length(pointers.size()), little(pointers))},
                {"format.npy", npy("|S3", "()", "csc")},
                {"shape.npy", npy("<i8", "(2,)", little<std::int64_t>({matrix.rows(), matrix.cols()}))}});
}

}  // namespace stridor::io::structure
