#include "stridor/io/structure/nastran/dmig.hpp"

#include "stridor/base/text.hpp"
#include "stridor/recordings/raw_signal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace stridor::io::structure {

namespace {

using recordings::LineReader;
using recordings::refusal;
using reduction::describe;
using reduction::RowLabel;

constexpr std::size_t most_matrices = 64;  // of a file

/// A card as far as it was read: its fields without the names of continuations, blanks cut off.
struct Card {
    std::vector<std::string> fields;  // the first is the name, without its star
    int line = 0;                     // the last one read
    bool is_too_wide = false;         // text stands behind column 80 of it, which is not read

    std::string_view at(std::size_t field) const {
        return field < fields.size() ? std::string_view(fields[field]) : std::string_view();
    }
};

constexpr std::size_t width_of_line = 80;  // [1] columns that a line of fields has

/// The fields of one line behind its first. Values may touch each other: only columns part them.
void add_fields(std::string_view text, bool is_large, std::vector<std::string>& into) {
    const std::size_t width = is_large ? 16 : 8;
    constexpr std::size_t last = 72;  // behind it stands the name of the continuation
    for (std::size_t from = 8; from < last; from += width)
        into.emplace_back(from < text.size() ? base::trimmed(text.substr(from, width)) : std::string_view());
}

// behind `most` fields stands the name of the continuation. A line of more than that goes on by itself, as the Quick
// Reference Guide says ("Format of Bulk Data Entries"): all it holds are fields
void add_parted_fields(std::string_view text, std::size_t most, std::vector<std::string>& into) {
    std::vector<std::string> fields;
    for (std::size_t from = text.find(',') + 1; from <= text.size();) {
        const std::size_t comma = std::min(text.find(',', from), text.size());
        fields.emplace_back(base::trimmed(text.substr(from, comma - from)));
        from = comma + 1;
    }
    while (!fields.empty() && fields.back().empty())
        fields.pop_back();
    if (fields.size() <= most + 1) fields.resize(most);
    into.insert(into.end(), fields.begin(), fields.end());
}

// without its comment, and with blanks for its tabs: each field begins at a column
std::string plain_line(std::string_view text) {
    std::string plain;
    for (const char letter : text.substr(0, text.find('$')))
        if (letter == '\t')
            plain.resize((plain.size() / 8 + 1) * 8, ' ');
        else
            plain += letter;
    return plain;
}

bool is_continuation(std::string_view text) {
    return text.starts_with('*') || text.starts_with('+') || text.starts_with("        ") || text.starts_with(',');
}

/// Reads card after card, and each line by line: a column may be as long as the file.
class CardReader {
public:
    explicit CardReader(const StructureInput& input) : lines_(input.bytes, input.name) {}

    /// The first line of the next card; what is left of the one before is passed over.
    std::optional<Card> next() {
        while (ahead_ || advance()) {
            ahead_ = false;
            if (is_continuation(text_)) continue;
            Card card;
            add_line(card);
            return card;
        }
        return std::nullopt;
    }

    /// Adds the fields of the card's next line; false where it has no other.
    bool read_on(Card& card) {
        if (!ahead_ && !advance()) return false;
        if (!is_continuation(text_)) return false;
        ahead_ = false;
        add_line(card);
        return true;
    }

private:
    // the next line that says something
    bool advance() {
        while (const auto line = lines_.next()) {
            text_ = plain_line(line->text);
            if (base::trimmed(text_).empty()) continue;
            number_ = line->number;
            ahead_ = true;
            return true;
        }
        return ahead_ = false;
    }

    void add_line(Card& card) const {
        const std::string_view text = text_;
        const bool is_parted = text.substr(0, 72).find(',') != std::string_view::npos;
        std::string_view first = base::trimmed(text.substr(0, is_parted ? text.find(',') : 8));
        const bool is_large = first.find('*') != std::string_view::npos;
        if (card.fields.empty()) {
            std::string name = upper(first);
            std::erase(name, '*');
            card.fields.push_back(std::move(name));
        }
        if (is_parted)
            add_parted_fields(text, is_large ? 4 : 8, card.fields);
        else
            add_fields(text, is_large, card.fields);
        card.line = number_;
        card.is_too_wide = !is_parted && text.find_last_not_of(' ') + 1 > width_of_line;
    }

    LineReader lines_;
    std::string text_;  // of the line ahead
    int number_ = 0;
    bool ahead_ = false;
};

class DmigReader {
public:
    explicit DmigReader(const StructureInput& input) : file_(input.name) {}

    void take(Card& card, CardReader& cards) {
        card_ = &card;
        constexpr std::size_t head = 9;  // fields of a card of one short line
        const bool is_known = card.at(0) == "GRID" || card.at(0) == "DMIG";
        while (is_known && card.fields.size() < head && cards.read_on(card)) {
        }
        if (is_known) expect_whole();
        if (card.at(0) == "GRID") take_grid();
        if (card.at(0) != "DMIG") return;
        if (card.at(2) == "0")
            take_header();
        else
            take_column(card, cards);
    }

    DmigFile finish() {
        for (std::size_t k = 0; k < held_.size(); ++k) {
            held_[k].order.finish(held_[k].matrix);
            found_.matrices.push_back(std::move(held_[k].matrix));
        }
        return std::move(found_);
    }

private:
    struct Held {
        ListedMatrix matrix;
        LabelOrder order;
    };

    base::Error complaint(std::string what, std::string why = "", std::string suggestion = "") const {
        return refusal({file_, card_->line, 0, ""}, std::move(what), std::move(why), std::move(suggestion));
    }

    std::int64_t integer(std::size_t field, const char* what) const {
        const auto value = integer_in(card_->at(field));
        if (!value) throw complaint(fmt::format("\"{}\" is no {}", card_->at(field), what));
        return *value;
    }

