#include "stridor/noise_library/library_file.hpp"

#include "stridor/base/error.hpp"
#include "stridor/noise_library/entry_rows.hpp"
#include "stridor/storage/system_io.hpp"

#include <algorithm>
#include <system_error>
#include <vector>

namespace stridor::noise_library {

namespace fs = std::filesystem;

namespace {

void remove_database(const fs::path& file) {
    std::error_code ignored;  // what is in the way is met again when the file is made
    fs::remove(file.string() + "-journal", ignored);
    fs::remove(file, ignored);
}

storage::DatabaseOptions replacement_options(const fs::path& library) {
    storage::DatabaseOptions options = database_options(library, {Access::fill});
    options.ownership = storage::Ownership::alone;
    return options;
}

}  // namespace

Replacement::Replacement(const fs::path& library) {
    std::error_code error;
    // the file itself, not a link to it
    library_ = fs::is_symlink(library, error) ? fs::weakly_canonical(library, error) : library;
    file_ = library_.string() + ".new";
    remove_database(file_);
    database_.emplace(file_, replacement_options(library));
    transaction_.emplace(*database_);
    create_tables(*database_);
}

Replacement::~Replacement() {
    transaction_.reset();
    database_.reset();
    if (!file_.empty()) remove_database(file_);
}

std::int64_t Replacement::write(const Entry& entry) {
    return write_entry(*database_, entry);
}

void Replacement::reserve(std::int64_t last_id) {
    // SQLite keeps the number of a table that has had a row
    const std::int64_t known = database_->integer("SELECT seq FROM sqlite_sequence WHERE name = 'entry'");
    database_->execute("DELETE FROM sqlite_sequence WHERE name = 'entry'");
    database_->execute("INSERT INTO sqlite_sequence(name, seq) VALUES('entry', " +
                       std::to_string(std::max(known, last_id)) + ")");
}

void Replacement::keep() {
    transaction_->commit();
    transaction_.reset();
    database_.reset();
    std::error_code error;
    const fs::perms permissions = fs::status(library_, error).permissions();
    if (!error) fs::permissions(file_, permissions, error);
    if (!error) fs::rename(file_, library_, error);
    if (error) throw storage::system_failure("write", library_.string(), error.value());
    file_.clear();
    storage::flush_folder(library_.parent_path(), library_.string());
}

using storage::Database;
using storage::Transaction;

namespace {

constexpr int unchecked_schema = 1;

void make(Database& database) {
    if (!database.is_new()) return;
    Transaction transaction(database);
    // another process may have made it in between
    if (database.is_new()) create_tables(database);
    transaction.commit();
}

// what a newer or another program's file is refused for
void expect_ours(Database& database) {
    const Transaction transaction(database, Transaction::Purpose::read);
    const std::string name = database.file().string();
    if (database.integer("PRAGMA application_id") != library_identity.application_id)
        throw Error(ErrorKind::input, {name + " is no noise library", "it is another program's SQLite database",
                                       "Choose another --library."});
    const std::int64_t schema = database.integer("PRAGMA user_version");
    if (schema != library_schema && schema != unchecked_schema)
        throw Error(ErrorKind::input,
                    {"the library " + name + " has schema " + std::to_string(schema),
                     "this program reads and writes schema " + std::to_string(library_schema),
                     schema > library_schema ? "Use the newer program that wrote it." : "Choose another --library."});
    database.expect_whole();
    database.expect_schema(table_statements());
}

[[noreturn]] void refuse_damaged(const Database& database, const std::string& why) {
    throw Error(ErrorKind::io, {"the library " + database.file().string() + " is damaged", why,
                                "`stridor library check --repair` saves what can be read."});
}

// each entry has had a digest of its own from the first layout on
void rewrite(Database& old) {
    Replacement replacement(old.file());
    for (const std::int64_t id : entry_ids(old)) {
        const KeptEntry kept = read_entry(old, id);
        if (!is_sound(kept)) refuse_damaged(old, "entry " + std::to_string(id) + " is not what was written");
        replacement.write(kept.entry);
    }
    replacement.reserve(old.integer("SELECT seq FROM sqlite_sequence WHERE name = 'entry'"));
    replacement.keep();
}

// looks at everything
void expect_undamaged(Database& database) {
    const Transaction snapshot(database, Transaction::Purpose::read);
    if (const std::vector<std::string> damages = database.damages(); !damages.empty())
        refuse_damaged(database, damages.front());
    for (const std::int64_t id : entry_ids(database))
        if (!is_sound(read_entry(database, id)))
            refuse_damaged(database, "entry " + std::to_string(id) + " is not what was written");
}

// Is there a rollback journal? That of a living process, or of a dead one, which SQLite then undoes.
bool has_journal(const fs::path& file) {
    std::error_code error;
    return fs::exists(file.string() + "-journal", error);
}

// false where it cannot be written
bool bring_up_to_date(Database& old) {
    if (old.is_read_only()) return false;
    expect_undamaged(old);
    const Transaction lock(old);
    // another process may have done it in between
    if (!old.has_moved()) rewrite(old);
    return true;
}

}  // namespace

fs::path audio_folder_of(const fs::path& file) {
    std::error_code error;
    fs::path real = fs::is_symlink(file, error) ? fs::weakly_canonical(file, error) : file;
    if (real.extension() == ".audio")
        throw Error(ErrorKind::input, {file.string() + " cannot be a library", "its audio needs a folder of that name",
                                       "Call it library.sqlite."});
    return real.replace_extension(".audio");
}

storage::DatabaseOptions database_options(const fs::path& file, const LibraryOptions& options) {
    storage::DatabaseOptions database;
    database.words = {"library", "Choose another --library.", "Wait until that ends, and run the same command again.",
                      "`stridor library check --repair` saves what can be read; --repair ARCHIVE brings back the rest.",
                      "run the same command again: nothing was changed."};
    database.identity = library_identity;
    database.ownership = storage::Ownership::shared;
    database.missing = options.access == Access::fill ? storage::MissingFile::create : storage::MissingFile::refuse;
    database.wait = options.wait;
    database.waiting = options.waiting;
    std::error_code error;
    if (options.access == Access::read && !fs::exists(file, error))
        throw Error(ErrorKind::io,
                    {"there is no library " + file.string(), error ? error.message() : "",
                     "Add a first recording with `stridor library add FILE`, or name another --library."});
    return database;
}

Database open_database(const fs::path& file, const LibraryOptions& options) {
    // a journal's own parts have no checksums of ours: after a change was undone by it, all is looked at
    const bool was_interrupted = has_journal(file);
    {
        Database database(file, database_options(file, options));
        make(database);
        expect_ours(database);
        if (was_interrupted) expect_undamaged(database);
        const bool is_old = database.integer("PRAGMA user_version") == unchecked_schema;
        if (!is_old || !bring_up_to_date(database)) return database;
    }
    Database database(file, database_options(file, options));
    expect_ours(database);
    return database;
}

}  // namespace stridor::noise_library
