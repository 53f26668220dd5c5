#include "stridor/io/structure/listed_matrix.hpp"

#include "stridor/base/text.hpp"
#include "stridor/recordings/raw_signal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

namespace stridor::io::structure {

namespace {

using recordings::refusal;
using reduction::describe;
using reduction::RowLabel;
using reduction::SparseMatrix;

constexpr double symmetry_tolerance = 1e-10;  // [1] of the diagonal
constexpr double penalty = 1e30;              // what Abaqus puts on the diagonal of a held row is 1e36
constexpr Eigen::Index rows_per_entry = 20;   // most that a sparse matrix of a structure could have
constexpr Eigen::Index spare_rows = 1000;

std::string place_in(const ListedMatrix& matrix, Eigen::Index row, Eigen::Index column) {
    if (matrix.labels.empty()) return fmt::format("row {}, column {}", row + 1, column + 1);
    return describe(matrix.labels[static_cast<std::size_t>(row)]) + ", " +
           describe(matrix.labels[static_cast<std::size_t>(column)]);
}

std::string shown(const ListedMatrix& matrix) {
    return matrix.name.empty() ? std::string("the matrix") : "matrix " + matrix.name;
}

// each entry once; zeros are left out
SparseMatrix listed_entries(const ListedMatrix& matrix) {
    if (matrix.rows > rows_per_entry * static_cast<Eigen::Index>(matrix.entries.size()) + spare_rows)
        throw refusal(
            matrix.file,
            fmt::format("{} has {} rows, but only {} entries", shown(matrix), matrix.rows, matrix.entries.size()),
            "a structure has at least one entry in each row", "Is the file cut off?");
    SparseMatrix listed(matrix.rows, matrix.rows);
    bool is_twice = false;
    listed.setFromTriplets(matrix.entries.begin(), matrix.entries.end(), [&](double, double second) {
        is_twice = true;
        return second;
    });
    if (is_twice) {
        std::set<std::pair<int, int>> seen;
        for (const auto& entry : matrix.entries)
            if (!seen.insert({entry.row(), entry.col()}).second)
                throw refusal(matrix.file,
                              fmt::format("{} holds the entry {} twice", shown(matrix),
                                          place_in(matrix, entry.row(), entry.col())),
                              "which of them counts is not said");
    }
    listed.prune(0.0, 0.0);
    return listed;
}

bool has_mirrored_pair(const SparseMatrix& listed, const SparseMatrix& mirrored) {
    for (Eigen::Index column = 0; column < listed.outerSize(); ++column) {
        SparseMatrix::InnerIterator other(mirrored, column);
        for (SparseMatrix::InnerIterator entry(listed, column); entry; ++entry) {
            while (other && other.row() < entry.row())
                ++other;
            if (other && other.row() == entry.row() && entry.row() != column) return true;
        }
    }
    return false;
}

void expect_mirrored(const ListedMatrix& matrix, const SparseMatrix& listed) {
    const Eigen::VectorXd diagonal = listed.diagonal().cwiseAbs();
    const SparseMatrix apart = listed - SparseMatrix(listed.transpose());
    for (Eigen::Index column = 0; column < apart.outerSize(); ++column)
        for (SparseMatrix::InnerIterator entry(apart, column); entry; ++entry) {
            const double here = listed.coeff(entry.row(), column);
            const double scale = std::sqrt(diagonal[entry.row()]) * std::sqrt(diagonal[column]) + std::abs(here);
            if (std::abs(entry.value()) > symmetry_tolerance * scale)
                throw refusal(
                    matrix.file, fmt::format("{} is not symmetric", shown(matrix)),
                    fmt::format("at {} it holds {}, across the diagonal {}", place_in(matrix, entry.row(), column),
                                base::shortest(here), base::shortest(listed.coeff(column, entry.row()))),
                    "Leave out what makes it so: friction, follower loads, rotating frames.");
        }
}

// without the rows marked, which are given new numbers otherwise
void keep_rows(ListedMatrix& matrix, const std::vector<Eigen::Index>& place, Eigen::Index rows) {
    std::vector<Eigen::Triplet<double>> entries;
    for (const auto& entry : matrix.entries) {
        const Eigen::Index row = place[static_cast<std::size_t>(entry.row())];
        const Eigen::Index column = place[static_cast<std::size_t>(entry.col())];
        if (row >= 0 && column >= 0) entries.emplace_back(row, column, entry.value());
    }
    matrix.entries = std::move(entries);
    matrix.rows = rows;
}

// how many rows were held by a penalty
Eigen::Index drop_held_rows(ListedMatrix& stiffness, std::set<RowLabel>& dropped) {
    if (stiffness.labels.empty()) return 0;
    std::vector<Eigen::Index> place(static_cast<std::size_t>(stiffness.rows), 0);
    for (const auto& entry : stiffness.entries)
        if (entry.row() == entry.col() && entry.value() >= penalty) place[static_cast<std::size_t>(entry.row())] = -1;
    Eigen::Index rows = 0;
    std::vector<RowLabel> labels;
    for (std::size_t row = 0; row < place.size(); ++row) {
        if (place[row] < 0) {
            dropped.insert(stiffness.labels[row]);
            continue;
        }
        place[row] = rows++;
        labels.push_back(stiffness.labels[row]);
    }
    keep_rows(stiffness, place, rows);
    stiffness.labels = std::move(labels);
    return static_cast<Eigen::Index>(dropped.size());
}

// the rows of another matrix in the order of the stiffness
ListedMatrix ordered(const ListedMatrix& matrix, const ListedMatrix& stiffness, const std::set<RowLabel>& dropped) {
    ListedMatrix same = matrix;
    if (stiffness.labels.empty() || matrix.labels.empty()) {
        if (matrix.rows != stiffness.rows)
            throw refusal(
                matrix.file,
                fmt::format("the {} has {} rows, the stiffness {}", name_of(matrix.role), matrix.rows, stiffness.rows),
                "both must be of the same model");
        return same;
    }
    std::map<RowLabel, Eigen::Index> rows;
    for (std::size_t row = 0; row < stiffness.labels.size(); ++row)
        rows.emplace(stiffness.labels[row], static_cast<Eigen::Index>(row));
    std::vector<Eigen::Index> place(static_cast<std::size_t>(matrix.rows), -1);
    for (std::size_t row = 0; row < place.size(); ++row) {
        const auto found = rows.find(matrix.labels[row]);
        if (found != rows.end())
            place[row] = found->second;
        else if (!dropped.contains(matrix.labels[row]))
            throw refusal(matrix.file,
                          fmt::format("the {} has a row {} that the stiffness lacks", name_of(matrix.role),
                                      describe(matrix.labels[row])),
                          "both must be of the same model");
    }
    keep_rows(same, place, stiffness.rows);
    same.labels = stiffness.labels;
    return same;
}

std::string penalty_note(Eigen::Index rows) {
    return fmt::format("{} row{} held by a penalty of 1e30 or more {} taken out", rows, rows == 1 ? "" : "s",
                       rows == 1 ? "was" : "were");
}

}  // namespace

std::string_view name_of(MatrixRole role) {
    constexpr std::array<std::string_view, 6> names{"stiffness",          "mass",  "damping",
                                                    "structural damping", "other", "matrix"};
    return names.at(static_cast<std::size_t>(role));
}

MatrixRole role_of_name(std::string_view name) {
    const std::string large = upper(name);
    if (large.starts_with("K4")) return MatrixRole::structural_damping;
    if (large.starts_with("K")) return MatrixRole::stiffness;
    if (large.starts_with("M")) return MatrixRole::mass;
    if (large.starts_with("B")) return MatrixRole::damping;
    return MatrixRole::other;
}

void add_entry(ListedMatrix& matrix, const FieldScanner& scanner, std::int64_t row, std::int64_t column, double value) {
    constexpr std::int64_t most_rows = std::numeric_limits<int>::max();
    if (row < 1 || column < 1 || row > most_rows || column > most_rows)
        throw scanner.refusal(fmt::format("there is no row {}, column {}", row, column),
                              "rows and columns count from 1");
    matrix.entries.emplace_back(static_cast<int>(row - 1), static_cast<int>(column - 1), value);
    matrix.rows = std::max({matrix.rows, static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)});
}

