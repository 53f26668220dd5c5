#include "stridor/sweep/database.hpp"

#include "stridor/base/error.hpp"

#include <sqlite3.h>

#include <cmath>
#include <limits>
#include <system_error>

namespace stridor::sweep {

namespace {

// The system's number for the last failure; zero if there was none. A failed commit leaves it only with the file.
int system_number(sqlite3* handle) {
    int number = sqlite3_system_errno(handle);
    if (number == 0) sqlite3_file_control(handle, "main", SQLITE_FCNTL_LAST_ERRNO, &number);
    return number;
}

// SQLite's words say that something failed; the system's say why.
std::string reason(sqlite3* handle, int code) {
    const int primary = code & 0xff;
    if (primary == SQLITE_FULL) return "disk full";
    const bool is_systems = primary == SQLITE_IOERR || primary == SQLITE_CANTOPEN;
    const int number = is_systems && handle != nullptr ? system_number(handle) : 0;
    return number != 0 ? std::generic_category().message(number) : sqlite3_errstr(code);
}

}  // namespace

void Database::Close::operator()(sqlite3* handle) const {
    sqlite3_close(handle);
}

Database::Database(const std::filesystem::path& file) : file_(file) {
    // an absolute path is never one of SQLite's special names (":memory:")
    std::error_code error;
    const std::filesystem::path absolute = std::filesystem::absolute(file, error);
    sqlite3* handle = nullptr;
    const int code =
        error ? SQLITE_CANTOPEN
              : sqlite3_open_v2(absolute.c_str(), &handle, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
    handle_.reset(handle);
    if (code != SQLITE_OK) fail(code);
    sqlite3_extended_result_codes(handle, 1);
    // neither touches the file, which may not be ours
    execute("PRAGMA locking_mode = EXCLUSIVE");
    execute("PRAGMA synchronous = FULL");
}

void Database::fail(int code) const {
    const std::string name = file_.string();
    const std::string why = reason(handle_.get(), code);
    switch (code & 0xff) {
        case SQLITE_NOTADB:
            throw Error(ErrorKind::input, {name + " is no store", "it is not an SQLite database",
                                           "Choose another --out, or remove the file."});
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            throw Error(ErrorKind::io, {"the store " + name + " is in use", "another process has it open",
                                        "Wait until that ends, or choose another --out."});
        case SQLITE_CORRUPT:
            throw Error(ErrorKind::io, {"the store " + name + " is damaged", why,
                                        "Choose another --out, or remove the file to start anew."});
        case SQLITE_CANTOPEN:
            throw Error(ErrorKind::io, {"cannot open the store " + name, why, ""});
        case SQLITE_FULL:
            throw Error(ErrorKind::io, {"cannot write the store " + name, why,
                                        "Make room and run the same command again: it goes on from what is saved."});
        case SQLITE_READONLY:
        case SQLITE_IOERR:
            throw Error(ErrorKind::io, {"cannot write the store " + name, why,
                                        "Mend that and run the same command again: it goes on from what is saved."});
        default:
            throw Error(ErrorKind::io, {"the store " + name + " failed", why, ""});
    }
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

bool Statement::step() {
    const int code = sqlite3_step(handle_.get());
    if (code != SQLITE_ROW && code != SQLITE_DONE) database_->fail(code);
    return code == SQLITE_ROW;
}

void Statement::run() {
    step();
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

Transaction::Transaction(Database& database) : database_(database) {
    database_.execute("BEGIN EXCLUSIVE");
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

}  // namespace stridor::sweep
