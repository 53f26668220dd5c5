#pragma once

#include "stridor/noise_library/entry.hpp"
#include "stridor/storage/database.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>

/// The database of a library: opened, made where there is none, brought up to date where it is of an older layout.
namespace stridor::noise_library {

/// A library's database written anew beside it ("library.sqlite.new"), which takes its name once it is whole. Gone if
/// it is never kept; what a killed process left of one is removed by the next. Whoever calls keeps others from writing
/// the
/// library.
class Replacement {
public:
    /// Throws `Error` (io) where there is no room for it.
    explicit Replacement(const std::filesystem::path& library);
    ~Replacement();
    Replacement(const Replacement&) = delete;
    Replacement& operator=(const Replacement&) = delete;

    /// Adds an entry under its id, or under a new one if it has none; returns its id.
    std::int64_t write(const Entry& entry);

    /// No id up to this one is given again.
    void reserve(std::int64_t last_id);

    /// Brings it to the disk and gives it the library's name and permissions; nothing is written afterwards.
    void keep();

private:
    std::filesystem::path library_;
    std::filesystem::path file_;
    std::optional<storage::Database> database_;
    std::optional<storage::Transaction> transaction_;
};

/// Layout of a library. Raise it when a table, a column or the meaning of one changes, and let `open_database` bring
/// the older ones up to date: nobody can compute a library anew.
inline constexpr int library_schema = 2;

/// What a library's header says: "STRL", where other programs look for the kind of a database; pages have checksums
/// from layout 2 on.
inline constexpr storage::Identity library_identity{0x5354524C, 2};

/// Is the library to be read, or filled, too? Only then is one made where there is none.
enum class Access { read, fill };

/// How a library is opened.
struct LibraryOptions {
    Access access = Access::read;
    std::chrono::milliseconds wait{10000};  // for another process that writes
    storage::WaitOptions waiting{};         // meanwhile
};

/// The folder of its audio, beside the file itself and not beside a link to it. Throws `Error` (input) for a file that
/// has the name of its folder.
std::filesystem::path audio_folder_of(const std::filesystem::path& file);

/// How a library's file is opened.
storage::DatabaseOptions database_options(const std::filesystem::path& file, const LibraryOptions& options);

/// The database of a library, as this program makes it.
///
/// One of layout 1, which has no checksums, is rewritten: the new file takes the old one's name once it is whole,
/// under the old one's write lock, so that it survives a kill and a process that writes the old one loses nothing.
/// Where nothing can be written it is read as it is. Throws `Error`: input for what is no library or a newer one, io
/// where it is damaged or
/// cannot be
/// read.
storage::Database open_database(const std::filesystem::path& file, const LibraryOptions& options);

}  // namespace stridor::noise_library
