#pragma once

#include "stridor/noise_library/entry.hpp"
#include "stridor/storage/database.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>

/// The database of a library: opens it, makes it if it is missing, updates an older layout.
namespace stridor::noise_library {

/// A library's database written anew beside it ("library.sqlite.new"), which takes its name once it is whole. It is
/// removed if it is never kept; the next process removes the remains of a killed one. The caller must keep others from
/// writing the library.
class Replacement {
public:
    /// Begins it. Throws `Error` (io) if there is no room for it.
    explicit Replacement(const std::filesystem::path& library);
    ~Replacement();
    Replacement(const Replacement&) = delete;
    Replacement& operator=(const Replacement&) = delete;

    /// Adds an entry under its id, or under a new one if it has none; returns its id.
    std::int64_t write(const Entry& entry);

    /// Ensures that no id up to this one is given again.
    void reserve(std::int64_t last_id);

    /// Brings it to the disk and gives it the library's name and permissions; nothing may be written afterwards.
    void keep();

private:
    std::filesystem::path library_;
    std::filesystem::path file_;
    std::optional<storage::Database> database_;
    std::optional<storage::Transaction> transaction_;
};

/// Layout of a library. Raise it when a table, a column or its meaning changes, and let `open_database` update older
/// ones: nobody can compute a library anew.
inline constexpr int library_schema = 2;

/// The identity in a library's header: "STRL", where other programs look for the kind of a database; pages have
/// checksums from layout 2 on.
inline constexpr storage::Identity library_identity{0x5354524C, 2};

/// Whether the library is only read, or filled, too. Only then is a missing one made.
enum class Access { read, fill };

/// How a library is opened.
struct LibraryOptions {
    Access access = Access::read;
    std::chrono::milliseconds wait{10000};  // for another process that writes
    storage::WaitOptions waiting{};         // how to wait for it
};

/// Returns the folder of the audio, beside the file itself and not beside a link to it. Throws `Error` (input) for a
/// file that has the name of its folder.
std::filesystem::path audio_folder_of(const std::filesystem::path& file);

/// Returns how a library's file is opened.
storage::DatabaseOptions database_options(const std::filesystem::path& file, const LibraryOptions& options);

/// Returns the database of a library, as this program makes it.
///
/// A library of layout 1, which has no checksums, is rewritten: the new file takes the old one's name once it is whole,
/// under the old one's write lock, so that it survives a kill and a process that writes the old one loses nothing. If
/// nothing can be written it is read as it is. Throws `Error`: input for a file that is not a library or a newer one,
/// io if it is damaged or cannot be read.
storage::Database open_database(const std::filesystem::path& file, const LibraryOptions& options);

}  // namespace stridor::noise_library
