#include "stridor/storage/database.hpp"

#include "stridor/base/error.hpp"
#include "stridor/storage/checked_files.hpp"
#include "stridor/storage/hand_over.hpp"
#include "stridor/storage/new_file.hpp"

#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <system_error>

namespace stridor::storage {

namespace {

constexpr int longest_value = 1 << 28;            // [bytes] of a text; SQLite's own limit is four times as much
constexpr std::size_t most_damages = 100;         // [1] that are told of one file
constexpr std::int64_t lock_place = 0x4000'0000;  // [bytes] of the page that SQLite locks and never writes

// The system's number for the last failure; zero if there was none. A failed commit leaves it only with the file.
int system_number(sqlite3* handle) {
    int number = sqlite3_system_errno(handle);
    if (number == 0) sqlite3_file_control(handle, "main", SQLITE_FCNTL_LAST_ERRNO, &number);
    return number;
}

// SQLite's words say that something failed; the system's say why.
std::string reason(sqlite3* handle, int code) {
    const int primary = code & 0xff;
    if (code == SQLITE_IOERR_DATA) return "a page does not have its checksum";
    if (primary == SQLITE_FULL) return "disk full";
    const bool is_systems = primary == SQLITE_IOERR || primary == SQLITE_CANTOPEN;
    const int number = is_systems && handle != nullptr ? system_number(handle) : 0;
    return number != 0 ? std::generic_category().message(number) : sqlite3_errstr(code);
}

}  // namespace

void Database::Close::operator()(sqlite3* handle) const {
    sqlite3_close(handle);
}

Database::Database(const std::filesystem::path& file, const DatabaseOptions& options)
    : file_(file),
      words_(options.words),
      ownership_(options.ownership),
      confirm_(options.confirm),
      busy_(std::make_unique<Busy>(Busy{options.waiting, options.wait,
                                        "another process, which has the " + options.words.kind + " " + file.string()})),
      files_(options.identity.application_id == 0
                 ? nullptr
                 : std::make_unique<CheckedFiles>(options.identity, options.damage, options.is_ours)) {
    // an absolute path is never one of SQLite's special names (":memory:")
    std::error_code error;
    const std::filesystem::path absolute = std::filesystem::absolute(file, error);
    sqlite3* handle = nullptr;
    const int flags = (options.undoing == Undoing::never ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE) |
                      (options.missing == MissingFile::create ? SQLITE_OPEN_CREATE : 0);
    const int code =
        error ? SQLITE_CANTOPEN : sqlite3_open_v2(absolute.c_str(), &handle, flags, files_ ? files_->name() : nullptr);
    handle_.reset(handle);
    if (code != SQLITE_OK) fail(code);
    sqlite3_extended_result_codes(handle, 1);
    sqlite3_busy_handler(handle, wait_on, busy_.get());
    defend();
    // this does not touch the file, which may not be ours, but looks whether the schema can be read
    if (options.damage == Damage::salvage) return;
    execute(ownership_ == Ownership::alone ? "PRAGMA synchronous = FULL" : "PRAGMA synchronous = EXTRA");
}

int Database::wait_on(void* busy, int times) {
    Busy& of = *static_cast<Busy*>(busy);
    if (times == 0) of.waiting.emplace(of.options, of.longest);
    try {
        return of.waiting->goes_on(of.whom) ? 1 : 0;
    } catch (const Error&) {
        // nothing is thrown through SQLite, which says that it is busy
        return 0;
    }
}

// a file may come from anywhere, and SQLite does what its schema says
void Database::defend() {
    sqlite3* handle = handle_.get();
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
    sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, longest_value);
    sqlite3_limit(handle, SQLITE_LIMIT_ATTACHED, 0);
    sqlite3_limit(handle, SQLITE_LIMIT_TRIGGER_DEPTH, 0);
    execute("PRAGMA cell_size_check = ON");
    execute("PRAGMA mmap_size = 0");
    if (!files_) return;
    // a page that is freed is written, too: every page within the file has a checksum
    execute("PRAGMA secure_delete = ON");
    execute("PRAGMA page_size = " + std::to_string(page_size));
    int reserved = static_cast<int>(checksum_size);
    sqlite3_file_control(handle, "main", SQLITE_FCNTL_RESERVE_BYTES, &reserved);
}