Eigen::Index LabelOrder::row_of(const RowLabel& label) {
    return rows_.try_emplace(label, static_cast<Eigen::Index>(rows_.size())).first->second;
}

void LabelOrder::finish(ListedMatrix& matrix) const {
    struct Ranked {
        std::int64_t number;
        RowLabel label;
        Eigen::Index row;
    };
    std::vector<Ranked> all;
    for (const auto& [label, row] : rows_)
        all.push_back({integer_in(label.node).value_or(std::numeric_limits<std::int64_t>::max()), label, row});
    std::stable_sort(all.begin(), all.end(), [](const Ranked& a, const Ranked& b) {
        return a.number != b.number ? a.number < b.number : a.label.component < b.label.component;
    });
    std::vector<Eigen::Index> place(all.size());
    matrix.labels.clear();
    for (const Ranked& each : all) {
        place[static_cast<std::size_t>(each.row)] = static_cast<Eigen::Index>(matrix.labels.size());
        matrix.labels.push_back(each.label);
    }
    keep_rows(matrix, place, static_cast<Eigen::Index>(all.size()));
}

SparseMatrix symmetric_matrix(const ListedMatrix& matrix) {
    const SparseMatrix listed = listed_entries(matrix);
    const SparseMatrix mirrored = listed.transpose();
    const bool is_both = matrix.triangles == Triangles::both || has_mirrored_pair(listed, mirrored);
    if (is_both && matrix.triangles == Triangles::one)
        throw refusal(matrix.file, shown(matrix) + " holds entries on both sides of the diagonal",
                      "it says that it holds one triangle");
    if (!is_both) {
        SparseMatrix whole = listed + mirrored;
        for (Eigen::Index row = 0; row < whole.rows(); ++row)
            if (listed.coeff(row, row) != 0.0) whole.coeffRef(row, row) = listed.coeff(row, row);
        return whole;
    }
    expect_mirrored(matrix, listed);
    return 0.5 * listed + 0.5 * mirrored;  // halves first: a sum may leave double precision
}

reduction::ElasticPart joined_part(ListedMatrix stiffness, const ListedMatrix& mass, const ListedMatrix* damping) {
    reduction::ElasticPart part;
    std::set<RowLabel> dropped;
    const Eigen::Index held = drop_held_rows(stiffness, dropped);
    if (held > 0) part.notes.push_back(penalty_note(held));
    part.stiffness = symmetric_matrix(stiffness);
    part.mass = symmetric_matrix(ordered(mass, stiffness, dropped));
    if (damping != nullptr) part.damping = symmetric_matrix(ordered(*damping, stiffness, dropped));
    part.labels = stiffness.labels;
    return part;
}

}  // namespace stridor::io::structure
