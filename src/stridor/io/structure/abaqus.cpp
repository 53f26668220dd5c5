#include "stridor/io/structure/abaqus.hpp"

#include "stridor/base/text.hpp"
#include "stridor/recordings/raw_signal.hpp"

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

constexpr std::int64_t most_element_nodes = 100'000;

/// A value of a keyword line: "LINEAR" of "*USER ELEMENT,NODES=36,LINEAR"; the text behind "NODES=" for "NODES".
std::optional<std::string> parameter(std::string_view line, std::string_view name) {
    for (std::size_t from = line.find(','); from < line.size();) {
        const std::size_t end = std::min(line.find(',', from + 1), line.size());
        const std::string_view each = base::trimmed(line.substr(from + 1, end - from - 1));
        const std::size_t equals = std::min(each.find('='), each.size());
        if (base::trimmed(each.substr(0, equals)) == name)
            return std::string(base::trimmed(each.substr(std::min(equals + 1, each.size()))));
        from = end;
    }
    return std::nullopt;
}

MatrixRole role_of_type(std::string_view type) {
    if (type == "STIFFNESS") return MatrixRole::stiffness;
    if (type == "MASS") return MatrixRole::mass;
    if (type.find("STRUCTURAL") != std::string_view::npos) return MatrixRole::structural_damping;
    if (type.find("DAMPING") != std::string_view::npos) return MatrixRole::damping;
    return MatrixRole::untold;
}

class UserElementReader {
public:
    explicit UserElementReader(const StructureInput& input) : lines_(input.bytes, input.name), file_(input.name) {}

    std::vector<ListedMatrix> read() {
        while (const auto line = lines_.next()) {
            const std::string large = upper(base::trimmed(line->text));
            if (large.empty()) continue;
            FieldScanner scanner(*line, file_);
            if (large.starts_with("**"))
                take_comment(large);
            else if (large.starts_with('*'))
                take_keyword(large, scanner);
            else if (section_ == Section::freedoms)
                take_freedoms(scanner);
            else if (section_ == Section::values)
                take_values(scanner);
        }
        finish_matrix();
        const auto has = [&](MatrixRole role) {
            return std::any_of(matrices_.begin(), matrices_.end(), [&](const auto& each) { return each.role == role; });
        };
        if (!has(MatrixRole::stiffness) || !has(MatrixRole::mass))
            throw refusal(file_, "it holds the matrix of a substructure without its mass",
                          "CalculiX condenses the stiffness alone, so that it cannot vibrate",
                          "Write the whole matrices: *FREQUENCY, SOLVER=MATRIXSTORAGE; in Abaqus with MASS=YES.");
        return std::move(matrices_);
    }

private:
    enum class Section { none, nodes, freedoms, values };

    // the nodes stand in comments, since an element definition has none
    void take_comment(std::string_view text) {
        if (text.find("ELEMENT NODES") != std::string_view::npos) {
            in_nodes_ = true;
            return;
        }
        const std::string_view list = text.substr(2);
        if (!in_nodes_ || list.find_first_not_of("0123456789-, \t") != std::string_view::npos) {
            in_nodes_ = in_nodes_ && base::trimmed(list).empty();
            return;
        }
        const recordings::TextLine line{list, 0, 0};
        FieldScanner scanner(line, file_);
        for (std::string_view word = scanner.word(); !word.empty(); word = scanner.word())
            if (const auto node = integer_in(word)) nodes_.push_back(*node);
    }

    void take_keyword(const std::string& text, const FieldScanner& scanner) {
        in_nodes_ = false;
        finish_matrix();
        section_ = Section::none;
        if (text.starts_with("*USER ELEMENT")) {
            const auto count = integer_in(parameter(text, "NODES").value_or(""));
            if (!count || *count < 1 || *count > most_element_nodes || node_count_ != 0)
                throw scanner.refusal("the number of nodes is missing, too large or there twice",
                                      "*USER ELEMENT, NODES=36, LINEAR opens the file");
            node_count_ = *count;
            section_ = Section::freedoms;
        } else if (text.starts_with("*MATRIX")) {
            role_ = role_of_type(parameter(text, "TYPE").value_or(""));
            find_labels();
            section_ = Section::values;
        }
    }

