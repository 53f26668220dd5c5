#include "stridor/io/structure/mode_files.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/io/structure/calculix.hpp"
#include "stridor/recordings/bytes.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>

namespace stridor::io {

namespace {

using Eigen::Index;
using Eigen::Vector3d;

constexpr int steps = 24;                // of a cycle
constexpr double share_of_extent = 0.1;  // [1] that the largest displacement of a cycle takes

// VTK's number of the shape of an element. Its nodes stand in the same order in both.
struct Shape {
    std::string_view type;  // as it begins
    int cell;
};
constexpr std::array<Shape, 10> shapes{{{"C3D20", 25},
                                        {"C3D15", 26},
                                        {"C3D10", 24},
                                        {"C3D8", 12},
                                        {"C3D6", 13},
                                        {"C3D4", 10},
                                        {"S8", 23},
                                        {"S6", 22},
                                        {"S4", 9},
                                        {"S3", 5}}};

int cell_of(std::string_view type) {
    const auto* found =
        std::find_if(shapes.begin(), shapes.end(), [&](const Shape& shape) { return type.starts_with(shape.type); });
    return found == shapes.end() ? 0 : found->cell;
}

structure::CalculixDeck opened_deck(const std::string& deck) {
    const auto open = [](const std::string& path) {
        return structure::StructureInput{recordings::open_plain_bytes(path), path};
    };
    return read_calculix_deck(open(deck), [&](const std::string& name, const std::string& from) {
        return std::optional(open((std::filesystem::path(from).parent_path() / name).string()));
    });
}

void add_node(NodeMesh& mesh, const std::string& node, const Vector3d& position, Eigen::Matrix3Xd motion) {
    mesh.nodes.push_back(node);
    mesh.positions.push_back(position);
    mesh.motions.push_back(std::move(motion));
}

// the deck may be in other units of length: the same nodes lie as much farther apart
double scale_of(const structure::CalculixDeck& deck, const NodeMesh& mesh) {
    double here = 0.0, there = 0.0;
    bool has_one = false;
    for (std::size_t k = 0; k < mesh.nodes.size(); ++k)
        if (const auto found = deck.positions.find(mesh.nodes[k]); found != deck.positions.end()) {
            here += mesh.positions[k].norm();
            there += found->second.norm();
            has_one = true;
        }
    if (!has_one)
        base::refuse("the deck has no node of the part", "elements belong to the nodes that the part was made of",
                     "Name the deck of this part.");
    return there > 0.0 ? here / there : 1.0;
}

void add_elements(NodeMesh& mesh, const structure::CalculixDeck& deck) {
    const double scale = scale_of(deck, mesh);
    std::map<std::string, std::size_t> places;
    for (std::size_t k = 0; k < mesh.nodes.size(); ++k)
        places[mesh.nodes[k]] = k;
    for (const std::string& node : deck.held)
        if (const auto found = deck.positions.find(node); found != deck.positions.end() && !places.contains(node)) {
            places[node] = mesh.nodes.size();
            add_node(mesh, node, scale * found->second, {});
        }
    for (const structure::DeckElement& element : deck.elements) {
        MeshElement cell{cell_of(element.type), {}};
        if (cell.cell == 0) continue;  // a spring, a mass
        for (const std::string& node : element.nodes)
            if (const auto found = places.find(node); found != places.end()) cell.points.push_back(found->second);
        if (cell.points.size() == element.nodes.size())
            mesh.elements.push_back(std::move(cell));
        else
            ++mesh.left_out;
    }
}

double extent_of(const NodeMesh& mesh) {
    Vector3d low = mesh.positions.front(), high = low;
    for (const Vector3d& position : mesh.positions) {
        low = low.cwiseMin(position);
        high = high.cwiseMax(position);
    }
    return (high - low).maxCoeff();
}

// one mode at all nodes, its largest displacement over a cycle 1
struct NodeMotion {
    std::string name;  // "going_1_592_Hz"
    std::vector<Eigen::Vector3cd> motion;

