#include "stridor/io/case/own_structure/contacts_csv.hpp"

#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/recordings/fortran_text.hpp"
#include "stridor/recordings/line_reader.hpp"
#include "stridor/recordings/refusal.hpp"
#include "stridor/recordings/table/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace stridor::io {

namespace {

namespace csv = recordings::csv_table;
using recordings::place_of;
using recordings::refusal;
using recordings::TextLine;

// the places of `contact_keys`
enum class TableKey : std::size_t {
    name,
    node,
    set,
    against,
    interface,
    normal,
    tangent,
    second_tangent,
    initial_gap,
    static_friction,
    kinetic_friction,
    preload_share,
    drive_share,
    second_drive_share,
    position
};

constexpr std::size_t index_of(TableKey column) {
    return static_cast<std::size_t>(column);
}

class ContactTable {
public:
    /// Takes the titles.
    ContactTable(const std::string& file, const TextLine& line) : file_(file) {
        std::string first(line.text);
        if (first.starts_with(csv::utf8_mark)) first.erase(0, csv::utf8_mark.size());
        dialect_ = csv::sniff(first);
        const std::vector<csv::CsvField> titles = csv::split(first, dialect_.delimiter);
        for (std::size_t k = 0; k < titles.size(); ++k)
            take_title(titles[k], k, place_of(file_, line, titles[k].column));
        if (!place_of_column(TableKey::normal) || !place_of_column(TableKey::tangent))
            throw refusal(place_of(file_, line, 1), "the table lacks a column normal or tangent",
                          "each contact has both");
    }

    NamedContact contact_in(const TextLine& line) {
        fields_ = csv::split(line.text, dialect_.delimiter);
        place_ = place_of(file_, line, 1);
        return {.name = text(TableKey::name),
                .node = text(TableKey::node),
                .set = text(TableKey::set),
                .against = text(TableKey::against),
                .interface = text(TableKey::interface),
                .normal = text(TableKey::normal),
                .tangent = text(TableKey::tangent),
                .second_tangent = text(TableKey::second_tangent).empty()
                                      ? std::nullopt
                                      : std::optional<NamedDirection>(text(TableKey::second_tangent)),
                .initial_gap = length_ * number(TableKey::initial_gap).value_or(0.0),
                .static_friction = size(TableKey::static_friction),
                .kinetic_friction = size(TableKey::kinetic_friction),
                .preload_share = size(TableKey::preload_share),
                .drive_share = number(TableKey::drive_share).value_or(1.0),
                .second_drive_share = number(TableKey::second_drive_share).value_or(0.0),
                .position = position(),
                .place = place_};
    }

private:
    std::optional<std::size_t> place_of_column(TableKey column) const { return places_.at(index_of(column)); }

    void take_title(const csv::CsvField& field, std::size_t k, const base::Place& place) {
        const csv::Title title = csv::title_of(field.text);
        const std::string known = csv::lower(title.name);
        const auto found = std::find(contact_keys.begin(), contact_keys.end(), known);
        if (found == contact_keys.end()) {
            const std::string near(base::nearest_name(known, contact_keys));
            throw refusal(place, fmt::format("\"{}\" is no column of contacts", title.name), "",
                          near.empty() ? "" : "Did you mean " + near + "?");
        }
        const auto column = static_cast<std::size_t>(found - contact_keys.begin());
        places_.at(column) = k;
        if (column != index_of(TableKey::initial_gap) || title.unit.empty()) return;
        const auto unit = base::find_unit(title.unit);
        if (!unit || !(unit->dimension == base::Dimension{.length = 1}))
            throw refusal(place, fmt::format("\"{}\" is no length", title.unit));
        length_ = unit->factor;
    }

    std::string text(TableKey column) const {
        const auto place = place_of_column(column);
        return place && *place < fields_.size() ? fields_[*place].text : std::string();
    }

    std::optional<double> number(TableKey column) const {
        const std::string words = text(column);
        if (words.empty()) return std::nullopt;
        const auto value = csv::number_in(words, dialect_);
        if (!value || !std::isfinite(*value))
            throw refusal(place_, fmt::format("\"{}\" is no number of {}", words, contact_keys.at(index_of(column))));
        return value;
    }

    std::optional<double> size(TableKey column) const {
        const auto value = number(column);
        if (value && *value < 0.0)
            throw refusal(place_, fmt::format("{} is negative", contact_keys.at(index_of(column))));
        return value;
    }

    std::optional<std::array<double, 3>> position() const {
        const std::string words = text(TableKey::position);
        if (words.empty()) return std::nullopt;
        std::array<double, 3> found{};
        std::size_t count = 0;
        for (const std::string_view word : recordings::words(words)) {
            const auto value = csv::number_in(std::string(word), csv::Dialect{';'});
            if (!value || !std::isfinite(*value) || count >= found.size())
                throw refusal(place_, fmt::format("\"{}\" is no position", words), "it is three numbers, in m");
            found.at(count++) = *value;
        }
        if (count < found.size())
            throw refusal(place_, fmt::format("\"{}\" is no position", words), "it is three numbers, in m");
        return found;
    }

    const std::string& file_;
    csv::Dialect dialect_;
    std::array<std::optional<std::size_t>, contact_keys.size()> places_{};
    double length_ = 1.0;  // [m] unit of the gaps
    std::vector<csv::CsvField> fields_;
    base::Place place_;
};

}  // namespace

std::vector<NamedContact> read_contacts_csv(const structure::StructureInput& input) {
    recordings::LineReader lines(input.bytes, input.name);
    const auto is_empty = [](const TextLine& line) {
        return base::trimmed(line.text).empty() || line.text.starts_with('#');
    };
    auto line = lines.next();
    while (line && is_empty(*line))
        line = lines.next();
    if (!line) throw refusal(input.name, "the table of contacts is empty");
    ContactTable table(input.name, *line);
    std::vector<NamedContact> contacts;
    while (const auto row = lines.next())
        if (!is_empty(*row)) contacts.push_back(table.contact_in(*row));
    if (contacts.empty()) throw refusal(input.name, "the table of contacts has no contact");
    return contacts;
}

}  // namespace stridor::io
