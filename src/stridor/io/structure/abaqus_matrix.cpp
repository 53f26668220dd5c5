#include "stridor/io/structure/abaqus_matrix.hpp"

#include "stridor/base/text.hpp"
#include "stridor/recordings/refusal.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace stridor::io::structure {

namespace {

using recordings::LineReader;
using recordings::refusal;
using reduction::RowLabel;

bool is_comment(std::string_view text) {
    return base::trimmed(text).empty() || base::trimmed(text).starts_with("**");
}

void expect_matrix(const FieldScanner& scanner, std::string_view text) {
    if (!text.starts_with('*')) return;
    const std::string keyword = upper(text);
    if (keyword.starts_with("*CLOAD"))
        throw scanner.refusal("it holds loads", "a structure is its stiffness and mass", "Leave the file out.");
    throw scanner.refusal(fmt::format("\"{}\" is no line of a matrix", text),
                          "it holds node, component, node, component, value");
}

RowLabel row_label(FieldScanner& scanner) {
    const std::int64_t node = scanner.integer("a node");
    const std::int64_t component = scanner.integer("a component");
    // an internal node has degrees of freedom that are no displacement
    if (node < 0 && component > 0 && component < 1000) return {fmt::format("internal {}.{}", -node, component), 0};
    if (node < 1 || component < 1 || component > 6)
        throw scanner.refusal(fmt::format("the component {} of node {} is none of 1 to 6", component, node),
                              "a structure has displacements and rotations; 8 is a pressure, 11 a temperature");
    return {std::to_string(node), static_cast<int>(component)};
}

}  // namespace

bool is_abaqus_matrix(std::string_view first_data_line) {
    if (std::count(first_data_line.begin(), first_data_line.end(), ',') == 4) return true;
    // two labels and a value, parted by blanks
    const recordings::TextLine line{.text = first_data_line};
    const std::string nobody;
    FieldScanner scanner(line, nobody);
    for (int field = 0; field < 4; ++field)
        if (!integer_in(scanner.word())) return false;
    return real_in(scanner.word()) && scanner.is_at_end();
}

ListedMatrix read_abaqus_matrix(const StructureInput& input) {
    LineReader lines(input.bytes, input.name);
    ListedMatrix matrix{.file = input.name};
    LabelOrder order;
    while (const auto line = lines.next()) {
        if (is_comment(line->text)) continue;
        FieldScanner scanner(*line, input.name);
        expect_matrix(scanner, line->text);
        const Eigen::Index row = order.row_of(row_label(scanner));
        const Eigen::Index column = order.row_of(row_label(scanner));
        add_entry(matrix, scanner, row + 1, column + 1, scanner.real("a value"));
        scanner.expect_end();
    }
    if (matrix.entries.empty()) throw refusal(input.name, "there is no entry in it");
    order.finish(matrix);
    return matrix;
}

ListedMatrix read_coordinate_matrix(const StructureInput& input) {
    LineReader lines(input.bytes, input.name);
    ListedMatrix matrix{.file = input.name};
    while (const auto line = lines.next()) {
        if (is_comment(line->text)) continue;
        FieldScanner scanner(*line, input.name);
        expect_matrix(scanner, line->text);
        const std::int64_t row = scanner.integer("a row");
        const std::int64_t column = scanner.integer("a column");
        add_entry(matrix, scanner, row, column, scanner.real("a value"));
        scanner.expect_end();
    }
    if (matrix.entries.empty()) throw refusal(input.name, "there is no entry in it");
    return matrix;
}

}  // namespace stridor::io::structure
