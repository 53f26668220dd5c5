#include "stridor/reduction/part.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/reduction/sparse_factor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <set>
#include <span>

namespace stridor::reduction {

namespace {

constexpr double symmetry_tolerance = 1e-10;  // [1] of the diagonal: files have 14 to 16 digits

[[noreturn]] void refuse_part(const std::string& what, const std::string& why, const std::string& suggestion = "") {
    base::refuse(what, why, suggestion);
}

void expect_labels(const ElasticPart& part) {
    if (static_cast<Eigen::Index>(part.labels.size()) != part.stiffness.rows())
        refuse_part(fmt::format("there are {} labels for {} rows", part.labels.size(), part.stiffness.rows()),
                    "each row of the matrices needs its node and component",
                    "Take labels and matrices of the same run?");
    std::set<RowLabel> seen;
    for (std::size_t row = 0; row < part.labels.size(); ++row) {
        const RowLabel& label = part.labels[row];
        if (label.node.empty() || label.component < 0 || label.component > 6)
            refuse_part(fmt::format("row {} has no label", row + 1), "a contact is placed by node and component");
        if (!seen.insert(label).second)
            refuse_part(fmt::format("the label {} stands for two rows", describe(label)),
                        "a label says which degree of freedom a row is",
                        "Are elements expanded (beams and shells of CalculiX)? Use solids, masses and springs.");
    }
}

void expect_symmetric(const ElasticPart& part, const SparseMatrix& matrix, const std::string& name) {
    if (matrix.rows() != matrix.cols())
        refuse_part(fmt::format("the {} has {} rows and {} columns", name, matrix.rows(), matrix.cols()),
                    "the matrices of a structure are square");
    const Eigen::VectorXd diagonal = matrix.diagonal().cwiseAbs();
    const SparseMatrix mirrored = matrix.transpose();
    for (Eigen::Index column = 0; column < matrix.outerSize(); ++column) {
        SparseMatrix::InnerIterator other(mirrored, column);
        for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry) {
            const auto place = [&] {
                return describe(part.labels[static_cast<std::size_t>(entry.row())]) + ", " +
                       describe(part.labels[static_cast<std::size_t>(column)]);
            };
            if (!std::isfinite(entry.value()))
                refuse_part(fmt::format("the {} holds {} at {}", name, entry.value(), place()), "it is no number");
            while (other && other.row() < entry.row())
                ++other;
            const double across = other && other.row() == entry.row() ? other.value() : 0.0;
            // roots first: the product of two large numbers is none
            const double scale =
                std::sqrt(diagonal[entry.row()]) * std::sqrt(diagonal[column]) + std::abs(entry.value());
            if (std::abs(entry.value() - across) > symmetry_tolerance * scale)
                refuse_part(fmt::format("the {} is not symmetric", name),
                            fmt::format("at {} it holds {}, across the diagonal {}", place(),
                                        base::shortest(entry.value()), base::shortest(across)),
                            "Leave out what makes it so: friction, follower loads, rotating frames.");
        }
    }
}

// a motion of negative kinetic energy would make an impact gain energy
void expect_positive_mass(const ElasticPart& part, LinearSolver by) {
    const Eigen::VectorXd diagonal = part.mass.diagonal();
    Eigen::VectorXd scale(diagonal.size());
    for (Eigen::Index row = 0; row < diagonal.size(); ++row) {
        const std::string label = describe(part.labels[static_cast<std::size_t>(row)]);
        const bool is_empty = part.mass.col(row).cwiseAbs().sum() == 0.0;
        if (diagonal[row] < 0.0 || (diagonal[row] == 0.0 && !is_empty))
            refuse_part("the mass is negative for some motion",
                        fmt::format("row {} has {} on its diagonal", label, base::shortest(diagonal[row])));
        if (is_empty && part.stiffness.col(row).cwiseAbs().sum() == 0.0)
            refuse_part(fmt::format("row {} has neither stiffness nor mass", label), "its motion would be arbitrary");
        scale[row] = diagonal[row] > 0.0 ? 1.0 / std::sqrt(diagonal[row]) : 1.0;
    }
    // with a unit diagonal rotations weigh as much as displacements; rows without mass are zero rows
    const SparseMatrix rows = scale.asDiagonal() * without_zeros(part.mass);
    const SparseMatrix scaled = rows * scale.asDiagonal();
    SparseMatrix unit(scaled.rows(), scaled.cols());
    unit.setIdentity();
    const SparseFactor factor(scaled, unit, -symmetry_tolerance, by, FactorUse::counting);
    if (!factor.is_whole() || factor.negative_pivots() > 0)
        refuse_part("the mass is negative for some motion",
                    fmt::format("{} of its pivots are negative", factor.negative_pivots()),
                    "Is it a mass matrix, whole, and of these rows?");
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower;
}

// the digits of "FOOT:13"; all six where none are named
std::string components_of(std::string_view name, std::string_view digits) {
    if (digits.empty() || digits.find_first_not_of("123456") != std::string_view::npos)
        refuse_part(fmt::format("\"{}\" names no components", name),
                    "behind the colon stand digits from 1 to 6: x, y, z and the rotations about them",
                    "FOOT:3 is the component 3 of each node of FOOT.");
    return std::string(digits);
}

class RowFinder {
public:
    explicit RowFinder(const ElasticPart& part) : part_(part) {
        for (std::size_t row = 0; row < part.labels.size(); ++row)
            rows_[part.labels[row]] = static_cast<Eigen::Index>(row);
    }

