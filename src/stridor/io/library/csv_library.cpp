#include "stridor/io/library/csv_library.hpp"

#include "stridor/base/csv_text.hpp"
#include "stridor/noise_library/field.hpp"

#include <map>

namespace stridor::io {

using base::csv_text::Table;
using base::csv_text::TableColumn;
using noise_library::Entry;

std::string library_csv(std::span<const Entry> entries) {
    std::map<std::string, std::string> figures;  // name -> unit
    for (const Entry& entry : entries)
        for (const noise_library::Figure& figure : entry.figures)
            figures.emplace(figure.name, figure.unit);
    std::vector<TableColumn> columns{{"id"}};
    for (const noise_library::EntryField& field : noise_library::fields()) {
        const std::string_view unit = noise_library::unit_of(field);
        if (!noise_library::is_document(field)) columns.push_back({std::string(field.name), std::string(unit)});
    }
    for (const auto& [name, unit] : figures)
        columns.push_back({name, unit});

    Table table(base::csv_text::origin("library"), columns);
    for (const Entry& entry : entries) {
        table.number(static_cast<double>(entry.id));
        for (const noise_library::EntryField& field : noise_library::fields()) {
            if (noise_library::is_document(field)) continue;
            if (std::holds_alternative<noise_library::EntryQuantity>(field.kind))
                table.number(noise_library::quantity_in(entry, field));
            else
                table.word(noise_library::words_in(entry, field));
        }
        for (const auto& [name, unit] : figures)
            table.number(noise_library::number_of(entry, name));
        table.end_row();
    }
    return table.take();
}

}  // namespace stridor::io
