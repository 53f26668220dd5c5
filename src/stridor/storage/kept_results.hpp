#pragma once

#include "stridor/storage/database.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::storage {

/// The identity in the header of a file of kept results: "STRK".
inline constexpr Identity kept_results_identity{0x5354524b, 1};

/// Finished parts of a long computation, by number, in one SQLite file, so that a stopped or killed run goes on from
/// them.
///
/// Tables: meta(key, value) with the text that says which computation it is; result(id, text). A kill loses the results
/// of the last half second at most. Each page has a checksum.
class KeptResults {
public:
    /// Opens the results of this computation, or begins the file. `what` is all that decides them; `word` names the
    /// file in messages. Throws `Error`: input if the file is something else or another computation's, io if another
    /// process has it open or it cannot be read or written.
    KeptResults(const std::filesystem::path& file, const std::string& what, std::string word);

    /// Writes the results that are not written yet.
    ~KeptResults();
    KeptResults(const KeptResults&) = delete;
    KeptResults& operator=(const KeptResults&) = delete;

    /// Returns the number of results that were there when the file was opened.
    std::size_t found() const { return found_.size(); }

    /// Returns one of those results, or `std::nullopt` if it was not there. May be called from any thread.
    std::optional<std::string> find(std::uint64_t number) const;

    /// Keeps a result that was not there. May be called from any thread; throws `Error` (io) if it cannot be written.
    void keep(std::uint64_t number, std::string text);

    /// Writes the results that are not written yet. Throws `Error` (io).
    void flush();

private:
    void create(const std::string& what);
    void verify(const std::string& what);
    void write();

    Database database_;
    std::string word_;
    std::map<std::uint64_t, std::string> found_;
    std::mutex mutex_;  // guards what stands below, and the database once it is open
    std::vector<std::pair<std::uint64_t, std::string>> batch_;
    std::chrono::steady_clock::time_point written_ = std::chrono::steady_clock::now();
};

/// Finished parts of a long command, kept in the user's cache folder ($XDG_CACHE_HOME or ~/.cache, stridor/) until the
/// command ends. The same command goes on from them.
class CommandCache {
public:
    /// Opens the cache. `command` names the file, `what` is all that decides the results. If nothing can be kept (no
    /// such folder, another process has the file) the work is done without a cache, and `note` is told so. `note` is
    /// also told what was found.
    CommandCache(const std::string& command, const std::string& what,
                 const std::function<void(const std::string&)>& note);

    /// Returns the kept results, or null if nothing can be kept.
    KeptResults* results() { return results_.get(); }

    /// Removes the file: the command has its result.
    void finish();

private:
    std::filesystem::path file_;
    std::unique_ptr<KeptResults> results_;
};

}  // namespace stridor::storage