void Database::fail(int code) const {
    const std::string name = file_.string();
    const std::string the_kind = "the " + words_.kind + " " + name;
    const std::string why = reason(handle_.get(), code);
    switch (code == SQLITE_IOERR_DATA ? SQLITE_CORRUPT : code & 0xff) {
        case SQLITE_NOTADB:
            throw Error(ErrorKind::input,
                        {name + " is no " + words_.kind, "it is not an SQLite database", words_.not_ours});
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            if (busy_->options.stop.stop_requested())
                throw Error(ErrorKind::interrupted, {"stopped while it waited for " + busy_->whom,
                                                     "nothing has been changed", "Run the same command again."});
            throw Error(ErrorKind::io, {the_kind + " is in use", "another process has it open", words_.in_use});
        case SQLITE_CORRUPT:
            throw Error(ErrorKind::io, {the_kind + " is damaged", why, words_.damaged});
        case SQLITE_CANTOPEN:
            throw Error(ErrorKind::io, {"cannot open " + the_kind, why, ""});
        case SQLITE_FULL:
            throw Error(ErrorKind::io, {"cannot write " + the_kind, why, "Make room and " + words_.not_written});
        case SQLITE_READONLY:
        case SQLITE_IOERR:
            throw Error(ErrorKind::io, {"cannot write " + the_kind, why, "Mend that and " + words_.not_written});
        default:
            throw Error(ErrorKind::io, {the_kind + " failed", why, ""});
    }
}

bool Database::is_read_only() const {
    return sqlite3_db_readonly(handle_.get(), "main") == 1;
}

void Database::expect_whole() {
    const std::int64_t size = integer("PRAGMA page_count") * integer("PRAGMA page_size");
    std::error_code unknown;
    if (std::filesystem::file_size(file_, unknown) < static_cast<std::uintmax_t>(size))
        throw Error(ErrorKind::io, {"the " + words_.kind + " " + file_.string() + " is damaged", "its end is missing",
                                    words_.damaged});
}

void Database::expect_schema(std::span<const std::string> statements) {
    Statement rows = prepare("SELECT sql FROM sqlite_schema WHERE sql IS NOT NULL AND name NOT LIKE 'sqlite_%'");
    std::vector<std::string> found;
    while (rows.step())
        found.push_back(rows.text(0));
    std::vector<std::string> expected(statements.begin(), statements.end());
    std::sort(found.begin(), found.end());
    std::sort(expected.begin(), expected.end());
    if (found != expected)
        throw Error(ErrorKind::io, {"the " + words_.kind + " " + file_.string() + " is damaged",
                                    "its tables are not those that this program makes", words_.damaged});
}

bool Database::is_new() {
    const bool is_empty = integer("PRAGMA application_id") == 0 && integer("SELECT count(*) FROM sqlite_schema") == 0;
    // another program's empty database has no room for checksums
    return is_empty && (!files_ || files_->are_checked());
}

bool Database::has_moved() const {
    int moved = 0;
    sqlite3_file_control(handle_.get(), "main", SQLITE_FCNTL_HAS_MOVED, &moved);
    return moved != 0;
}

bool Database::is_checked() const {
    return files_ && files_->are_checked();
}

