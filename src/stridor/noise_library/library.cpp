#include "stridor/noise_library/library.hpp"

#include "stridor/base/error.hpp"
#include "stridor/noise_library/entry_rows.hpp"
#include "stridor/noise_library/field.hpp"
#include "stridor/noise_library/query.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <system_error>
#include <utility>

namespace stridor::noise_library {

namespace fs = std::filesystem;
using storage::Statement;
using storage::Transaction;

namespace {}  // namespace

fs::path default_library() {
    const char* data = std::getenv("XDG_DATA_HOME");
    const char* home = std::getenv("HOME");
    const bool has_data = data != nullptr && *data == '/';
    if (!has_data && (home == nullptr || *home == '\0'))
        throw Error(ErrorKind::input, {"there is no place for a library", "neither XDG_DATA_HOME nor HOME is set",
                                       "Name one with --library FILE."});
    return (has_data ? fs::path(data) : fs::path(home) / ".local/share") / "stridor/library.sqlite";
}

Library::Library(const fs::path& file, const LibraryOptions& options)
    : database_(open_database(file, options)),
      audio_folder_(audio_folder_of(file)) {
    if (!database_.is_read_only() && has_leftovers(audio_folder_)) clear();
}

void Library::clear() {
    try {
        const Transaction transaction(database_);
        clear_leftovers(audio_folder_, [this](const AudioName& name) { return is_used(name); });
    } catch (const Error& error) {
        // a reader need not wait for whoever writes now: leftovers do no harm, and the next one clears them
        if (error.kind() != ErrorKind::io) throw;
    }
}

fs::path Library::audio_file(const Entry& entry) const {
    return audio_folder_ / path_of(audio_of(entry));
}

fs::path Library::sound_file(const Entry& entry) const {
    fs::path file = audio_file(entry);
    if (!is_whole(file, audio_of(entry)))
        throw Error(ErrorKind::io, {"the audio of entry " + std::to_string(entry.id) + " is damaged",
                                    file.string() + " has not the bytes of its name",
                                    "Add the recording again, or run `stridor library check --repair ARCHIVE`."});
    return file;
}

void Library::mend(Intake& intake, std::span<Staged> staged) {
    std::set<AudioName> names;
    for (const Staged& each : staged)
        names.insert(each.name);
    Transaction transaction(database_);
    intake.place(staged, names);
    transaction.commit();
    intake.settle();
}

std::int64_t Library::size() {
    return database_.integer("SELECT count(*) FROM entry");
}

std::vector<Entry> Library::find(const Query& query) {
    const Transaction snapshot(database_, Transaction::Purpose::read);
    return read(query);
}

void Library::visit(const Query& query, const std::function<void(const Entry&)>& take) {
    constexpr std::size_t at_once = 256;
    const Transaction snapshot(database_, Transaction::Purpose::read);
    const Selection selection = select(query, figures());
    Statement rows = database_.prepare("SELECT e.id" + selection.rows + selection.order);
    bind(rows, selection);
    std::vector<std::int64_t> ids;
    while (rows.step())
        ids.push_back(rows.integer(0));
    for (std::size_t from = 0; from < ids.size(); from += at_once) {
        const auto some = std::span(ids).subspan(from, std::min(at_once, ids.size() - from));
        for (const Entry& entry : read(some))
            take(entry);
    }
}

std::int64_t Library::count(const Query& query) {
    const Transaction snapshot(database_, Transaction::Purpose::read);
    const Selection selection = select(query, figures());
    Statement rows = database_.prepare("SELECT count(*)" + selection.rows);
    bind(rows, selection);
    return rows.step() ? rows.integer(0) : 0;
}

std::vector<Entry> Library::get(std::span<const std::int64_t> ids) {
    const Transaction snapshot(database_, Transaction::Purpose::read);
    return read(ids);
}

std::vector<Entry> Library::read(const Query& query) {
    const std::vector<FigureKind> known = figures();
    const Selection selection = select(query, known);
    Statement rows = database_.prepare("SELECT " + columns() + selection.rows + selection.order);
    bind(rows, selection);
    std::vector<Entry> entries;
    while (rows.step())
        entries.push_back(entry_in(rows));
    if (query.extent == EntryExtent::summary) return entries;

    std::map<std::int64_t, Entry*> by_id;
    for (Entry& entry : entries)
        by_id.emplace(entry.id, &entry);
    const std::string of_these = " WHERE entry IN (SELECT e.id" + selection.rows +
                                 (query.limit == 0 ? "" : selection.order) + ") ORDER BY entry, name";
    if (query.extent == EntryExtent::whole) {
        Statement documents = database_.prepare("SELECT entry, name, text FROM document" + of_these);
        bind(documents, selection);
        while (documents.step()) {
            const EntryField* field = find_field(documents.text(1));
            const auto found = by_id.find(documents.integer(0));
            if (found != by_id.end() && field != nullptr && is_document(*field))
                words_in(*found->second, *field) = documents.text(2);
        }
    }
    Statement values = database_.prepare("SELECT entry, name, unit, value FROM figure" + of_these);
    bind(values, selection);
    while (values.step())
        if (const auto found = by_id.find(values.integer(0)); found != by_id.end())
            found->second->figures.push_back({values.text(1), values.text(2), values.number(3)});
    return entries;
}

std::vector<Entry> Library::read(std::span<const std::int64_t> ids) {
    Query query;
    query.ids.assign(ids.begin(), ids.end());
    query.extent = EntryExtent::whole;
    const std::vector<Entry> found = ids.empty() ? std::vector<Entry>() : read(query);
    std::vector<Entry> entries;
    for (const std::int64_t id : ids) {
        // a query without an order gives them by id
        const auto place = std::lower_bound(found.begin(), found.end(), id,
                                            [](const Entry& entry, std::int64_t sought) { return entry.id < sought; });
        if (place == found.end() || place->id != id) refuse_id(id);
        entries.push_back(*place);
    }
    return entries;
}

void Library::refuse_id(std::int64_t id) {
    const std::int64_t count = size();
    throw Error(ErrorKind::input,
                {"there is no entry " + std::to_string(id) + " in " + file().string(),
                 count == 0 ? "the library is empty"
                            : std::to_string(count) + (count == 1 ? " entry, the last is " : " entries, the last is ") +
                                  std::to_string(database_.integer("SELECT max(id) FROM entry")),
                 "`stridor library list` shows what there is."});
}

std::optional<std::int64_t> Library::entry_with(std::string_view audio) {
    return first_entry("SELECT id FROM entry WHERE audio = ? ORDER BY id", audio);
}

std::optional<std::int64_t> Library::twin_of(const Entry& entry, Twins twins) {
    if (twins == Twins::accept) return std::nullopt;
    if (twins == Twins::refuse_same_audio) return entry_with(entry.audio);
    return first_entry("SELECT id FROM entry WHERE digest = ? ORDER BY id", digest(entry));
}

std::optional<std::int64_t> Library::first_entry(const std::string& sql, std::string_view sought) {
    Statement query = database_.prepare(sql);
    query.bind(1, sought);
    return query.step() ? std::optional(query.integer(0)) : std::nullopt;
}

std::vector<std::int64_t> Library::add(Intake& intake, std::span<Staged> staged, std::span<const Entry> entries,
                                       Twins twins) {
    const auto next = [place = entries.begin(), end = entries.end()]() mutable {
        return place == end ? std::nullopt : std::optional(*place++);
    };
    return add(intake, staged, next, twins);
}

std::vector<std::int64_t> Library::add(Intake& intake, std::span<Staged> staged,
                                       const std::function<std::optional<Entry>()>& next, Twins twins) {
    Transaction transaction(database_);
    std::vector<std::int64_t> ids;
    std::set<AudioName> needed;
    while (const std::optional<Entry> given = next()) {
        Entry entry = *given;
        const std::optional<std::int64_t> twin = twin_of(entry, twins);
        if (twin && twins == Twins::refuse_same_audio)
            throw Error(ErrorKind::input, {entry.file + " is in the library already",
                                           "entry " + std::to_string(*twin) + " has this sound",
                                           "Change that with `stridor library edit " + std::to_string(*twin) +
                                               "`, or add it once more with --again."});
        if (twin) {
            ids.push_back(0);
            continue;
        }
        entry.id = 0;
        ids.push_back(write_entry(database_, entry));
        needed.insert(audio_of(entry));
    }
    if (!needed.empty()) intake.place(staged, needed);
    transaction.commit();
    intake.settle();
    return ids;
}

std::vector<Entry> Library::edit(std::span<const std::int64_t> ids, const std::function<void(Entry&)>& change) {
    Transaction transaction(database_);
    std::vector<Entry> entries = read(ids);
    for (Entry& entry : entries) {
        const Entry before = entry;
        change(entry);
        entry.id = before.id;
        entry.audio = before.audio;
        entry.format = before.format;
        write_entry(database_, entry);
    }
    transaction.commit();
    return entries;
}

void Library::remove(std::span<const std::int64_t> ids) {
    Marker marker(audio_folder_);
    std::set<AudioName> audio;
    {
        Transaction transaction(database_);
        for (const Entry& entry : read(ids)) {
            audio.insert(audio_of(entry));
            remove_entry(database_, entry.id);
        }
        marker.announce(audio);
        transaction.commit();
    }
    // a second transaction: only once the rows are gone for good may the audio go, and nobody may add it meanwhile
    const Transaction lock(database_);
    for (const AudioName& name : audio) {
        if (is_used(name)) continue;
        std::error_code error;
        fs::remove(audio_folder_ / path_of(name), error);
        if (error) throw storage::system_failure("remove", (audio_folder_ / path_of(name)).string(), error.value());
    }
    marker.release();
}

bool Library::is_used(const AudioName& name) {
    Statement users = database_.prepare("SELECT 1 FROM entry WHERE audio = ? AND format = ?");
    users.bind(1, std::string_view(name.hash));
    users.bind(2, std::string_view(name.format));
    return users.step();
}

std::vector<FigureKind> Library::figures() {
    // from name to name through the index: their number counts, not that of all figures
    Statement next = database_.prepare("SELECT name, unit FROM figure WHERE name > ? ORDER BY name LIMIT 1");
    std::vector<FigureKind> kinds;
    std::string last;
    while (true) {
        next.bind(1, std::string_view(last));
        if (!next.step()) return kinds;
        FigureKind kind{next.text(0), next.text(1)};
        next.reset();
        if (kind.name <= last)
            throw Error(ErrorKind::io, {"the library " + file().string() + " is damaged",
                                        "its index of figures has no order", "Restore it from a copy or an export."});
        last = kind.name;
        kinds.push_back(std::move(kind));
    }
}

std::vector<std::string> Library::words(std::string_view field) {
    const EntryField* found = find_field(field);
    std::vector<std::string> words;
    if (found == nullptr || std::holds_alternative<EntryQuantity>(found->kind) || is_document(*found)) return words;
    const std::string column = column_of(*found);
    Statement rows =
        database_.prepare("SELECT DISTINCT " + column + " FROM entry WHERE " + column + " <> '' ORDER BY 1");
    while (rows.step())
        words.push_back(rows.text(0));
    return words;
}

Library open_library(const fs::path& named, Access access, const storage::WaitOptions& waiting) {
    const fs::path file = named.empty() ? default_library() : named;
    if (named.empty() && access == Access::fill)
        storage::make_folder(file.parent_path(), "Name another place with --library FILE.");
    LibraryOptions options;
    options.access = access;
    options.waiting = waiting;
    return Library(file, options);
}

}  // namespace stridor::noise_library
