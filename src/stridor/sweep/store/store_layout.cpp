#include "stridor/sweep/store/store_layout.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/version.hpp"
#include "stridor/storage/hand_over.hpp"
#include "stridor/sweep/results_version.hpp"
#include "stridor/sweep/starts.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

namespace stridor::sweep {

using storage::Statement;

namespace {

constexpr int fixed_columns = 6;  // id, status, category, quiet_because, message, starts

const char* const other_out = "Choose another --out, or remove the file to start anew.";
const char* const compute_anew = "Remove the file: the same command computes the same cells anew.";

// for one who begins at the same moment to get the lock or to let go of it, which takes milliseconds
constexpr std::chrono::milliseconds longest_wait{250};

constexpr const char* create_meta_table = "CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID";

std::string create_cell_table() {
    std::string sql =
        "CREATE TABLE cell(id INTEGER PRIMARY KEY, status TEXT NOT NULL, category TEXT, quiet_because TEXT, message "
        "TEXT NOT "
        "NULL, "
        "starts TEXT NOT NULL";
    // no REAL here: such a column turns whole numbers into integers on disk and loses the sign of -0
    for (const CellFigure& figure : cell_figures())
        sql += ", " + std::string(figure.name);
    return sql + ")";
}

struct KeyLine {
    std::string_view key;
    std::string_view text;
};

std::vector<KeyLine> lines_of(std::string_view text) {
    std::vector<KeyLine> lines;
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        lines.push_back({line.substr(0, line.find(" = ")), line});
        text.remove_prefix(std::min(text.size(), line.size() + 1));
    }
    return lines;
}

const KeyLine* find_key(const std::vector<KeyLine>& lines, std::string_view key) {
    const auto found = std::find_if(lines.begin(), lines.end(), [&](const KeyLine& line) { return line.key == key; });
    return found == lines.end() ? nullptr : &*found;
}

// where two studies part, in words: "the store holds contact.static_friction = 0.8, the file says 0.7"
std::string difference(const std::string& stored, const std::string& wanted) {
    const std::vector<KeyLine> there = lines_of(stored);
    const std::vector<KeyLine> here = lines_of(wanted);
    for (const KeyLine& line : here) {
        const KeyLine* other = find_key(there, line.key);
        if (other == nullptr) return "the file says " + std::string(line.text) + ", which the store does not hold";
        if (other->text != line.text)
            return "the store holds " + std::string(other->text) + ", the file says " +
                   std::string(line.text.substr(std::min(line.text.size(), line.key.size() + 3)));
    }
    for (const KeyLine& line : there)
        if (find_key(here, line.key) == nullptr)
            return "the store holds " + std::string(line.text) + ", which the file does not say";
    return "its lines stand in another order";
}

constexpr std::string_view sticks = classification::name(classification::Quiet::sticks);

// the verdicts of all starts, "none squeal failed"; one that sticks is worse than one that slides, and told apart
std::string words(std::span<const StartVerdict> starts) {
    std::string text;
    for (const StartVerdict& verdict : starts)
        text += (text.empty() ? "" : " ") +
                std::string(verdict.quiet == classification::Quiet::sticks ? sticks : word(verdict));
    return text;
}

// nothing if a word is no verdict
std::optional<std::vector<StartVerdict>> starts_in(const std::string& text) {
    std::vector<StartVerdict> starts;
    std::istringstream stream(text);
    for (std::string each; stream >> each;) {
        if (each == sticks) {
            starts.push_back({Status::done, classification::Category::none, classification::Quiet::sticks});
            continue;
        }
        const std::optional<std::size_t> number = place_in(verdict_words, each);
        if (!number) return std::nullopt;
        starts.push_back(verdict_of(*number));
    }
    return starts;
}

std::string meta(storage::Database& database, std::string_view key) {
    Statement query = database.prepare("SELECT value FROM meta WHERE key = ?");
    query.bind(1, key);
    return query.step() ? query.text(0) : std::string();
}

}  // namespace

storage::DatabaseOptions store_options() {
    storage::DatabaseOptions options;
    options.words = {"store", "Choose another --out, or remove the file.",
                     "Wait until that ends, or choose another --out.", compute_anew,
                     "run the same command again: it goes on from what is saved."};
    options.identity = store_identity;
    options.wait = longest_wait;
    return options;
}

storage::OwnerOptions owner_options(const std::filesystem::path& store) {
    storage::OwnerOptions options;
    options.shown = "the store " + store.string();
    return options;
}

void take_over_files(storage::OwnerFile& owner, const std::filesystem::path& store) {
    // one that is left to the lock is not claimed yet
    if (!owner.is_claimed()) return;
    storage::remove_unfinished(store, owner.mark());
    if (owner.may_be_in_other_hands())
        storage::hand_over(store, owner.mark(), store_options(), [&] { owner.begin_change(); });
    owner.settle();
}

std::string cell_columns(std::span<const CellFigure> figures) {
    std::string columns = "id, status, category, quiet_because, message, starts";
    for (const CellFigure& figure : figures)
        columns += ", " + std::string(figure.name);
    return columns;
}

