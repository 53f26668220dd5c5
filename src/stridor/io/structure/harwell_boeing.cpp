#include "stridor/io/structure/harwell_boeing.hpp"

#include "stridor/base/text.hpp"
#include "stridor/io/structure/field_scanner.hpp"
#include "stridor/io/structure/row_labels.hpp"
#include "stridor/recordings/line_reader.hpp"
#include "stridor/recordings/raw_signal.hpp"

#include <fmt/format.h>

#include <array>

namespace stridor::io::structure {

namespace {

using recordings::LineReader;
using recordings::place_of;
using recordings::refusal;
using recordings::TextLine;

/// Reads lines, and numbers in fixed fields that go on over lines.
class FixedReader {
public:
    explicit FixedReader(const StructureInput& input) : lines_(input.bytes, input.name), file_(input.name) {}

    std::string_view line() {
        const auto next = lines_.next();
        if (!next) throw refusal(file_, "the matrix is cut off", "the file ends within it");
        text_ = next->text;
        line_ = {text_, next->number, next->offset};
        return text_;
    }

    template <typename Number, typename Parse>
    std::vector<Number> numbers(std::int64_t count, const FortranFormat& format, Parse parse) {
        std::vector<Number> all;
        while (static_cast<std::int64_t>(all.size()) < count) {
            const auto fields = fields_of(line(), format);
            if (fields.empty() || static_cast<std::int64_t>(all.size() + fields.size()) > count)
                throw complaint(
                    fmt::format("here should stand {} more numbers", count - static_cast<std::int64_t>(all.size())));
            for (const std::string_view field : fields) {
                const auto value = parse(field);
                if (!value) throw complaint(fmt::format("\"{}\" is no number of its kind", field));
                all.push_back(*value);
            }
        }
        return all;
    }

