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

/// Where a library stands when none is named: stridor/library.sqlite in $XDG_DATA_HOME, or in ~/.local/share.
std::filesystem::path default_library();

/// The name by which an entry's audio is kept.
inline AudioName audio_of(const Entry& entry) {
    return {entry.audio, entry.format};
}

/// What keeps entries apart that are one: the same audio, or the same in every word.
enum class Twins { refuse_same_audio, skip_equal, accept };

/// The noise library: entries in one SQLite file, the audio in a folder beside it ("library.audio").
///
/// Tables: entry(id, digest, a column per field that is no document), document(entry, name, text), figure(entry, name,
/// unit, value). Several processes may use a library
/// at once; each change is whole or not there, on disk when its function returns, whatever ends the process. Every
/// failure throws `Error`: input for a file that is no library of this program, an unknown id, a name or value that
/// means nothing; io for the rest. What is read is what was written, or an `Error` (io) says that the library is
/// damaged: each page has a checksum, each entry a digest, and audio is called by its hash.
class Library {
public:
    /// Opens the library, or makes it where it is to be filled and is not there.
    explicit Library(const std::filesystem::path& file, const LibraryOptions& options = {});

    /// The database.
    const std::filesystem::path& file() const { return database_.file(); }
    /// The folder of the audio, beside the database.
    const std::filesystem::path& audio_folder() const { return audio_folder_; }

    /// Where the audio of an entry lies.
    std::filesystem::path audio_file(const Entry& entry) const;

    /// The same once its bytes were looked at: those that were added, or an `Error` (io) says that they are not.
    std::filesystem::path sound_file(const Entry& entry) const;

    /// Puts staged audio in the place of what is damaged or missing; its names stay.
    void mend(Intake& intake, std::span<Staged> staged);

    /// The entries a query asks for.
    std::vector<Entry> find(const Query& query);

    /// The same one by one, some hundred of them in memory at a time, all of one moment.
    void visit(const Query& query, const std::function<void(const Entry&)>& take);

    /// How many entries a query asks for, whatever its limit.
    std::int64_t count(const Query& query);

    /// Entries by their ids, in this order, whole. Throws `Error` (input) for an id that is not there.
    std::vector<Entry> get(std::span<const std::int64_t> ids);

    /// The first entry that has this audio (SHA-256); nothing if none has.
    std::optional<std::int64_t> entry_with(std::string_view audio);

    /// Number of entries.
    std::int64_t size();

    /// Adds entries whose audio was staged; all or none. Gives their ids, 0 for one that was skipped.
    ///
    /// `audio` and `format` of each entry name its audio, which must be among the staged or in the library already.
    /// Throws `Error` (input) for a twin that is refused.
    std::vector<std::int64_t> add(Intake& intake, std::span<Staged> staged, std::span<const Entry> entries,
                                  Twins twins);

    /// The same for more entries than memory should hold: `next` gives them one by one, and nothing after the last.
    /// What it throws undoes all.
    std::vector<std::int64_t> add(Intake& intake, std::span<Staged> staged,
                                  const std::function<std::optional<Entry>()>& next, Twins twins);

    /// Changes entries; all or none. Their ids and audio stay what they are. Gives them as they are now.
    std::vector<Entry> edit(std::span<const std::int64_t> ids, const std::function<void(Entry&)>& change);

    /// Removes entries, and audio that no other entry has; all or none.
    void remove(std::span<const std::int64_t> ids);

    /// The figures that entries have, by name.
    std::vector<FigureKind> figures();

    /// What entries say in a field of words, each once, sorted.
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

/// Opens a library, the user's own where none is named, or makes it where it is to be filled, with the folder of the
/// user's own. Throws `Error` as the library does, and io where that folder cannot be made.
Library open_library(const std::filesystem::path& named, Access access, const storage::WaitOptions& waiting = {});

}  // namespace stridor::noise_library
