#pragma once

#include "stridor/storage/checked_files.hpp"
#include "stridor/storage/waiting.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace stridor::storage {

class Statement;

/// The words of messages about a database, and the remedies that they offer.
struct Words {
    std::string kind = "database";  // "store", "library"
    std::string not_ours{};         // the file is something else
    std::string in_use{};           // another process has it open
    std::string damaged{};
    std::string not_written{};  // after "Make room and " or "Mend that and "
};

/// Who owns the file while it is open.
///
/// `alone`: the first `Transaction` takes the lock, which is kept until the database is closed. A second process is
/// refused and can never change the file between two transactions. Of several that begin at once one gets the lock, if
/// they wait long enough. `shared`: the lock lasts as long as a transaction, and others wait for it.
enum class Ownership { alone, shared };

/// What happens if the file does not exist.
enum class MissingFile { create, refuse };

/// Whether reading a database may change it to undo an interrupted change.
enum class Undoing { allowed, never };

/// How a database is opened.
struct DatabaseOptions {
    Words words{};
    Identity identity{};
    Damage damage = Damage::refuse;
    Ownership ownership = Ownership::alone;
    MissingFile missing = MissingFile::create;
    Undoing undoing = Undoing::allowed;
    std::chrono::milliseconds wait{0};  // for a lock that another process holds
    WaitOptions waiting{};              // how to wait for it
    std::function<void()> confirm{};    // called once the lock that is kept has been got; may throw
    std::function<bool()> is_ours{};    // asked before a journal is written or removed (`CheckedFiles`)
};

/// An SQLite database in one file.
///
/// A process that dies at any moment leaves the last committed transaction: the next one that opens the file undoes the
/// rollback journal. Every failure throws `Error`: input for a file of another kind, io with the reason for the rest. A
/// file without write permission is opened for reading.
///
/// A database with an identity has checksums (`CheckedFiles`): it is read exactly as it was written, or an `Error` (io)
/// is thrown. Triggers and views never run, whatever the file holds.
class Database {
public:
    /// Opens the file, or makes an empty one; reads nothing yet.
    explicit Database(const std::filesystem::path& file, const DatabaseOptions& options);

    /// Returns the path of the file.
    const std::filesystem::path& file() const { return file_; }
    /// Returns whether others may use it meanwhile.
    Ownership ownership() const { return ownership_; }

    /// Says whether this process may only read it.
    bool is_read_only() const;

    /// Throws `Error` (io) if the file is shorter than it states: SQLite would read the missing end as zeros.
    void expect_whole();

    /// Throws `Error` (io) if the file holds other tables, indices, triggers or views than these statements make.
    void expect_schema(std::span<const std::string> statements);

    /// Says whether the database is still empty, without even an identity.
    bool is_new();

    /// Says whether another file has taken its name since it was opened.
    bool has_moved() const;

    /// Says whether its pages are checked. Known once something was read.
    bool is_checked() const;

    /// Returns the damages in words: the first hundred pages that are not as they were written, or else SQLite's own
    /// findings on the structure; empty for a sound file. Needs a transaction.
    std::vector<std::string> damages();

    /// Writes the bytes of the file, as they stand, to another file.
    void copy_bytes(const std::filesystem::path& copy);

    /// Removes the journal of a database that this process owns alone, as SQLite would do on closing. Call it while the
    /// file still belongs to this process. Later changes would not survive a kill.
    void end_journal();

    /// Returns the key of the row that was inserted last.
    std::int64_t last_row() const;

    /// Runs statements that return no rows.
    void execute(const std::string& sql);
    /// Prepares one statement, which may run many times.
    Statement prepare(const std::string& sql);

    /// Returns the single integer of a query such as "PRAGMA user_version".
    std::int64_t integer(const std::string& sql);

private:
    friend class Statement;
    friend class Transaction;

    // a wait for the lock, as SQLite asks how it goes on
    struct Busy {
        WaitOptions options;
        std::chrono::milliseconds longest;
        std::string whom;
        std::optional<Waiting> waiting{};
    };
    static int wait_on(void* busy, int times);

    struct Close {
        void operator()(sqlite3* handle) const;
    };

    [[noreturn]] void fail(int code) const;
    void defend();
    void own();
    std::filesystem::path journal() const;

    std::filesystem::path file_;
    Words words_;
    Ownership ownership_;
    std::function<void()> confirm_;
    std::unique_ptr<Busy> busy_;
    std::unique_ptr<CheckedFiles> files_;  // null for a database without identity
    bool is_owned_ = false;                // the lock that is kept has been got
    std::unique_ptr<sqlite3, Close> handle_;
};

/// A prepared statement: bind, step until there is no row, reset. Parameters count from 1, columns from 0.
///
/// Must end before its database. A NaN is kept as NULL, every other number bit for bit.
class Statement {
public:
    /// Binds a number to a parameter, counted from 1. Throws `Error`, as all of these, if SQLite refuses it.
    void bind(int parameter, double value);
    /// Binds a whole number to a parameter.
    void bind(int parameter, std::int64_t value);
    /// Binds text to a parameter.
    void bind(int parameter, std::string_view text);  // must live until the next `reset`
    /// Binds NULL to a parameter.
    void bind_null(int parameter);

    /// Binds the value in a column of another statement's row to a parameter, bit for bit.
    void bind_column(int parameter, const Statement& row, int column);

    /// Goes to the next row; returns false if there is none.
    bool step();

    /// Runs a statement that returns no rows, and makes it ready for the next values.
    void run();

    /// Ends the rows, read or not, and makes the statement ready for the next values.
    void reset();

    /// Returns the number in a column of the row, counted from 0; NaN for NULL.
    double number(int column) const;
    /// Returns the whole number in a column of the row; 0 for NULL.
    std::int64_t integer(int column) const;
    /// Returns the text in a column of the row.
    std::string text(int column) const;  // empty for NULL

    /// Says whether the column holds the same value in another statement's row, bit for bit.
    bool has_same(const Statement& other, int column) const;

private:
    friend class Database;

    struct Finalize {
        void operator()(sqlite3_stmt* handle) const;
    };

    Statement(const Database& database, const std::string& sql);
    void expect_ok(int code) const;

    const Database* database_;
    std::unique_ptr<sqlite3_stmt, Finalize> handle_;
};

/// A change of all or nothing: without `commit` it is undone at the end of its scope.
///
/// Both kinds see one state of the database from their first statement on; only one process at a time may write.
class Transaction {
public:
    /// Whether it writes or only reads.
    enum class Purpose { write, read };

    /// Begins. Throws `Error` (io) if another process keeps the lock for too long.
    explicit Transaction(Database& database, Purpose purpose = Purpose::write);
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;

    /// Keeps what was written. Throws `Error` (io) if that fails.
    void commit();

private:
    Database& database_;
    bool is_open_ = true;
};

}  // namespace stridor::storage