    base::Error complaint(std::string what, std::string why = "", std::string suggestion = "") const {
        return refusal(place_of(file_, line_, 1), std::move(what), std::move(why), std::move(suggestion));
    }

private:
    LineReader lines_;
    const std::string& file_;
    std::string text_;
    TextLine line_;
};

/// What the head says.
struct HarwellBoeingHead {
    MatrixRole role = MatrixRole::untold;
    bool is_symmetric = false;
    std::int64_t rows = 0;
    std::int64_t entries = 0;
    std::array<FortranFormat, 3> formats;  // pointers, rows, values
};

MatrixRole role_of_title(std::string_view title) {
    const std::string large = upper(title);
    if (large.find("STIFF") != std::string::npos) return MatrixRole::stiffness;
    if (large.find("MASS") != std::string::npos) return MatrixRole::mass;
    if (large.find("DAMP") != std::string::npos) return MatrixRole::damping;
    return MatrixRole::untold;
}

HarwellBoeingHead head_of(FixedReader& reader) {
    HarwellBoeingHead head;
    head.role = role_of_title(reader.line());
    const auto counts = recordings::words(reader.line());
    const bool has_right_sides = counts.size() > 4 && integer_in(counts[4]).value_or(0) > 0;
    const std::string third(reader.line());
    const std::string type = upper(std::string_view(third).substr(0, 3));
    if (type != "RSA" && type != "RUA")
        throw reader.complaint(fmt::format("matrices of type {} are not read", type),
                               "those of a structure are real and assembled: RSA or RUA");
    head.is_symmetric = type == "RSA";
    const auto sizes = recordings::words(std::string_view(third).substr(3));
    const auto size = [&](std::size_t k) { return k < sizes.size() ? integer_in(sizes[k]).value_or(-1) : -1; };
    head.rows = size(0);
    head.entries = size(2);
    constexpr std::int64_t most = 2'000'000'000;
    if (head.rows < 1 || head.rows != size(1) || head.rows > most || head.entries < 1 || head.entries > most)
        throw reader.complaint("the sizes of the matrix make no sense", "it is square, and has entries");
    const std::string fourth(reader.line());
    const auto formats = recordings::words(fourth);
    for (std::size_t k = 0; k < head.formats.size(); ++k) {
        const auto format = k < formats.size() ? fortran_format(formats[k]) : std::nullopt;
        if (!format) throw reader.complaint("the formats of the numbers are not understood");
        head.formats.at(k) = *format;
    }
    if (has_right_sides) reader.line();
    return head;
}

}  // namespace

bool is_harwell_boeing(std::string_view third_line) {
    if (third_line.size() < 14) return false;
    const std::string type = upper(third_line.substr(0, 3));
    return (type[0] == 'R' || type[0] == 'C' || type[0] == 'P') && std::string_view("SUHZR").find(type[1]) < 5 &&
           (type[2] == 'A' || type[2] == 'E') && third_line[3] == ' ';
}

ListedMatrix read_harwell_boeing(const StructureInput& input) {
    FixedReader reader(input);
    const HarwellBoeingHead head = head_of(reader);
    const auto pointers = reader.numbers<std::int64_t>(head.rows + 1, head.formats[0], integer_in);
    if (pointers.front() != 1 || pointers.back() != head.entries + 1)
        throw reader.complaint("the pointers do not fit the number of entries", "",
                               "Ansys 9 wrote wrong ones for superelements; use a later release.");
    for (std::size_t k = 1; k < pointers.size(); ++k)
        if (pointers[k] < pointers[k - 1])
            throw reader.complaint("the pointers of the columns do not rise", "",
                                   "Ansys 9 wrote such ones for superelements; use a later release.");
    const auto rows = reader.numbers<std::int64_t>(head.entries, head.formats[1], integer_in);
    const auto values = reader.numbers<double>(head.entries, head.formats[2], real_in);
    ListedMatrix matrix{.file = input.name,
                        .role = head.role,
                        .triangles = head.is_symmetric ? Triangles::one : Triangles::both,
                        .rows = static_cast<Eigen::Index>(head.rows)};
    for (std::size_t column = 0; column + 1 < pointers.size(); ++column)
        for (auto at = static_cast<std::size_t>(pointers[column] - 1);
             at < static_cast<std::size_t>(pointers[column + 1] - 1); ++at) {
            if (rows[at] < 1 || rows[at] > head.rows)
                throw reader.complaint(fmt::format("there is no row {}", rows[at]),
                                       fmt::format("the matrix has {}", head.rows));
            matrix.entries.emplace_back(static_cast<int>(rows[at] - 1), static_cast<int>(column), values[at]);
        }
    return matrix;
}

bool is_ansys_mapping(std::string_view first_line) {
    const auto words = recordings::words(first_line);
    return words.size() == 4 && upper(words[0]) == "MATRIX" && upper(words[2]) == "NODE" && upper(words[3]) == "DOF";
}

std::vector<reduction::RowLabel> read_ansys_mapping(const StructureInput& input) {
    LineReader lines(input.bytes, input.name);
    lines.next();
    std::vector<reduction::RowLabel> labels;
    while (const auto line = lines.next()) {
        if (base::trimmed(line->text).empty()) continue;
        FieldScanner scanner(*line, input.name);
        const std::int64_t equation = scanner.integer("an equation");
        if (equation != static_cast<std::int64_t>(labels.size()) + 1)
            throw scanner.refusal(fmt::format("equation {} is out of order", equation), "they count from 1");
        const std::int64_t node = scanner.integer("a node");
        const std::string_view name = scanner.word();
        const auto component = component_in(name);
        if (node < 1 || !component || *component == 0)
            throw scanner.refusal(fmt::format("\"{}\" is no displacement or rotation", name),
                                  "a structure has UX, UY, UZ, ROTX, ROTY and ROTZ");
        labels.push_back({std::to_string(node), *component});
    }
    return labels;
}

}  // namespace stridor::io::structure