std::vector<std::string> Database::damages() {
    std::vector<std::string> found;
    sqlite3_file* file = nullptr;
    sqlite3_int64 size = 0;
    sqlite3_file_control(handle_.get(), "main", SQLITE_FCNTL_FILE_POINTER, &file);
    file->pMethods->xFileSize(file, &size);
    const auto pages = (size + static_cast<std::int64_t>(page_size) - 1) / static_cast<std::int64_t>(page_size);
    std::array<std::uint8_t, page_size> page{};
    for (std::int64_t number = 1; number <= pages && found.size() < most_damages; ++number) {
        const std::int64_t offset = (number - 1) * static_cast<std::int64_t>(page_size);
        if (offset == lock_place) continue;
        const int code = file->pMethods->xRead(file, page.data(), static_cast<int>(page_size), offset);
        if (!is_checked()) break;
        if (code != SQLITE_OK || !has_checksum(page, static_cast<std::uint32_t>(number)))
            found.push_back("page " + std::to_string(number) + " of " + std::to_string(pages) +
                            " does not have its checksum");
    }
    if (!found.empty()) return found;
    expect_whole();
    Statement findings = prepare("PRAGMA integrity_check");
    while (findings.step())
        if (std::string finding = findings.text(0); finding != "ok") found.push_back(std::move(finding));
    return found;
}

void Database::copy_bytes(const std::filesystem::path& copy) {
    // through SQLite's own file: closing another one of ours would give back its locks
    sqlite3_file* file = nullptr;
    sqlite3_int64 size = 0;
    sqlite3_file_control(handle_.get(), "main", SQLITE_FCNTL_FILE_POINTER, &file);
    file->pMethods->xFileSize(file, &size);
    std::error_code ignored;
    std::filesystem::remove(copy, ignored);
    NewFile written(copy, copy.string());
    std::array<char, page_size> page{};
    for (sqlite3_int64 place = 0; place < size; place += static_cast<sqlite3_int64>(page_size)) {
        const auto count = std::min(size - place, static_cast<sqlite3_int64>(page_size));
        const int code = file->pMethods->xRead(file, page.data(), static_cast<int>(count), place);
        if (code != SQLITE_OK) fail(code);
        written.write({page.data(), static_cast<std::size_t>(count)});
    }
    written.finish();
    written.keep(copy);
}

std::filesystem::path Database::journal() const {
    return sqlite3_filename_journal(sqlite3_db_filename(handle_.get(), "main"));
}

void Database::end_journal() {
    // SQLite lets go of the file and leaves it where it is
    execute("PRAGMA journal_mode = MEMORY");
    std::error_code ignored;
    if (!has_open_change(file_)) std::filesystem::remove(journal(), ignored);
}

void Database::own() {
    if (confirm_) confirm_();
    // it was opened before it was asked whose it is
    if (has_moved())
        throw Error(ErrorKind::io, {"the " + words_.kind + " " + file_.string() + " is no longer this process's",
                                    "another one has taken it over", "Run the same command again."});
    // what SQLite did not have to undo for this lock is a journal whose process died, or could not remove it, after
    // all was written; with the lock it is nobody's. Of an empty database it is our own: the lock's transaction makes
    // the
    // first page
    std::error_code ignored;
    const std::uintmax_t size = std::filesystem::file_size(file_, ignored);
    if (!ignored && size >= page_size) std::filesystem::remove(journal(), ignored);
    // not before the whole lock is ours: a connection in this mode keeps each part of a lock it ever got, and two that
    // begin at once would each keep the part that the other one lacks
    execute("PRAGMA locking_mode = EXCLUSIVE");
    is_owned_ = true;
}

std::int64_t Database::last_row() const {
    return sqlite3_last_insert_rowid(handle_.get());
}

void Database::execute(const std::string& sql) {
    const int code = sqlite3_exec(handle_.get(), sql.c_str(), nullptr, nullptr, nullptr);
    if (code != SQLITE_OK) fail(code);
}

Statement Database::prepare(const std::string& sql) {
    return Statement(*this, sql);
}

std::int64_t Database::integer(const std::string& sql) {
    Statement statement = prepare(sql);
    return statement.step() ? statement.integer(0) : 0;
}

