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

/// How messages speak of a database, and the ways out that they offer.
struct Words {
    std::string kind = "database";  // "store", "library"
    std::string not_ours{};         // the file is something else
    std::string in_use{};           // another process has it
    std::string damaged{};
    std::string not_written{};  // after "Make room and " or "Mend that and "
};

/// Whose the file is while it is open.
///
/// `alone`: the lock is taken by the first `Transaction` and kept until the database is closed, so that a second
/// process is refused and can never change the file between two transactions; of several that begin at once one gets
/// it, if they wait longer than a lock takes to be got. `shared`: the lock lasts as long as a transaction, and others
/// wait for it.
enum class Ownership { alone, shared };

/// What becomes of a file that is not there.
enum class MissingFile { create, refuse };

/// May a database that is read be changed for that, where an interrupted change is to be undone?
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
    WaitOptions waiting{};              // meanwhile
    std::function<void()> confirm{};    // called once the lock that is kept has been got; may throw
    std::function<bool()> is_ours{};    // asked before a journal is written or removed (`CheckedFiles`)
};

/// An SQLite database in one file.
///
/// A process that dies at any moment leaves the last committed transaction: its rollback journal is undone by the next
/// one that opens the file. Every failure throws `Error`: input for a file of another kind, io with the reason for the
/// rest. A file that may not be written is opened for reading.
///
/// One with an identity has checksums (`CheckedFiles`): what was read is what was written, or an `Error` (io).
/// Triggers and views never run, whatever the file holds.
class Database {
public:
    /// Opens the file, or makes an empty one; nothing is read yet.
    explicit Database(const std::filesystem::path& file, const DatabaseOptions& options);

    /// Where it stands.
    const std::filesystem::path& file() const { return file_; }
    /// May others use it meanwhile?
    Ownership ownership() const { return ownership_; }

    /// May this process only read it?
    bool is_read_only() const;

    /// Throws `Error` (io) if the file is shorter than it says: SQLite would read the missing end as zeros.
    void expect_whole();

    /// Throws `Error` (io) if the file holds other tables, indices, triggers or views than those that these statements
    /// make.
    void expect_schema(std::span<const std::string> statements);

    /// Is nothing in it yet, not even what it is?
    bool is_new();

    /// Has another file taken its name since it was opened?
    bool has_moved() const;

    /// Are its pages checked? Known once something was read.
    bool is_checked() const;

    /// The pages that are not what was written, the first hundred of them, or else SQLite's own findings on how they
    /// hang together, in words; empty for a sound file. Needs a transaction.
    std::vector<std::string> damages();

    /// Writes the bytes of the file, as they stand, into another one.
    void copy_bytes(const std::filesystem::path& copy);

    /// Removes the journal of a database that this process has alone, which SQLite would do when it is closed: to be
    /// called while the file is still this process's. Changes after that would not survive a kill.
    void end_journal();

    /// The key of the row that was inserted last.
    std::int64_t last_row() const;

    /// Runs statements that give no rows.
    void execute(const std::string& sql);
    /// Makes one statement ready to be run, many times if need be.
    Statement prepare(const std::string& sql);

    /// The single integer that a query such as "PRAGMA user_version" gives.
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
    std::unique_ptr<CheckedFiles> files_;  // nothing for any database
    bool is_owned_ = false;                // the lock that is kept has been got
    std::unique_ptr<sqlite3, Close> handle_;
};

/// A prepared statement: bind, step until there is no row, reset. Parameters count from 1, columns from 0.
///
/// Must end before its database. A NaN is kept as NULL, every other number bit for bit.
class Statement {
public:
    /// Puts a number in place of a parameter, counted from 1.
    void bind(int parameter, double value);
    /// Likewise, a whole number.
    void bind(int parameter, std::int64_t value);
    /// Likewise, text.
    void bind(int parameter, std::string_view text);  // must live until the next `reset`
    /// Likewise, nothing.
    void bind_null(int parameter);

    /// Likewise, what stands in a column of another statement's row, bit for bit.
    void bind_column(int parameter, const Statement& row, int column);

    /// Goes to the next row; false when there is none.
    bool step();

    /// Runs a statement that gives no rows, and makes it ready for the next values.
    void run();

    /// Ends the rows, whether all were seen or not, and makes it ready for the next values.
    void reset();

    /// The number in a column of the row, counted from 0; NaN for NULL.
    double number(int column) const;
    /// Likewise, a whole number; 0 for NULL.
    std::int64_t integer(int column) const;
    /// Likewise, text.
    std::string text(int column) const;  // empty for NULL

    /// Does the same stand in a column of another statement's row, bit for bit?
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

/// All or nothing: what is not committed when this ends is undone.
///
/// Both kinds see one state of the database from their first statement on; only one process at a time may write.
class Transaction {
public:
    /// Does it write, or only read?
    enum class Purpose { write, read };

    /// Begins. Throws `Error` (io) where another process keeps the lock for too long.
    explicit Transaction(Database& database, Purpose purpose = Purpose::write);
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;

    /// Keeps what was written. Throws `Error` (io) where that fails.
    void commit();

private:
    Database& database_;
    bool is_open_ = true;
};

}  // namespace stridor::storage