    bool has_node(const std::string& node) const {
        const auto found = rows_.lower_bound({node, 0});
        return found != rows_.end() && found->first.node == node;
    }

    /// Rows of a node: all it has, or those asked for.
    void add(const std::string& node, const std::string& components, std::vector<Eigen::Index>& rows) const {
        if (!has_node(node))
            refuse_part(fmt::format("node {} has no row", node),
                        part_.positions.contains(node) ? "a support, a constraint or a rigid body removed all of them"
                                                       : "the model does not have it");
        if (components.empty()) {
            for (auto found = rows_.lower_bound({node, 0}); found != rows_.end() && found->first.node == node; ++found)
                rows.push_back(found->second);
            return;
        }
        for (const char digit : components) {
            const auto found = rows_.find({node, digit - '0'});
            if (found == rows_.end())
                refuse_part(fmt::format("node {} has no row for component {}", node, digit),
                            "a support, an equation, a transformed system or a rigid body removed it",
                            "Hold the nodes of a contact by nothing else.");
            rows.push_back(found->second);
        }
    }

private:
    const ElasticPart& part_;
    std::map<RowLabel, Eigen::Index> rows_;
};

bool has_entry(const SparseMatrix& matrix) {
    for (Eigen::Index outer = 0; outer < matrix.outerSize(); ++outer)
        for (SparseMatrix::InnerIterator entry(matrix, outer); entry; ++entry)
            if (entry.value() != 0.0) return true;
    return false;
}

}  // namespace

std::string describe(const RowLabel& label) {
    return label.component == 0 ? label.node : label.node + "." + std::to_string(label.component);
}

Eigen::Index rows_of(const ElasticPart& part) {
    return part.stiffness.rows();
}

SparseMatrix without_zeros(const SparseMatrix& matrix) {
    SparseMatrix left = matrix;
    left.prune([](Eigen::Index, Eigen::Index, double value) { return value != 0.0; });
    return left;
}

void expect_sound(const ElasticPart& part, LinearSolver by) {
    if (rows_of(part) == 0) refuse_part("the part has no row", "there is nothing that could move");
    expect_labels(part);
    if (part.mass.rows() != part.stiffness.rows())
        refuse_part(fmt::format("the stiffness has {} rows, the mass {}", part.stiffness.rows(), part.mass.rows()),
                    "both must be of the same model");
    if (part.damping.rows() != 0 && part.damping.rows() != part.stiffness.rows())
        refuse_part(
            fmt::format("the stiffness has {} rows, the damping {}", part.stiffness.rows(), part.damping.rows()),
            "both must be of the same model");
    expect_symmetric(part, part.stiffness, "stiffness");
    expect_symmetric(part, part.mass, "mass");
    if (!has_entry(part.mass))
        refuse_part("the part has no mass", "all entries of its mass are 0", "Is the density missing?");
    if (part.damping.rows() != 0) expect_symmetric(part, part.damping, "damping");
    expect_positive_mass(part, by);
}

void expect_stiff(const ElasticPart& part, double least) {
    double largest = 0.0;
    for (const double each : std::span(part.stiffness.valuePtr(), static_cast<std::size_t>(part.stiffness.nonZeros())))
        largest = std::max(largest, std::abs(each));
    if (!(largest > least))
        refuse_part("the part has no stiffness", fmt::format("its largest entry is {}", base::shortest(largest)),
                    "Is it the stiffness matrix?");
}