    void expect_whole() const {
        if (card_->is_too_wide)
            throw complaint("text stands behind column 80", "a line of fields ends there, and it would not be read",
                            "Part the fields by commas, or go on in the next line.");
    }

    void take_header() {
        const std::string name = upper(card_->at(1));
        const std::int64_t form = integer(3, "form of a matrix");
        const std::int64_t type = integer(4, "type of numbers");
        for (const Held& each : held_)
            if (each.matrix.name == name)
                throw complaint(fmt::format("the matrix {} comes twice", name), "which of them counts is not said");
        if (held_.size() == most_matrices)
            throw complaint(fmt::format("there are more than {} matrices", most_matrices),
                            "a part has a stiffness, a mass and a damping");
        const bool is_square = form == 1 || form == 6;
        const bool is_complex = type != 1 && type != 2;
        held_.push_back({{.file = file_,
                          .name = name,
                          .role = role_of_name(name),
                          .triangles = form == 6 ? Triangles::untold : Triangles::both,
                          .is_passed_over = !is_square || is_complex},
                         {}});
    }

    // 0 and blank: a scalar point
    RowLabel label_at(std::size_t field) const {
        const std::int64_t node = integer(field, "node");
        const std::string_view text = card_->at(field + 1);
        const std::int64_t component = text.empty() ? 0 : integer(field + 1, "component");
        if (node < 1 || component < 0 || component > 6)
            throw complaint(fmt::format("there is no component {} of node {}", component, node),
                            "components are 1 to 6, and 0 for a scalar point");
        return {std::to_string(node), static_cast<int>(component)};
    }

    void take_column(Card& card, CardReader& cards) {
        const std::string name = upper(card_->at(1));
        const auto held =
            std::find_if(held_.begin(), held_.end(), [&](const Held& each) { return each.matrix.name == name; });
        if (held == held_.end())
            throw complaint(fmt::format("the matrix {} has no header", name),
                            "a card with 0 in its third field comes first");
        if (held->matrix.is_passed_over) return;
        const Eigen::Index column = held->order.row_of(label_at(2));
        take_entries(*held, column, 5);
        for (card.fields.resize(1); cards.read_on(card); card.fields.resize(1)) {
            expect_whole();
            take_entries(*held, column, 1);
        }
    }

    // from a field on: node, component, real and imaginary part of each row
    void take_entries(Held& held, Eigen::Index column, std::size_t from) {
        for (std::size_t at = from; at < card_->fields.size(); at += 4) {
            if (card_->at(at).empty() && card_->at(at + 2).empty()) continue;
            const Eigen::Index row = held.order.row_of(label_at(at));
            if (card_->at(at + 2).empty())
                throw complaint(
                    fmt::format("{} of the matrix {} has no value", describe(label_at(at)), held.matrix.name));
            const auto value = real_in(card_->at(at + 2));
            if (!value) throw complaint(fmt::format("\"{}\" is no finite number", card_->at(at + 2)));
            expect_real(held, at + 3);
            held.matrix.entries.emplace_back(static_cast<int>(row), static_cast<int>(column), *value);
        }
    }

    // "0000E+06" is no zero there, but the end of a value that is wider than its field
    void expect_real(const Held& held, std::size_t imaginary) const {
        const std::string_view text = card_->at(imaginary);
        const std::size_t digit = std::min(text.find_first_not_of("+-"), text.size());
        const bool is_whole =
            text.substr(digit) == "0" || text.substr(digit, 2) == "0." || text.substr(digit, 1) == ".";
        if (!text.empty() && !(is_whole && real_in(text) == 0.0))
            throw complaint(fmt::format("\"{}\" stands behind a value of {}, which is real", text, held.matrix.name),
                            "the field of the imaginary part is empty in a real matrix; a value of more than 16 "
                            "columns, or 8, reaches into it",
                            "Write values of 16 columns, %16.9E, or part the fields by commas.");
    }

    void take_grid() {
        const std::string node = std::to_string(integer(1, "node"));
        const auto system_at = [&](std::size_t field) {
            return card_->at(field).empty() ? std::int64_t{0} : integer(field, "coordinate system");
        };
        if (system_at(2) != 0)
            throw complaint(fmt::format("node {} is placed in the coordinate system {}", node, system_at(2)),
                            "only places in the basic system are read", "Write it in the basic system (CP = 0).");
        if (system_at(6) != 0)
            throw complaint(
                fmt::format("the displacements of node {} are in the coordinate system {}", node, system_at(6)),
                "its rows are then not along x, y and z", "Write it in the basic system (CD = 0).");
        Eigen::Vector3d position = Eigen::Vector3d::Zero();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (card_->at(3 + axis).empty()) continue;
            const auto value = real_in(card_->at(3 + axis));
            if (!value) throw complaint(fmt::format("\"{}\" is no coordinate", card_->at(3 + axis)));
            position[static_cast<Eigen::Index>(axis)] = *value;
        }
        found_.positions[node] = position;
    }

    const std::string& file_;
    const Card* card_ = nullptr;
    std::vector<Held> held_;
    DmigFile found_;
};

}  // namespace

bool is_dmig(std::string_view beginning) {
    for (std::size_t from = 0; from < beginning.size();) {
        const std::size_t end = std::min(beginning.find('\n', from), beginning.size());
        const std::string word = upper(beginning.substr(from, std::min<std::size_t>(4, end - from)));
        if (word == "DMIG" || word == "GRID") return true;
        from = end + 1;
    }
    return false;
}

DmigFile read_dmig(const StructureInput& input) {
    CardReader cards(input);
    DmigReader reader(input);
    while (auto card = cards.next())
        reader.take(*card, cards);
    return reader.finish();
}

}  // namespace stridor::io::structure