void Statement::Finalize::operator()(sqlite3_stmt* handle) const {
    sqlite3_finalize(handle);
}

Statement::Statement(const Database& database, const std::string& sql) : database_(&database) {
    sqlite3_stmt* handle = nullptr;
    const int code = sqlite3_prepare_v2(database.handle_.get(), sql.c_str(), -1, &handle, nullptr);
    handle_.reset(handle);
    expect_ok(code);
}

void Statement::expect_ok(int code) const {
    if (code != SQLITE_OK) database_->fail(code);
}

void Statement::bind(int parameter, double value) {
    expect_ok(std::isnan(value) ? sqlite3_bind_null(handle_.get(), parameter)
                                : sqlite3_bind_double(handle_.get(), parameter, value));
}

void Statement::bind(int parameter, std::int64_t value) {
    expect_ok(sqlite3_bind_int64(handle_.get(), parameter, value));
}

void Statement::bind(int parameter, std::string_view text) {
    expect_ok(sqlite3_bind_text(handle_.get(), parameter, text.data(), static_cast<int>(text.size()), nullptr));
}

void Statement::bind_null(int parameter) {
    expect_ok(sqlite3_bind_null(handle_.get(), parameter));
}

void Statement::bind_column(int parameter, const Statement& row, int column) {
    expect_ok(sqlite3_bind_value(handle_.get(), parameter, sqlite3_column_value(row.handle_.get(), column)));
}

bool Statement::has_same(const Statement& other, int column) const {
    sqlite3_stmt* const a = handle_.get();
    sqlite3_stmt* const b = other.handle_.get();
    if (sqlite3_column_type(a, column) != sqlite3_column_type(b, column)) return false;
    switch (sqlite3_column_type(a, column)) {
        case SQLITE_INTEGER:
            return sqlite3_column_int64(a, column) == sqlite3_column_int64(b, column);
        case SQLITE_FLOAT:
            return std::bit_cast<std::uint64_t>(sqlite3_column_double(a, column)) ==
                   std::bit_cast<std::uint64_t>(sqlite3_column_double(b, column));
        default:
            return text(column) == other.text(column);
    }
}

bool Statement::step() {
    const int code = sqlite3_step(handle_.get());
    if (code != SQLITE_ROW && code != SQLITE_DONE) database_->fail(code);
    return code == SQLITE_ROW;
}

void Statement::run() {
    step();
    reset();
}

void Statement::reset() {
    expect_ok(sqlite3_reset(handle_.get()));
}

double Statement::number(int column) const {
    const bool is_null = sqlite3_column_type(handle_.get(), column) == SQLITE_NULL;
    return is_null ? std::numeric_limits<double>::quiet_NaN() : sqlite3_column_double(handle_.get(), column);
}

std::int64_t Statement::integer(int column) const {
    return sqlite3_column_int64(handle_.get(), column);
}

std::string Statement::text(int column) const {
    const void* bytes = sqlite3_column_blob(handle_.get(), column);
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(handle_.get(), column));
    return bytes == nullptr ? std::string() : std::string(static_cast<const char*>(bytes), size);
}

Transaction::Transaction(Database& database, Purpose purpose) : database_(database) {
    const bool is_alone = database.ownership() == Ownership::alone;
    database_.execute(is_alone ? "BEGIN EXCLUSIVE" : purpose == Purpose::write ? "BEGIN IMMEDIATE" : "BEGIN");
    if (is_alone && !database_.is_owned_) database_.own();
}

Transaction::~Transaction() {
    // SQLite itself undoes a transaction that met a full disk
    if (is_open_ && sqlite3_get_autocommit(database_.handle_.get()) == 0)
        sqlite3_exec(database_.handle_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void Transaction::commit() {
    database_.execute("COMMIT");
    is_open_ = false;
}

}  // namespace stridor::storage
