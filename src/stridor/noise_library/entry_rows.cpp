#include "stridor/noise_library/entry_rows.hpp"

#include "stridor/noise_library/field.hpp"
#include "stridor/noise_library/selection.hpp"

#include <string>
#include <string_view>
#include <variant>

namespace stridor::noise_library {

using storage::Database;
using storage::Statement;

namespace {

std::string insert_entry(bool has_id) {
    std::string columns = has_id ? "id, digest" : "digest";
    std::string values = has_id ? "?, ?" : "?";
    for (const Field& field : fields()) {
        if (is_document(field)) continue;
        columns += ", " + column_of(field);
        values += ", ?";
    }
    return (has_id ? "INSERT OR REPLACE" : "INSERT") + (" INTO entry(" + columns) + ") VALUES(" + values + ")";
}

void forget_parts(Database& database, std::int64_t id) {
    for (const char* table : {"document", "figure"})
        database.execute("DELETE FROM " + std::string(table) + " WHERE entry = " + std::to_string(id));
}

void write_documents(Database& database, std::int64_t id, const Entry& entry) {
    Statement document = database.prepare("INSERT INTO document(entry, name, text) VALUES(?, ?, ?)");
    for (const Field& field : fields()) {
        if (!is_document(field) || words_in(entry, field).empty()) continue;
        document.bind(1, id);
        document.bind(2, field.name);
        document.bind(3, std::string_view(words_in(entry, field)));
        document.run();
    }
}

void write_figures(Database& database, std::int64_t id, const Entry& entry) {
    Statement value = database.prepare("INSERT INTO figure(entry, name, unit, value) VALUES(?, ?, ?, ?)");
    for (const Figure& figure : entry.figures) {
        value.bind(1, id);
        value.bind(2, std::string_view(figure.name));
        value.bind(3, std::string_view(figure.unit));
        value.bind(4, figure.value);
        value.run();
    }
}

}  // namespace

void create_tables(Database& database) {
    std::string columns;
    for (const Field& field : fields())
        if (!is_document(field)) columns += ", " + column_of(field);
    // ids are never used twice, so that a note about entry 12 stays true
    database.execute("CREATE TABLE entry(id INTEGER PRIMARY KEY AUTOINCREMENT, digest TEXT NOT NULL" + columns + ")");
    database.execute("CREATE INDEX entry_digest ON entry(digest)");
    database.execute("CREATE INDEX entry_audio ON entry(audio)");
    // apart from the rows that every search goes through
    database.execute(
        "CREATE TABLE document(entry INTEGER NOT NULL, name TEXT NOT NULL, text TEXT NOT NULL, "
        "PRIMARY KEY(entry, name)) WITHOUT ROWID");
    database.execute(
        "CREATE TABLE figure(entry INTEGER NOT NULL, name TEXT NOT NULL, unit TEXT NOT NULL, value, "
        "PRIMARY KEY(entry, name)) WITHOUT ROWID");
    database.execute("CREATE INDEX figure_name ON figure(name)");
}

std::int64_t write_entry(Database& database, const Entry& entry) {
    const bool has_id = entry.id != 0;
    const std::string text = digest(entry);
    Statement row = database.prepare(insert_entry(has_id));
    int parameter = 0;
    if (has_id) row.bind(++parameter, entry.id);
    row.bind(++parameter, std::string_view(text));
    for (const Field& field : fields())
        if (is_document(field))
            continue;
        else if (std::holds_alternative<Quantity>(field.kind))
            row.bind(++parameter, quantity_in(entry, field));
        else
            row.bind(++parameter, std::string_view(words_in(entry, field)));
    row.run();
    const std::int64_t id = has_id ? entry.id : database.last_row();
    if (has_id) forget_parts(database, id);
    write_documents(database, id, entry);
    write_figures(database, id, entry);
    return id;
}

void remove_entry(Database& database, std::int64_t id) {
    database.execute("DELETE FROM entry WHERE id = " + std::to_string(id));
    forget_parts(database, id);
}

}  // namespace stridor::noise_library
