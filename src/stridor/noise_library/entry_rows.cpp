#include "stridor/noise_library/entry_rows.hpp"

#include "stridor/noise_library/field.hpp"
#include "stridor/noise_library/library_file.hpp"
#include "stridor/noise_library/query.hpp"

#include <algorithm>
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
    for (const EntryField& field : fields()) {
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
    for (const EntryField& field : fields()) {
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

std::vector<std::string> table_statements() {
    std::string columns;
    for (const EntryField& field : fields())
        if (!is_document(field)) columns += ", " + column_of(field);
    return {// ids are never used twice, so that a note about entry 12 stays true
            "CREATE TABLE entry(id INTEGER PRIMARY KEY AUTOINCREMENT, digest TEXT NOT NULL" + columns + ")",
            "CREATE INDEX entry_digest ON entry(digest)", "CREATE INDEX entry_audio ON entry(audio)",
            // apart from the rows that every search goes through
            "CREATE TABLE document(entry INTEGER NOT NULL, name TEXT NOT NULL, text TEXT NOT NULL, "
            "PRIMARY KEY(entry, name)) WITHOUT ROWID",
            "CREATE TABLE figure(entry INTEGER NOT NULL, name TEXT NOT NULL, unit TEXT NOT NULL, value, "
            "PRIMARY KEY(entry, name)) WITHOUT ROWID",
            "CREATE INDEX figure_name ON figure(name)"};
}

void create_tables(Database& database) {
    database.execute("PRAGMA application_id = " + std::to_string(library_identity.application_id));
    database.execute("PRAGMA user_version = " + std::to_string(library_schema));
    for (const std::string& statement : table_statements())
        database.execute(statement);
}

std::vector<std::int64_t> entry_ids(Database& database) {
    std::vector<std::int64_t> ids;
    Statement rows = database.prepare("SELECT id FROM entry ORDER BY id");
    while (rows.step())
        ids.push_back(rows.integer(0));
    return ids;
}

KeptEntry read_entry(Database& database, std::int64_t id) {
    KeptEntry kept;
    Statement row = database.prepare("SELECT " + columns() + ", e.digest FROM entry e WHERE e.id = ?");
    row.bind(1, id);
    if (!row.step()) return kept;
    kept.entry = entry_in(row);
    const auto last =
        std::count_if(fields().begin(), fields().end(), [](const EntryField& f) { return !is_document(f); });
    kept.digest = row.text(static_cast<int>(last) + 1);
    Statement documents = database.prepare("SELECT name, text FROM document WHERE entry = ?");
    documents.bind(1, id);
    while (documents.step())
        if (const EntryField* field = find_field(documents.text(0)); field != nullptr && is_document(*field))
            words_in(kept.entry, *field) = documents.text(1);
    Statement figures = database.prepare("SELECT name, unit, value FROM figure WHERE entry = ? ORDER BY name");
    figures.bind(1, id);
    while (figures.step())
        kept.entry.figures.push_back({figures.text(0), figures.text(1), figures.number(2)});
    return kept;
}

bool is_sound(const KeptEntry& kept) {
    return kept.entry.id != 0 && digest(kept.entry) == kept.digest;
}

std::int64_t write_entry(Database& database, const Entry& entry) {
    const bool has_id = entry.id != 0;
    const std::string text = digest(entry);
    Statement row = database.prepare(insert_entry(has_id));
    int parameter = 0;
    if (has_id) row.bind(++parameter, entry.id);
    row.bind(++parameter, std::string_view(text));
    for (const EntryField& field : fields())
        if (is_document(field))
            continue;
        else if (std::holds_alternative<EntryQuantity>(field.kind))
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
