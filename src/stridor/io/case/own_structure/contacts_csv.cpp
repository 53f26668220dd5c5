#include "stridor/io/case/own_structure/contacts_csv.hpp"

#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/recordings/line_reader.hpp"
#include "stridor/recordings/raw_signal.hpp"
#include "stridor/recordings/table/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace stridor::io {

namespace {

namespace csv = recordings::csv_table;
using parameters::ContactField;
using parameters::OwnContact;
using recordings::place_of;
using recordings::refusal;
using recordings::TextLine;

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
        if (!columns_.contains("normal") || !columns_.contains("tangent"))
            throw refusal(place_of(file_, line, 1), "the table lacks a column normal or tangent",
                          "each contact has both");
    }

    NamedContact contact_in(const TextLine& line) {
        fields_ = csv::split(line.text, dialect_.delimiter);
        place_ = place_of(file_, line, 1);
        return named_contact(*this, place_);
    }

    std::optional<std::string> text(std::string_view key) const {
        const std::string words = cell(key);
        return words.empty() ? std::nullopt : std::optional(words);
    }

    std::optional<double> number(const ContactField& field) const {
        const std::string words = cell(field.key);
        if (words.empty()) return std::nullopt;
        const auto value = csv::number_in(words, dialect_);
        if (!value || !std::isfinite(*value))
            throw refusal(place_, fmt::format("\"{}\" is no number of {}", words, field.key));
        if (*value < field.range.low) throw refusal(place_, fmt::format("{} is negative", field.key));
        return columns_.find(field.key)->second.factor * *value;
    }

    std::optional<NamedDirection> direction(const ContactField& field) const {
        const std::string words = cell(field.key);
        const bool may_lack = field.need == ContactField::Need::optional;
        return words.empty() && may_lack ? std::nullopt : std::optional<NamedDirection>(words);
    }

    std::optional<std::array<double, 3>> position(const ContactField& field) const {
        const std::string words = cell(field.key);
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

private:
    struct Column {
        std::size_t place = 0;  // in its row
        double factor = 1.0;    // [1] of its numbers, to the field's unit
    };

    void take_title(const csv::CsvField& written, std::size_t k, const base::Place& place) {
        const csv::Title title = csv::title_of(written.text);
        const std::string known = csv::lower(title.name);
        const auto keys = contact_keys();
        const auto found = std::find(keys.begin(), keys.end(), known);
        if (found == keys.end()) {
            const std::string near(base::nearest_name(known, keys));
            throw refusal(place, fmt::format("\"{}\" is no column of contacts", title.name), "",
                          near.empty() ? "" : "Did you mean " + near + "?");
        }
        columns_[*found] = {k, title.unit.empty() ? 1.0 : factor_of(*found, title.unit, place)};
    }

    // numbers of SI are 1 of it; what has no unit there needs none here
    static double factor_of(std::string_view key, const std::string& written, const base::Place& place) {
        const auto fields = parameters::contact_fields();
        const auto field =
            std::find_if(fields.begin(), fields.end(), [&](const ContactField& each) { return each.key == key; });
        const bool is_number = field != fields.end() && std::holds_alternative<double OwnContact::*>(field->member);
        if (!is_number || field->unit == "1") return 1.0;
        const auto unit = base::find_unit(written);
        if (!unit || !(unit->dimension == base::find_unit(field->unit)->dimension))
            throw refusal(place, fmt::format("\"{}\" is no unit of {}", written, key),
                          fmt::format("it is in {}", field->unit));
        return unit->factor;
    }

    std::string cell(std::string_view key) const {
        const auto column = columns_.find(key);
        const bool is_there = column != columns_.end() && column->second.place < fields_.size();
        return is_there ? fields_[column->second.place].text : std::string();
    }

    const std::string& file_;
    csv::Dialect dialect_;
    std::map<std::string_view, Column> columns_;
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
