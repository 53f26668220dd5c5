#include "stridor/io/case/own_structure/contacts_csv.hpp"

#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/recordings/line_reader.hpp"
#include "stridor/recordings/raw_signal.hpp"
#include "stridor/recordings/table/csv_table.hpp"
#include "stridor/recordings/table/named_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

namespace stridor::io {

namespace {

namespace csv = recordings::csv_table;
using parameters::ContactField;
using parameters::OwnContact;
using recordings::refusal;

class ContactTable {
public:
    explicit ContactTable(const structure::StructureInput& input) : rows_(input.bytes, input.name) {
        for (const recordings::NamedColumn& column : rows_.columns())
            factors_[column.name] = factor_of(column);
        if (!rows_.has("normal") || !rows_.has("tangent"))
            throw refusal(rows_.columns().front().place, "the table lacks a column normal or tangent",
                          "each contact has both");
    }

    bool next() { return rows_.next(); }

    NamedContact contact() const { return named_contact(*this, rows_.place()); }

    std::optional<std::string> text(std::string_view key) const {
        const std::string words = rows_.text(key);
        return words.empty() ? std::nullopt : std::optional(words);
    }

    std::optional<double> number(const ContactField& field) const {
        const std::string words = rows_.text(field.key);
        if (words.empty()) return std::nullopt;
        const auto value = rows_.number(field.key);
        if (!value) throw refusal(rows_.place(), fmt::format("\"{}\" is no number of {}", words, field.key));
        if (*value < field.range.low) throw refusal(rows_.place(), fmt::format("{} is negative", field.key));
        return factors_.find(field.key)->second * *value;
    }

    std::optional<NamedDirection> direction(const ContactField& field) const {
        const std::string words = rows_.text(field.key);
        const bool may_lack = field.need == ContactField::Need::optional;
        return words.empty() && may_lack ? std::nullopt : std::optional<NamedDirection>(words);
    }

    std::optional<std::array<double, 3>> position(const ContactField& field) const {
        const std::string words = rows_.text(field.key);
        if (words.empty()) return std::nullopt;
        std::array<double, 3> found{};
        std::size_t count = 0;
        for (const std::string_view word : recordings::words(words)) {
            const auto value = csv::number_in(std::string(word), csv::Dialect{';'});
            if (!value || !std::isfinite(*value) || count >= found.size())
                throw refusal(rows_.place(), fmt::format("\"{}\" is no position", words), "it is three numbers, in m");
            found.at(count++) = *value;
        }
        if (count < found.size())
            throw refusal(rows_.place(), fmt::format("\"{}\" is no position", words), "it is three numbers, in m");
        return found;
    }

private:
    // to the field's unit; numbers of SI are 1 of it, and what has no unit there needs none here
    static double factor_of(const recordings::NamedColumn& column) {
        const auto keys = contact_keys();
        if (std::find(keys.begin(), keys.end(), column.name) == keys.end()) {
            const std::string near(base::nearest_name(column.name, keys));
            throw refusal(column.place, fmt::format("\"{}\" is no column of contacts", column.name), "",
                          near.empty() ? "" : "Did you mean " + near + "?");
        }
        const auto fields = parameters::contact_fields();
        const auto field = std::find_if(fields.begin(), fields.end(),
                                        [&](const ContactField& each) { return each.key == column.name; });
        const bool is_number = field != fields.end() && std::holds_alternative<double OwnContact::*>(field->member);
        if (column.unit.empty() || !is_number || field->unit == "1") return 1.0;
        const auto unit = base::find_unit(column.unit);
        if (!unit || !(unit->dimension == base::find_unit(field->unit)->dimension))
            throw refusal(column.place, fmt::format("\"{}\" is no unit of {}", column.unit, column.name),
                          fmt::format("it is in {}", field->unit));
        return unit->factor;
    }

    recordings::NamedTable rows_;
    std::map<std::string, double, std::less<>> factors_;  // [1] of a column's numbers
};

}  // namespace

std::vector<NamedContact> read_contacts_csv(const structure::StructureInput& input) {
    ContactTable table(input);
    std::vector<NamedContact> contacts;
    while (table.next())
        contacts.push_back(table.contact());
    if (contacts.empty()) throw refusal(input.name, "the table of contacts has no contact");
    return contacts;
}

}  // namespace stridor::io
