#pragma once

#include "stridor/noise_library/audio_folder.hpp"
#include "stridor/noise_library/entry.hpp"
#include "stridor/noise_library/library_file.hpp"
#include "stridor/noise_library/query.hpp"
#include "stridor/storage/database.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::noise_library {

/// Returns the usual place of a library: stridor/library.sqlite in $XDG_DATA_HOME, or in ~/.local/share.
std::filesystem::path default_library();

/// Returns the name by which an entry's audio is kept.
inline AudioName audio_of(const Entry& entry) {
    return {entry.audio, entry.format};
}

/// When entries count as twins: with the same audio, or with equal content; and what happens to a twin.
enum class Twins { refuse_same_audio, skip_equal, accept };

/// The noise library: entries in one SQLite file, the audio in a folder beside it ("library.audio").
///
/// Tables: entry(id, digest, a column per field that is no document), document(entry, name, text), figure(entry, name,
/// unit, value). Several processes may use a library at once; each change is complete or absent, and on disk when its
/// function returns, whatever ends the process. Every failure throws `Error`: input for a file that is not a library of
/// this program, an unknown id, a meaningless name or value; io for the rest. Entries are read as they were written, or
/// an `Error` (io) says that the library is damaged: each page has a checksum, each entry a digest, and audio is named
/// by its hash.
class Library {
public:
    /// Opens the library, or makes it if it is to be filled and does not exist.
    explicit Library(const std::filesystem::path& file, const LibraryOptions& options = {});

    /// Returns the path of the database.
    const std::filesystem::path& file() const { return database_.file(); }
    /// Returns the folder of the audio, beside the database.
    const std::filesystem::path& audio_folder() const { return audio_folder_; }

    /// Returns the path of an entry's audio.
    std::filesystem::path audio_file(const Entry& entry) const;

    /// Returns the path of an entry's audio after a check of its bytes; throws `Error` (io) if they are not those that
    /// were added.
    std::filesystem::path sound_file(const Entry& entry) const;

    /// Replaces damaged or missing audio by staged audio; its names stay.
    void mend(Intake& intake, std::span<Staged> staged);

    /// Returns the entries that a query asks for.
    std::vector<Entry> find(const Query& query);

    /// Shows the entries of a query one by one, all of one moment, with some hundred of them in memory at a time.
    void visit(const Query& query, const std::function<void(const Entry&)>& take);

    /// Returns the number of entries that meet a query, whatever its limit.
    std::int64_t count(const Query& query);

    /// Returns whole entries by their ids, in this order. Throws `Error` (input) for an id that does not exist.
    std::vector<Entry> get(std::span<const std::int64_t> ids);

    /// Returns the first entry that has this audio (SHA-256), or `std::nullopt` if none has.
    std::optional<std::int64_t> entry_with(std::string_view audio);

    /// Returns the number of entries.
    std::int64_t size();

    /// Adds entries whose audio was staged; all or none. Returns their ids, 0 for one that was skipped.
    ///
    /// `audio` and `format` of each entry name its audio, which must be among the staged or in the library already.
    /// Throws `Error` (input) for a twin that is refused.
    std::vector<std::int64_t> add(Intake& intake, std::span<Staged> staged, std::span<const Entry> entries,
                                  Twins twins);

    /// Adds more entries than memory should hold; all or none. `next` returns them one by one, and `std::nullopt` after
    /// the last. An error that it throws undoes all.
    std::vector<std::int64_t> add(Intake& intake, std::span<Staged> staged,
                                  const std::function<std::optional<Entry>()>& next, Twins twins);

    /// Changes entries; all or none. Their ids and audio stay. Returns them as they are now.
    std::vector<Entry> edit(std::span<const std::int64_t> ids, const std::function<void(Entry&)>& change);

    /// Removes entries, and audio that no other entry has; all or none.
    void remove(std::span<const std::int64_t> ids);

    /// Returns the figures that entries have, by name.
    std::vector<FigureKind> figures();

    /// Returns the different texts of entries in a field of words, sorted.
    std::vector<std::string> words(std::string_view field);

private:
    void clear();
    std::vector<Entry> read(const Query& query);
    std::vector<Entry> read(std::span<const std::int64_t> ids);
    bool is_used(const AudioName& name);
    [[noreturn]] void refuse_id(std::int64_t id);
    std::optional<std::int64_t> first_entry(const std::string& sql, std::string_view sought);
    std::optional<std::int64_t> twin_of(const Entry& entry, Twins twins);

    storage::Database database_;
    std::filesystem::path audio_folder_;
};

/// Opens a library, the user's own if none is named. If it is to be filled and does not exist it is made, with the
/// folder of the user's own. Throws `Error` as the library does, and io if that folder cannot be made.
Library open_library(const std::filesystem::path& named, Access access, const storage::WaitOptions& waiting = {});

}  // namespace stridor::noise_library
