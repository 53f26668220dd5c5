#pragma once

#include "stridor/analysis/stability_scan.hpp"
#include "stridor/io/structure/part_files.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// Modes of steady sliding as files of VTK, which ParaView and others open: XML, of version 0.1, in ASCII.
namespace stridor::io {

/// The content of a file of modes, by its ending.
enum class ModeFiles {
    none,   // no file of VTK
    still,  // .vtu: real and imaginary part of each mode
    cycle,  // .pvd: a cycle of each mode, step by step, in .vtu files beside it
};

/// Returns the kind of a file by its name.
ModeFiles mode_files_of(std::string_view file);

/// An element by its points, in VTK's order.
struct MeshElement {
    int cell = 0;                     // [1] VTK's number of its shape
    std::vector<std::size_t> points;  // numbers of nodes of the mesh
};

/// Nodes of a part, their motion by its rows, and the elements between them.
struct NodeMesh {
    std::vector<std::string> nodes;          // as the part has them
    std::vector<Eigen::Vector3d> positions;  // [m] shape [node]
    std::vector<Eigen::Matrix3Xd> motions;   // [1] displacement = motion * rows, shape [node]; without columns: held
    std::vector<MeshElement> elements;       // empty: points alone
    std::size_t left_out = 0;                // elements of the deck with a node whose motion is unknown
};

/// Returns the nodes of a part whose places and motions are known. With a deck (`deck` not empty) it adds the solid and
/// shell elements between them, and the nodes that the deck holds (*BOUNDARY), which do not move.
///
/// Throws `Error` (input) for a part without places, and for a deck without a node in common with it.
NodeMesh node_mesh(const NamedPart& part, const std::string& deck);

/// Vectors at each point of an unstructured grid, by name; shape [node].
using PointVectors = std::vector<std::pair<std::string, std::vector<Eigen::Vector3d>>>;

/// Returns the text of a .vtu file.
std::string vtu_text(const NodeMesh& mesh, const PointVectors& vectors);

/// Writes the modes of a scan (`analysis::with_modes`): FILE.vtu, or FILE.pvd and a folder FILE with its 24 steps. The
/// largest displacement of a mode is 1, in a cycle a tenth of the part's extent. Throws `Error` (io).
void write_modes(const std::string& file, ModeFiles kind, const NodeMesh& mesh, const analysis::StabilityScan& scan);

}  // namespace stridor::io