    std::vector<Vector3d> at(double phase, double size) const {
        std::vector<Vector3d> displacement;
        for (const Eigen::Vector3cd& each : motion)
            displacement.emplace_back(size * (each * std::polar(1.0, phase)).real());
        return displacement;
    }
};

std::vector<NodeMotion> motions_of(const NodeMesh& mesh, const analysis::StabilityScan& scan) {
    std::vector<NodeMotion> motions;
    for (const analysis::DirectionScan& direction : scan.directions)
        for (std::size_t m = 0; direction.modes && m < direction.modes->modes.size(); ++m) {
            const analysis::SlidingMode& mode = direction.modes->modes[m];
            NodeMotion motion{fmt::format("{}_{}_{:.0f}_Hz",
                                          parameters::direction_names[static_cast<std::size_t>(direction.direction)],
                                          m + 1, mode.eigenvalue.imag() / base::two_pi),
                              {}};
            double largest = 0.0;
            for (const Eigen::Matrix3Xd& follows : mesh.motions) {
                motion.motion.emplace_back(follows.cols() == 0 ? Eigen::Vector3cd::Zero().eval()
                                                               : (follows * mode.shape).eval());
                largest = std::max(largest, motion.motion.back().norm());
            }
            if (largest > 0.0)
                for (Eigen::Vector3cd& each : motion.motion)
                    each /= largest;
            motions.push_back(std::move(motion));
        }
    if (motions.empty())
        base::refuse("this case has no modes of steady sliding",
                     "it locks both ways, or its closed contacts leave no motion free", "");
    return motions;
}

std::string vectors_text(const std::string& head, const std::vector<Vector3d>& vectors) {
    std::string text = "<DataArray type=\"Float64\" " + head + "NumberOfComponents=\"3\" format=\"ascii\">\n";
    for (const Vector3d& each : vectors)
        text += fmt::format("{} {} {}\n", each.x(), each.y(), each.z());
    return text + "</DataArray>\n";
}

std::string numbers_text(const char* type, const char* name, const std::vector<std::size_t>& numbers) {
    return fmt::format("<DataArray type=\"{}\" Name=\"{}\" format=\"ascii\">\n{}\n</DataArray>\n", type, name,
                       fmt::join(numbers, " "));
}

}  // namespace

ModeFiles mode_files_of(std::string_view file) {
    return file.ends_with(".vtu") ? ModeFiles::still : file.ends_with(".pvd") ? ModeFiles::cycle : ModeFiles::none;
}

NodeMesh node_mesh(const NamedPart& part, const std::string& deck) {
    std::vector<reduction::RowLabel> labels = part.part.labels;
    const auto rows = static_cast<Index>(labels.size());
    labels.insert(labels.end(), part.recovered.begin(), part.recovered.end());
    std::map<std::string, Eigen::Matrix3Xd> motions;
    for (Index k = 0; k < static_cast<Index>(labels.size()); ++k) {
        const reduction::RowLabel& label = labels[static_cast<std::size_t>(k)];
        if (label.component < 1 || label.component > 3 || !part.part.positions.contains(label.node)) continue;
        const auto motion = motions.try_emplace(label.node, Eigen::Matrix3Xd::Zero(3, rows)).first;
        if (k < rows)
            motion->second(label.component - 1, k) = 1.0;
        else
            motion->second.row(label.component - 1) = part.recovery.row(k - rows);
    }
    if (motions.empty())
        base::refuse("it is not known where the nodes of this structure are",
                     "a file of modes shows them at their places",
                     "Take a finite-element part whose files tell the places of its nodes.");
    NodeMesh mesh;
    for (auto& [node, motion] : motions)
        add_node(mesh, node, part.part.positions.at(node), std::move(motion));
    if (!deck.empty()) add_elements(mesh, opened_deck(deck));
    return mesh;
}

std::string vtu_text(const NodeMesh& mesh, const PointVectors& vectors) {
    std::vector<MeshElement> cells = mesh.elements;
    // points that belong to no element are drawn as such
    for (std::size_t k = 0; mesh.elements.empty() && k < mesh.nodes.size(); ++k)
        cells.push_back({1, {k}});
    std::vector<std::size_t> connectivity, offsets, types;
    for (const MeshElement& cell : cells) {
        connectivity.insert(connectivity.end(), cell.points.begin(), cell.points.end());
        offsets.push_back(connectivity.size());
        types.push_back(static_cast<std::size_t>(cell.cell));
    }
    std::string text = fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
        "<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<PointData>\n",
        mesh.nodes.size(), cells.size());
    for (const auto& [name, values] : vectors)
        text += vectors_text("Name=\"" + name + "\" ", values);
    return text + "</PointData>\n<Points>\n" + vectors_text("", mesh.positions) + "</Points>\n<Cells>\n" +
           numbers_text("Int64", "connectivity", connectivity) + numbers_text("Int64", "offsets", offsets) +
           numbers_text("UInt8", "types", types) + "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

void write_modes(const std::string& file, ModeFiles kind, const NodeMesh& mesh, const analysis::StabilityScan& scan) {
    const std::vector<NodeMotion> motions = motions_of(mesh, scan);
    PointVectors vectors;
    if (kind == ModeFiles::still) {
        for (const NodeMotion& motion : motions) {
            vectors.emplace_back(motion.name + "_real", motion.at(0.0, 1.0));
            vectors.emplace_back(motion.name + "_imaginary", motion.at(-0.25 * base::two_pi, 1.0));
        }
        return storage::write_file(file, vtu_text(mesh, vectors));
    }
    const std::filesystem::path folder = std::filesystem::path(file).replace_extension();
    storage::make_folder(folder, "Choose another --output.");
    const double size = share_of_extent * extent_of(mesh);
    std::string list;
    for (int step = 0; step < steps; ++step) {
        const double share = static_cast<double>(step) / steps;
        vectors.clear();
        for (const NodeMotion& motion : motions)
            vectors.emplace_back(motion.name, motion.at(share * base::two_pi, size));
        const std::string name = fmt::format("{:02}.vtu", step);
        storage::write_file((folder / name).string(), vtu_text(mesh, vectors));
        list += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}/{}\"/>\n", share, folder.filename().string(),
                            name);
    }
    storage::write_file(file,
                        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
                        "byte_order=\"LittleEndian\">\n<Collection>\n" +
                            list + "</Collection>\n</VTKFile>\n");
}

}  // namespace stridor::io