    // "1, 2, 3" of the first node; "5, 1, 2" from the fifth on
    void take_freedoms(FieldScanner& scanner) {
        std::size_t position = 0;
        if (!freedoms_.empty()) {
            const std::int64_t number = scanner.integer("the position of a node");
            if (number <= static_cast<std::int64_t>(freedoms_.size()) || number > node_count_)
                throw scanner.refusal(fmt::format("there is no node at position {}", number),
                                      fmt::format("positions rise, and there are {} nodes", node_count_));
            position = static_cast<std::size_t>(number) - 1;
        }
        const std::vector<int> before = freedoms_.empty() ? std::vector<int>() : freedoms_.back();
        freedoms_.resize(position, before);
        std::vector<int>& its = freedoms_.emplace_back();
        for (std::string_view word = scanner.word(); !word.empty(); word = scanner.word()) {
            const auto component = integer_in(word);
            if (!component || *component < 1 || *component > 6)
                throw scanner.refusal(fmt::format("the degree of freedom \"{}\" is none of 1 to 6", word),
                                      "a structure has displacements and rotations; 8 is a pressure, 11 a temperature");
            if (its.size() == 6) throw scanner.refusal("a node has more than 6 degrees of freedom");
            its.push_back(static_cast<int>(*component));
        }
    }

    void find_labels() {
        if (!labels_.empty()) return;
        if (freedoms_.empty()) throw refusal(file_, "it does not say which degrees of freedom its nodes have");
        if (static_cast<std::int64_t>(nodes_.size()) != node_count_)
            throw refusal(file_, fmt::format("the element has {} nodes, and lists {}", node_count_, nodes_.size()),
                          "a comment \"** ELEMENT NODES\" lists them; without them no row has a label");
        freedoms_.resize(nodes_.size(), std::vector<int>(freedoms_.back()));
        for (std::size_t k = 0; k < nodes_.size(); ++k)
            for (const int component : freedoms_[k])
                labels_.push_back(nodes_[k] > 0 ? RowLabel{std::to_string(nodes_[k]), component}
                                                : RowLabel{fmt::format("internal {}.{}", k + 1, component), 0});
    }

    void take_values(FieldScanner& scanner) {
        const std::size_t rows = labels_.size();
        while (!scanner.is_at_end()) {
            values_.push_back(scanner.real("a value"));
            if (values_.size() > rows * rows)
                throw scanner.refusal(fmt::format("the {} has more than {} values", name_of(role_), rows * rows),
                                      fmt::format("it has {} rows", rows));
        }
    }

    void finish_matrix() {
        if (section_ != Section::values) return;
        const std::size_t rows = labels_.size();
        const bool is_whole = values_.size() == rows * rows && rows > 1;
        if (!is_whole && values_.size() != rows * (rows + 1) / 2)
            throw refusal(
                file_, fmt::format("the {} has {} values", name_of(role_), values_.size()),
                fmt::format("{} rows have {} in a triangle, or {}", rows, rows * (rows + 1) / 2, rows * rows));
        ListedMatrix matrix{.file = file_,
                            .name = std::string(name_of(role_)),
                            .role = role_,
                            .triangles = is_whole ? Triangles::both : Triangles::one,
                            .rows = static_cast<Eigen::Index>(rows),
                            .labels = labels_};
        std::size_t at = 0;
        for (int row = 0; row < static_cast<int>(rows); ++row)
            for (int column = 0; column < (is_whole ? static_cast<int>(rows) : row + 1); ++column, ++at)
                if (values_[at] != 0.0) matrix.entries.emplace_back(row, column, values_[at]);
        if (role_ != MatrixRole::untold) matrices_.push_back(std::move(matrix));
        values_.clear();
    }

    LineReader lines_;
    const std::string& file_;
    Section section_ = Section::none;
    bool in_nodes_ = false;
    std::int64_t node_count_ = 0;
    std::vector<std::int64_t> nodes_;
    std::vector<std::vector<int>> freedoms_;  // shape [node]
    std::vector<RowLabel> labels_;
    MatrixRole role_ = MatrixRole::untold;
    std::vector<double> values_;
    std::vector<ListedMatrix> matrices_;
};

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

bool is_user_element(std::string_view first_data_line) {
    return upper(base::trimmed(first_data_line)).starts_with("*USER ELEMENT");
}

std::vector<ListedMatrix> read_user_element(const StructureInput& input) {
    return UserElementReader(input).read();
}

}  // namespace stridor::io::structure
