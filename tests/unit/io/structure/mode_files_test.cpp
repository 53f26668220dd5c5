// Files of modes, read back by the published format: VTK User's Guide, "VTK XML formats", UnstructuredGrid (.vtu) and
// Collection (.pvd), with cell types of vtkCellType.h.

#include "stridor/io/structure/mode_files.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/io/structure/calculix.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "structure_texts.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <regex>
#include <sstream>

namespace stridor::io {
namespace {

using structure::block_folder;
using structure::block_part;

// what stands in the DataArray of a name; of the points it has none
std::vector<double> numbers_of(const std::string& text, const std::string& name) {
    const std::size_t from = name.empty() ? text.find("<Points>") : text.find("Name=\"" + name + "\"");
    if (from == std::string::npos) return {};
    const std::size_t begin = text.find('>', name.empty() ? text.find("<DataArray", from) : from) + 1;
    std::istringstream words(text.substr(begin, text.find("</DataArray>", begin) - begin));
    return {std::istream_iterator<double>(words), {}};
}

std::size_t count_in(const std::string& text, const std::string& attribute) {
    std::smatch found;
    return std::regex_search(text, found, std::regex(attribute + "=\"([0-9]+)\"")) ? std::stoul(found[1]) : 0;
}

NamedPart block() {
    return {block_part(), "block.sti", {}, {}, 0.0};
}

// one mode that grows, of the block on its foot: each row turns ahead of the one before
analysis::StabilityScan scan_of(Eigen::Index rows) {
    analysis::SlidingMode mode;
    mode.eigenvalue = {3.0, 592.0 * base::two_pi};
    mode.shape.resize(rows);
    for (Eigen::Index row = 0; row < rows; ++row)
        mode.shape(row) = std::polar(1.0 + 0.01 * static_cast<double>(row), 0.1 * static_cast<double>(row));
    analysis::StabilityScan scan;
    analysis::DirectionScan& going = scan.directions.emplace_back();
    going.modes = analysis::SlidingModes{{}, {mode}};
    return scan;
}

TEST(ModeFiles, HoldTheMeshOfTheDeck) {
    const NodeMesh mesh = node_mesh(block(), block_folder + "block.inp");
    EXPECT_EQ(mesh.left_out, 0U);
    const std::string text = vtu_text(mesh, {});
    const std::size_t points = count_in(text, "NumberOfPoints"), cells = count_in(text, "NumberOfCells");
    EXPECT_EQ(points, 60U) << "48 with rows, and the 12 that the deck holds";
    EXPECT_EQ(cells, 24U);
    EXPECT_EQ(numbers_of(text, "").size(), 3 * points);
    const std::vector<double> types = numbers_of(text, "types"), offsets = numbers_of(text, "offsets");
    EXPECT_EQ(types, std::vector<double>(cells, 12.0)) << "VTK_HEXAHEDRON";
    ASSERT_EQ(offsets.size(), cells);
    EXPECT_EQ(offsets.front(), 8.0);
    const std::vector<double> connectivity = numbers_of(text, "connectivity");
    ASSERT_EQ(static_cast<double>(connectivity.size()), offsets.back());
    // the first element of the deck, node by node, where the deck has them
    const std::vector<double> places = numbers_of(text, "");
    const std::vector<std::string> nodes{"1000", "1001", "1005", "1004", "1012", "1013", "1017", "1016"};
    for (std::size_t k = 0; k < nodes.size(); ++k)
        for (std::size_t axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(places[3 * static_cast<std::size_t>(connectivity[k]) + axis],
                        block_part().positions.at(nodes[k])[static_cast<Eigen::Index>(axis)], 1e-15);
}

TEST(ModeFiles, WithoutADeckShowPoints) {
    const std::string text = vtu_text(node_mesh(block(), ""), {});
    EXPECT_EQ(count_in(text, "NumberOfPoints"), 48U);
    EXPECT_EQ(numbers_of(text, "types"), std::vector<double>(48, 1.0)) << "VTK_VERTEX";
}

TEST(ModeFiles, OfAReducedPartLeaveOutWhatWasNotKept) {
    NamedPart kept = block();
    // its coordinates are one mode alone, which moves node 1000
    kept.part.labels = {{"mode 1", 0}};
    kept.recovered = {{"1000", 1}, {"1000", 3}};
    kept.recovery = Eigen::MatrixXd{{2.0}, {-1.0}};
    const NodeMesh mesh = node_mesh(kept, block_folder + "block.inp");
    EXPECT_EQ(mesh.elements.size() + mesh.left_out, 24U);
    EXPECT_EQ(mesh.elements.size(), 0U);
    const auto place = std::find(mesh.nodes.begin(), mesh.nodes.end(), "1000") - mesh.nodes.begin();
    EXPECT_EQ(mesh.motions[static_cast<std::size_t>(place)], (Eigen::Matrix3Xd(Eigen::Vector3d(2.0, 0.0, -1.0))));
}

TEST(ModeFiles, HoldRealAndImaginaryPartOfTheLargestAsOne) {
    const support::ScratchFolder folder;
    const std::string file = (folder.path() / "modes.vtu").string();
    const NodeMesh mesh = node_mesh(block(), block_folder + "block.inp");
    write_modes(file, ModeFiles::still, mesh, scan_of(144));
    const std::string text = storage::read_file(file);
    const std::vector<double> real = numbers_of(text, "going_1_592_Hz_real");
    const std::vector<double> imaginary = numbers_of(text, "going_1_592_Hz_imaginary");
    ASSERT_EQ(real.size(), 180U);
    double largest = 0.0;
    for (std::size_t k = 0; k < 60; ++k) {
        double square = 0.0;
        for (std::size_t axis = 0; axis < 3; ++axis)
            square += std::norm(std::complex(real[3 * k + axis], imaginary[3 * k + axis]));
        largest = std::max(largest, square);
        if (mesh.motions[k].cols() == 0) {
            EXPECT_EQ(square, 0.0) << "held: " << mesh.nodes[k];
        }
    }
    EXPECT_NEAR(largest, 1.0, 1e-12);
    // row 0 is node 1000 along x, of phase 0; row 1 along y, a tenth of a radian ahead
    const auto place =
        static_cast<std::size_t>(std::find(mesh.nodes.begin(), mesh.nodes.end(), "1000") - mesh.nodes.begin());
    EXPECT_NEAR(imaginary[3 * place], 0.0, 1e-15);
    EXPECT_NEAR(std::atan2(imaginary[3 * place + 1], real[3 * place + 1]), 0.1, 1e-12);
}

TEST(ModeFiles, ACycleReturnsToItsBeginning) {
    const support::ScratchFolder folder;
    const NodeMesh mesh = node_mesh(block(), "");
    write_modes((folder.path() / "modes.pvd").string(), ModeFiles::cycle, mesh, scan_of(144));
    const std::string list = storage::read_file((folder.path() / "modes.pvd").string());
    EXPECT_NE(list.find("<VTKFile type=\"Collection\""), std::string::npos);
    const std::regex step("<DataSet timestep=\"([0-9.]+)\" part=\"0\" file=\"(modes/[0-9]+.vtu)\"/>");
    std::vector<std::vector<double>> frames;
    for (std::sregex_iterator found(list.begin(), list.end(), step), end; found != end; ++found) {
        EXPECT_NEAR(std::stod((*found)[1]), static_cast<double>(frames.size()) / 24.0, 1e-12);
        frames.push_back(
            numbers_of(storage::read_file((folder.path() / (*found)[2].str()).string()), "going_1_592_Hz"));
    }
    ASSERT_EQ(frames.size(), 24U);
    double largest = 0.0;
    for (std::size_t k = 0; k < frames[0].size(); ++k) {
        EXPECT_NEAR(frames[12][k], -frames[0][k], 1e-15) << "half a cycle later";
        largest = std::max(largest, std::abs(frames[0][k]));
    }
    EXPECT_GT(largest, 0.01 * 0.02);
    EXPECT_LT(largest, 0.11 * 0.02) << "[m] a tenth of the part's extent";
}

TEST(ModeFiles, OfAStructureWithoutPlacesAreRefused) {
    NamedPart nowhere = block();
    nowhere.part.positions.clear();
    EXPECT_THROW(node_mesh(nowhere, ""), Error);
}

TEST(CalculixDeck, ReadsElementsThatGoOnInTheNextLine) {
    const std::string text =
        "*ELEMENT, TYPE=C3D10\n7, 1, 2, 3, 4, 5,\n6, 7, 8, 9, 10\n8, 11,12,13,14,15,16,17,18,19,20\n"
        "*NSET, NSET=TOP\n3\n*BOUNDARY\nTOP, 1, 3\n5, 1, 1\n";
    const structure::CalculixDeck deck = structure::read_calculix_deck({recordings::bytes_of(text), "a.inp"}, nullptr);
    ASSERT_EQ(deck.elements.size(), 2U);
    EXPECT_EQ(deck.elements[0].type, "C3D10");
    EXPECT_EQ(deck.elements[0].nodes.back(), "10");
    EXPECT_EQ(deck.elements[1].nodes.size(), 10U);
    EXPECT_EQ(deck.held, (std::set<std::string>{"3", "5"}));
}

}  // namespace
}  // namespace stridor::io