std::size_t cell_columns_count() {
    return fixed_columns + cell_figures().size();
}

std::string insert_cell() {
    std::string sql = "INSERT OR REPLACE INTO cell(" + cell_columns() + ") VALUES(?, ?, ?, ?, ?, ?";
    for (std::size_t k = 0; k < cell_figures().size(); ++k)
        sql += ", ?";
    return sql + ")";
}

void insert(Statement& statement, const IndexedCell& indexed) {
    const Cell& cell = indexed.cell;
    const std::string starts = words(cell.starts);
    statement.bind(1, static_cast<std::int64_t>(indexed.index));
    statement.bind(2, status_names[static_cast<std::size_t>(cell.status)]);
    if (cell.status == Status::done)
        statement.bind(3, classification::name(cell.category));
    else
        statement.bind_null(3);
    if (cell.quiet == classification::Quiet::no)
        statement.bind_null(4);
    else
        statement.bind(4, classification::name(cell.quiet));
    statement.bind(5, std::string_view(cell.message));
    statement.bind(6, std::string_view(starts));
    int parameter = fixed_columns;
    for (const CellFigure& figure : cell_figures())
        statement.bind(++parameter, figure_of(cell, figure));
    statement.run();
}

std::optional<IndexedCell> cell_in(const Statement& row, std::size_t cells, std::span<const CellFigure> figures) {
    const std::optional<std::size_t> status = place_in(status_names, row.text(1));
    const std::optional<std::size_t> category = place_in(classification::category_names, row.text(2));
    const bool is_inside = row.integer(0) >= 0 && static_cast<std::size_t>(row.integer(0)) < cells;
    if (!is_inside || !status) return std::nullopt;
    IndexedCell indexed;
    indexed.index = static_cast<std::size_t>(row.integer(0));
    Cell& cell = indexed.cell;
    cell.status = static_cast<Status>(*status);
    if (cell.status == Status::done && !category) return std::nullopt;
    if (category) cell.category = static_cast<classification::Category>(*category);
    if (const std::optional<std::size_t> quiet = place_in(classification::quiet_names, row.text(3)))
        cell.quiet = static_cast<classification::Quiet>(*quiet);
    const bool is_none = cell.status == Status::done && cell.category == classification::Category::none;
    if (is_none != (cell.quiet != classification::Quiet::no)) return std::nullopt;
    cell.message = row.text(4);
    std::optional<std::vector<StartVerdict>> starts = starts_in(row.text(5));
    if (!starts) return std::nullopt;
    cell.agreement = agreement(*starts);
    cell.starts = std::move(*starts);
    int column = fixed_columns;
    for (const CellFigure& figure : figures)
        set_figure(cell, figure, row.number(column++));
    return indexed;
}

Error no_cell_of_the_study(const std::filesystem::path& store, std::int64_t index) {
    return Error(ErrorKind::io, {"the store " + store.string() + " is damaged",
                                 "cell " + std::to_string(index) + " is none of this study", compute_anew});
}

void create_tables(storage::Database& database, const std::string& study_text) {
    database.execute("PRAGMA application_id = " + std::to_string(store_identity.application_id));
    database.execute("PRAGMA user_version = " + std::to_string(store_schema));
    database.execute(create_meta_table);
    database.execute(create_cell_table());
    const std::pair<std::string, std::string> entries[] = {{"study", study_text},
                                                           {"results", std::to_string(results_version)},
                                                           {"program", std::string(base::version())},
                                                           {"commit", std::string(base::commit())}};
    Statement insert = database.prepare("INSERT INTO meta(key, value) VALUES(?, ?)");
    for (const auto& [key, value] : entries) {
        insert.bind(1, std::string_view(key));
        insert.bind(2, std::string_view(value));
        insert.run();
    }
}

void verify_tables(storage::Database& database, const std::string& study_text) {
    const std::string name = database.file().string();
    if (database.integer("PRAGMA application_id") != store_identity.application_id)
        throw Error(ErrorKind::input, {name + " is no store of a sweep", "it is another program's SQLite database",
                                       "Choose another --out, or remove the file."});
    const std::int64_t schema = database.integer("PRAGMA user_version");
    if (schema != store_schema)
        throw Error(ErrorKind::input,
                    {"the store " + name + " has schema " + std::to_string(schema),
                     "this program reads and writes schema " + std::to_string(store_schema), other_out});
    database.expect_whole();
    database.expect_schema(std::array{std::string(create_meta_table), create_cell_table()});
    const std::string stored = meta(database, "study");
    if (stored != study_text)
        throw Error(ErrorKind::input,
                    {"the store " + name + " belongs to another study", difference(stored, study_text), other_out});
    const std::string results = meta(database, "results");
    if (results != std::to_string(results_version))
        throw Error(ErrorKind::input, {"the store " + name + " was begun by stridor " + meta(database, "program"),
                                       "its numbers are of generation " + results + ", this program's of " +
                                           std::to_string(results_version) + ", and the two do not mix",
                                       other_out});
}

}  // namespace stridor::sweep
