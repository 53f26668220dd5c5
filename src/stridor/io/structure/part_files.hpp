#pragma once

#include "stridor/io/structure/listed_matrix.hpp"
#include "stridor/reduction/part.hpp"

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace stridor::io {

/// The files that a user names.
struct PartFiles {
    std::vector<std::string> files{};  // their kind is told by their bytes, or for CalculiX by their endings
    std::string stiffness{};           // a matrix that does not name its role, FILE or FILE:NAME; empty: none
    std::string mass{};
    std::string damping{};
    std::string labels{};  // labels of rows: a table, or Ansys' mapping
};

/// Returns their names in a row, separated by commas.
std::string origin(const PartFiles& files);

/// A part with what it is made from.
struct NamedPart {
    reduction::ElasticPart part;  // checked (`reduction::expect_sound`), in SI
    std::string origin;
    std::vector<reduction::RowLabel> recovered{};  // further rows of a reduced part, and their motion
    Eigen::MatrixXd recovery{};                    // [1] shape [recovered][row]
    double left_out_above = 0.0;                   // [Hz] of a boundary without mass; 0: no modes were
};

/// Opens a file; returns `std::nullopt` if it does not exist.
using FileOpener = std::function<std::optional<structure::StructureInput>(const std::string& path)>;

/// Reads a part from the files of a finite-element program: CalculiX (.sti, .mas, .dof and the deck .inp; naming one is
/// enough), Matrix Market, Abaqus, Nastran (.pch, .op4), Ansys (Harwell-Boeing and mapping), NumPy (.npz, .npy), in the
/// units of the files.
///
/// Throws `Error` (input) for a file that no reader knows, for a stiffness or mass that is missing or comes twice, for
/// labels that do not fit, and for all that the readers refuse; `Error` (io) for a file that cannot be read. The
/// returned part is not yet checked (`reduction::expect_sound`).
reduction::ElasticPart read_part(const PartFiles& files, const FileOpener& open);

/// Reads a part from plain files on the disk. Throws `Error` (input) for files that are not a part, (io) if they cannot
/// be read.
reduction::ElasticPart read_part(const PartFiles& files);

}  // namespace stridor::io