const std::vector<UnitSystem>& unit_systems() {
    static const std::vector<UnitSystem> systems{{"m-kg-s", 1.0, 1.0, 1.0},
                                                 {"mm-t-s", 1e-3, 1e3, 1.0},
                                                 {"mm-kg-ms", 1e-3, 1.0, 1e-3},
                                                 {"mm-kg-s", 1e-3, 1.0, 1.0},
                                                 {"cm-g-s", 1e-2, 1e-3, 1.0}};
    return systems;
}

const UnitSystem& unit_system(std::string_view name) {
    std::string names;
    for (const UnitSystem& system : unit_systems()) {
        if (system.name == name) return system;
        names += (names.empty() ? "" : ", ") + std::string(system.name);
    }
    refuse_part(fmt::format("\"{}\" is no system of units", name), "there are " + names);
}

// energies scale with e = mass length^2 / time^2, displacements with the length: K' = e K / (s s'), M' likewise with
// the time
ElasticPart in_si(ElasticPart part, const UnitSystem& from) {
    if (from.length == 1.0 && from.mass == 1.0 && from.time == 1.0) return part;
    Eigen::VectorXd inverse(rows_of(part));
    for (Eigen::Index row = 0; row < inverse.size(); ++row) {
        const int component = part.labels[static_cast<std::size_t>(row)].component;
        inverse[row] = component >= 1 && component <= 3 ? 1.0 / from.length : 1.0;
    }
    const double inertia = from.mass * from.length * from.length;
    const auto scaled = [&](const SparseMatrix& matrix, double factor) {
        const SparseMatrix rows = inverse.asDiagonal() * matrix;
        const SparseMatrix both = rows * inverse.asDiagonal();
        return SparseMatrix(factor * both);
    };
    part.stiffness = scaled(part.stiffness, inertia / (from.time * from.time));
    part.mass = scaled(part.mass, inertia);
    if (part.damping.rows() != 0) part.damping = scaled(part.damping, inertia / from.time);
    for (auto& [node, position] : part.positions)
        position *= from.length;
    return part;
}

const NodeSet* find_set(const ElasticPart& part, std::string_view name) {
    const std::string wanted = lower_case(name);
    for (const NodeSet& set : part.sets)
        if (lower_case(set.name) == wanted) return &set;
    return nullptr;
}

std::string set_names(const ElasticPart& part) {
    constexpr std::size_t most_told = 30;
    std::string names;
    for (std::size_t k = 0; k < std::min(part.sets.size(), most_told); ++k)
        names += (k > 0 ? ", " : "") + part.sets[k].name;
    if (part.sets.size() > most_told) names += fmt::format(" and {} more", part.sets.size() - most_told);
    return names;
}

std::vector<Eigen::Index> named_rows(const ElasticPart& part, std::string_view name) {
    const std::size_t colon = name.find(':');
    const std::string plain(name.substr(0, colon));
    const std::string components =
        colon == std::string_view::npos ? std::string() : components_of(name, name.substr(colon + 1));
    const RowFinder finder(part);
    std::vector<Eigen::Index> rows;
    if (const NodeSet* set = find_set(part, plain)) {
        for (const std::string& node : set->nodes)
            finder.add(node, components, rows);
        return rows;
    }
    const std::size_t dot = plain.rfind('.');
    if (!finder.has_node(plain) && dot != std::string::npos && finder.has_node(plain.substr(0, dot))) {
        finder.add(plain.substr(0, dot), components_of(name, std::string_view(plain).substr(dot + 1)), rows);
        return rows;
    }
    if (!finder.has_node(plain) && !part.positions.contains(plain)) {
        const std::string sets = set_names(part);
        refuse_part(fmt::format("\"{}\" is no set, node or row of the part", plain),
                    sets.empty() ? "it has no node sets" : "its node sets are " + sets);
    }
    finder.add(plain, components, rows);
    return rows;
}

std::vector<Eigen::Index> named_rows(const ElasticPart& part, const std::vector<std::string>& names) {
    std::vector<Eigen::Index> rows;
    std::vector<bool> is_named(static_cast<std::size_t>(rows_of(part)));
    for (const std::string& name : names)
        for (const Eigen::Index row : named_rows(part, std::string_view(name))) {
            if (!is_named[static_cast<std::size_t>(row)]) rows.push_back(row);
            is_named[static_cast<std::size_t>(row)] = true;
        }
    return rows;
}

}  // namespace stridor::reduction
