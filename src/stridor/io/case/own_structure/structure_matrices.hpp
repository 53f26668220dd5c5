#pragma once

#include "stridor/io/case/own_structure/toml_section.hpp"
#include "stridor/io/structure/field_scanner.hpp"
#include "stridor/reduction/part.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace stridor::io {

/// A part with what it is made from.
struct NamedPart {
    reduction::ElasticPart part;  // checked (`reduction::expect_sound`), in SI
    std::string origin;
    std::vector<reduction::RowLabel> recovered{};  // further rows of a reduced part, and their motion
    Eigen::MatrixXd recovery{};                    // [1] shape [recovered][row]
    double left_out_above = 0.0;                   // [Hz] of a boundary without mass; 0: no modes were
};

/// The matrices of [structure] with the labels of their rows: in the file itself (`mass = [[...]]`, `rows`), as CSV or
/// Matrix Market (`mass = "m.mtx"`, `labels`), or a part of a finite-element program, reduced or not (`file`, `units`).
///
/// Throws `Error` (input) for what does not fit or is no structure.
NamedPart part_in(const TomlSection& section);

/// A file that an entry names. Throws `Error` (io) with its place where it cannot be opened.
structure::StructureInput opened(const std::string& path, const TomlEntry& entry);

}  // namespace stridor::io
