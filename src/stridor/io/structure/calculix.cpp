#include "stridor/io/structure/calculix.hpp"

#include "stridor/io/structure/calculix_deck.hpp"
#include "stridor/recordings/refusal.hpp"

#include <fmt/format.h>

#include <set>
#include <utility>

namespace stridor::io::structure {

namespace {

using recordings::LineReader;
using recordings::refusal;
using reduction::RowLabel;

RowLabel label_in(const recordings::TextLine& line, const std::string& file) {
    FieldScanner scanner(line, file);
    const std::string_view word = scanner.word();
    // as text: as numbers 1000.1 and 1000.10 would be the same, and long node numbers would lose digits
    const std::size_t dot = word.rfind('.');
    const bool is_label =
        dot != std::string_view::npos && integer_in(word.substr(0, dot)).value_or(0) > 0 && word.size() == dot + 2;
    if (!is_label || word.back() < '0' || word.back() > '9')
        throw scanner.refusal(fmt::format("\"{}\" is no node.component", word), "each line labels a row: \"1000.3\"");
    if (word.back() < '1' || word.back() > '3')
        throw scanner.refusal(fmt::format("the component of {} is none of 1, 2 and 3", word),
                              "CalculiX stores displacements along x, y and z; 0 is a temperature");
    scanner.expect_end();
    return {std::string(word.substr(0, dot)), word.back() - '0'};
}

// what is wrong with a label that is there twice is not the label
void expect_solids(const std::vector<RowLabel>& labels, const std::string& file) {
    std::set<RowLabel> seen;
    for (const RowLabel& label : labels)
        if (!seen.insert(label).second)
            throw refusal(file, fmt::format("the label {} stands for several rows", reduction::describe(label)),
                          "CalculiX gives further rows the number of an old node: where it expands beams and shells to "
                          "solids, and for the inner modes of C3D8I",
                          "Use other solids (C3D8, C3D10, C3D20), or masses and springs.");
}

void expect_rows(const ListedMatrix& matrix, std::size_t labels, const std::string& label_file) {
    if (matrix.rows != static_cast<Eigen::Index>(labels))
        throw refusal(
            matrix.file,
            fmt::format("the {} has {} rows, {} has {} labels", name_of(matrix.role), matrix.rows, label_file, labels),
            "they must be of the same run", "Run CalculiX again; it writes all three.");
}

// what the deck says of the rows: rotations of rigid bodies, and nodes it does not have
void take_deck(reduction::ElasticPart& part, CalculixDeck deck, const std::string& label_file) {
    for (RowLabel& label : part.labels) {
        if (deck.rotation_nodes.contains(label.node))
            label.component += 3;
        else if (!deck.positions.empty() && !deck.positions.contains(label.node))
            throw refusal(label_file, fmt::format("node {} is not in the deck", label.node),
                          "CalculiX made it itself: for expanded elements, or for the rotations of a rigid body",
                          "Name a rigid body's rotations by ROT NODE=; use solids instead of beams and shells.");
    }
    part.positions = std::move(deck.positions);
    part.sets = std::move(deck.sets);
    part.notes.insert(part.notes.end(), deck.notes.begin(), deck.notes.end());
}

}  // namespace

std::vector<RowLabel> read_calculix_labels(const StructureInput& input) {
    LineReader lines(input.bytes, input.name);
    std::vector<RowLabel> labels;
    while (const auto line = lines.next())
        if (line->text.find_first_not_of(" \t") != std::string_view::npos)
            labels.push_back(label_in(*line, input.name));
    if (labels.empty()) throw refusal(input.name, "there is no label in it", "each line labels a row: \"1000.3\"");
    expect_solids(labels, input.name);
    return labels;
}

ListedMatrix read_calculix_matrix(const StructureInput& input, MatrixRole role) {
    LineReader lines(input.bytes, input.name);
    ListedMatrix matrix{.file = input.name, .role = role};
    while (const auto line = lines.next()) {
        if (line->text.find_first_not_of(" \t") == std::string_view::npos) continue;
        FieldScanner scanner(*line, input.name);
        const std::int64_t row = scanner.integer("a row");
        const std::int64_t column = scanner.integer("a column");
        add_entry(matrix, scanner, row, column, scanner.real("a value"));
        scanner.expect_end();
    }
    if (matrix.entries.empty())
        throw refusal(input.name, "there is no entry in it", "each line holds row, column and value");
    return matrix;
}

reduction::ElasticPart read_calculix(const CalculixFiles& files) {
    const std::vector<RowLabel> labels = read_calculix_labels(files.labels);
    ListedMatrix stiffness = read_calculix_matrix(files.stiffness, MatrixRole::stiffness);
    ListedMatrix mass = read_calculix_matrix(files.mass, MatrixRole::mass);
    expect_rows(stiffness, labels.size(), files.labels.name);
    expect_rows(mass, labels.size(), files.labels.name);
    stiffness.labels = mass.labels = labels;
    reduction::ElasticPart part = joined_part(std::move(stiffness), mass, nullptr);
    if (files.deck)
        take_deck(part, read_calculix_deck(*files.deck, files.open_include), files.labels.name);
    else
        part.notes.emplace_back("without its deck (.inp) the part has neither places nor sets of nodes");
    return part;
}

}  // namespace stridor::io::structure
