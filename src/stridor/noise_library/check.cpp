#include "stridor/noise_library/check.hpp"

#include "stridor/base/error.hpp"
#include "stridor/noise_library/entry_rows.hpp"
#include "stridor/noise_library/library.hpp"
#include "stridor/noise_library/library_file.hpp"
#include "stridor/storage/checked_files.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

namespace stridor::noise_library {

namespace fs = std::filesystem;

namespace {

AudioName name_of_audio(const Entry& entry) {
    return {entry.audio, entry.format};
}

// "library.sqlite.damaged", or with a number where there is one already
fs::path name_for_damaged(const fs::path& file) {
    std::error_code ignored;
    fs::path name = file.string() + ".damaged";
    for (int number = 2; fs::exists(name, ignored); ++number)
        name = file.string() + ".damaged-" + std::to_string(number);
    return name;
}

}  // namespace

bool is_sound(const Findings& findings) {
    const Saved& saved = findings.saved;
    return saved.damages.empty() && saved.lost.empty() && findings.damaged_sounds.empty();
}

Findings check(const fs::path& file, const LibraryOptions& options) {
    Findings findings;
    findings.saved = saved_from(file, options);
    std::map<AudioName, std::vector<std::int64_t>> users;
    for (const Entry& entry : findings.saved.entries)
        users[name_of_audio(entry)].push_back(entry.id);
    findings.sounds = users.size();
    const fs::path folder = audio_folder_of(file);
    for (const auto& [name, ids] : users) {
        std::error_code error;
        const fs::path sound = folder / path_of(name);
        const bool is_there = fs::is_regular_file(sound, error);
        if (!is_there || !is_whole(sound, name)) findings.damaged_sounds.push_back({name, ids, !is_there});
    }
    return findings;
}

std::vector<AudioName> sounds_without_entry(const fs::path& audio_folder, std::span<const Entry> entries) {
    std::set<AudioName> known;
    for (const Entry& entry : entries)
        known.insert(name_of_audio(entry));
    std::set<AudioName> found;
    std::error_code error;
    for (fs::recursive_directory_iterator each(audio_folder, error), end; !error && each != end;
         each.increment(error)) {
        const AudioName name{each->path().stem().string(), format_of(each->path())};
        const bool is_candidate =
            is_audio_name(name) && !known.contains(name) && audio_folder / path_of(name) == each->path();
        if (is_candidate && is_whole(each->path(), name)) found.insert(name);
    }
    return {found.begin(), found.end()};
}

fs::path replace_database(const fs::path& file, std::span<const Entry> entries, std::int64_t last_id) {
    Replacement replacement(file);
    for (const Entry& entry : entries)
        if (entry.id != 0) replacement.write(entry);
    replacement.reserve(last_id);
    for (const Entry& entry : entries)
        if (entry.id == 0) replacement.write(entry);
    std::error_code error;
    const fs::path real = fs::is_symlink(file, error) ? fs::weakly_canonical(file, error) : file;
    fs::path kept = name_for_damaged(real);
    // a second name for the old file: the library's own never lacks one
    fs::create_hard_link(real, kept, error);
    if (error) fs::copy_file(real, kept, error);
    if (error) throw storage::system_failure("write", kept.string(), error.value());
    replacement.keep();
    fs::remove(real.string() + "-journal", error);
    return kept;
}

using storage::Database;
using storage::Statement;
using storage::Transaction;

namespace {

using DatabasePage = std::array<std::uint8_t, storage::page_size>;

// parts of a database's header (SQLite's documentation, "Database File Format", 1.3)
constexpr std::size_t pages_place = 28;
constexpr std::size_t free_place = 32;

/// A file that is gone with it.
class Scratch {
public:
    explicit Scratch(fs::path file) : file_(std::move(file)) { remove(); }
    ~Scratch() { remove(); }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    const fs::path& file() const { return file_; }

private:
    void remove() const {
        std::error_code ignored;
        fs::remove(file_.string() + "-journal", ignored);
        fs::remove(file_, ignored);
    }
    fs::path file_;
};

storage::DatabaseOptions salvage_options(const fs::path& file) {
    storage::DatabaseOptions options = database_options(file, {});
    options.damage = storage::Damage::salvage;
    options.ownership = storage::Ownership::alone;
    return options;
}

void put_number(DatabasePage& page, std::size_t place, std::uint32_t value) {
    for (std::size_t k = 4; k-- > 0; value >>= 8U)
        page[place + k] = static_cast<std::uint8_t>(value);
}

// the first page of a library with so many pages, none of them free: the tables of every library begin at the same
// pages
DatabasePage first_page(const fs::path& beside, std::uint32_t pages) {
    const Scratch empty(beside);
    {
        Database database(empty.file(), database_options(beside, {Access::fill}));
        Transaction transaction(database);
        create_tables(database);
        transaction.commit();
    }
    DatabasePage page{};
    std::ifstream(empty.file(), std::ios::binary).read(reinterpret_cast<char*>(page.data()), page.size());
    put_number(page, pages_place, pages);
    put_number(page, free_place, 0);
    put_number(page, free_place + 4, 0);
    return page;
}

// Which rows there are is asked along every way that leads to them, since any may be damaged. A way that breaks off is
// not an error here: what it did not reach is met on another one, or is lost, and that is said.
void read_along(Database& database, const std::string& sql, const std::function<void(const Statement&)>& take) {
    constexpr long most_rows = 10'000'000;  // a damaged tree may lead in circles
    try {
        Statement rows = database.prepare(sql);
        for (long row = 0; row < most_rows && rows.step(); ++row)
            take(rows);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::io && error.kind() != ErrorKind::input) throw;
    }
}

struct RowTrace {
    int ways = 0;  // [1] that lead to it
    std::string digest{};
};

std::map<std::int64_t, RowTrace> traces_in(Database& database) {
    std::map<std::int64_t, RowTrace> traces;
    const auto along = [&](const std::string& way) {
        std::set<std::int64_t> ids;
        // from both ends: what lies beyond a break is met from the other one
        for (const char* direction : {"", " DESC"})
            read_along(database, way + direction, [&](const Statement& row) { ids.insert(row.integer(0)); });
        for (const std::int64_t id : ids)
            ++traces[id].ways;
    };
    along("SELECT id FROM entry NOT INDEXED ORDER BY id");
    along("SELECT id FROM entry INDEXED BY entry_audio ORDER BY audio");
    along("SELECT id FROM entry INDEXED BY entry_digest ORDER BY digest");
    along("SELECT DISTINCT entry FROM document ORDER BY entry");
    along("SELECT DISTINCT entry FROM figure ORDER BY entry");
    read_along(database, "SELECT id, digest FROM entry INDEXED BY entry_digest ORDER BY digest",
               [&](const Statement& row) { traces[row.integer(0)].digest = row.text(1); });
    return traces;
}

std::optional<Entry> entry_of(Database& database, std::int64_t id) {
    try {
        KeptEntry kept = read_entry(database, id);
        return is_sound(kept) && kept.entry.id == id ? std::optional(std::move(kept.entry)) : std::nullopt;
    } catch (const Error&) {
        return std::nullopt;  // lost, and counted so
    }
}

void take_entries(Database& database, Saved& saved) {
    for (const auto& [id, trace] : traces_in(database)) {
        if (std::optional<Entry> entry = entry_of(database, id)) {
            saved.entries.push_back(std::move(*entry));
            saved.last_id = std::max(saved.last_id, id);
        } else if (trace.ways > 1) {
            // a number that one damaged row alone tells of may never have been an id
            saved.lost.push_back({id, trace.digest});
            saved.last_id = std::max(saved.last_id, id);
        }
    }
}

// the number that was given last, where its page is what was written
std::int64_t given_last(const fs::path& file) {
    std::int64_t last = 0;
    try {
        Database database(file, database_options(file, {}));
        last = database.integer("SELECT seq FROM sqlite_sequence WHERE name = 'entry'");
    } catch (const Error&) {
        return 0;  // then the ids that are left tell it
    }
    return last;
}

// the bytes as they stand, with a first page that can be read
void copy_for_reading(Database& damaged, const fs::path& copy) {
    damaged.copy_bytes(copy);
    std::fstream stream(copy, std::ios::binary | std::ios::in | std::ios::out);
    DatabasePage page{};
    stream.read(reinterpret_cast<char*>(page.data()), page.size());
    if (!damaged.is_checked() || storage::has_checksum(page, 1)) return;
    const auto pages = static_cast<std::uint32_t>(fs::file_size(copy) / storage::page_size);
    page = first_page(copy.string() + ".first", pages);
    stream.clear();
    stream.seekp(0);
    stream.write(reinterpret_cast<const char*>(page.data()), page.size());
}

void expect_library(Database& database) {
    if (database.is_checked()) return;
    const std::string name = database.file().string();
    if (database.integer("PRAGMA application_id") != library_identity.application_id)
        throw Error(ErrorKind::input, {name + " is no noise library", "it is another program's SQLite database",
                                       "Choose another --library."});
}

}  // namespace

Saved saved_from(const fs::path& file, const LibraryOptions& options) {
    Saved saved;
    storage::DatabaseOptions opening = database_options(file, options);
    opening.damage = storage::Damage::salvage;
    Database database(file, opening);
    std::optional<Transaction> lock;
    try {
        lock.emplace(database, Transaction::Purpose::read);
        saved.damages = database.damages();
        expect_library(database);
    } catch (const Error& error) {
        if (!database.is_checked()) throw;
        // what SQLite cannot even begin to read
        if (saved.damages.empty()) saved.damages.push_back(error.problem().why);
    }
    if (saved.damages.empty()) {
        take_entries(database, saved);
        saved.last_id =
            std::max(saved.last_id, database.integer("SELECT seq FROM sqlite_sequence WHERE name = 'entry'"));
        return saved;
    }
    const Scratch copy(file.string() + ".copy");
    copy_for_reading(database, copy.file());
    Database readable(copy.file(), salvage_options(copy.file()));
    take_entries(readable, saved);
    saved.last_id = std::max(saved.last_id, given_last(file));
    return saved;
}

}  // namespace stridor::noise_library
