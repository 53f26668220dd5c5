#include "stridor/storage/checked_files.hpp"

#include <sqlite3.h>

#include <cstring>
#include <string_view>
#include <utility>

namespace stridor::storage {

namespace {

constexpr std::size_t word_size = 8;  // [bytes]
constexpr std::size_t covered = page_size - checksum_size;

// the same on every machine
std::uint64_t word_at(std::span<const std::uint8_t, page_size> page, std::size_t place) {
    std::uint64_t word = 0;
    for (std::size_t k = 0; k < word_size; ++k)
        word |= std::uint64_t{page[place + k]} << (8 * k);
    return word;
}

// Each step is one to one in the hash and in the word: what differs in one word differs at the end. The odd factor is
// that of Knuth's linear congruential generator (MMIX); the shift carries high bits back to the low ones.
std::uint64_t stirred(std::uint64_t hash, std::uint64_t word) {
    hash = (hash ^ word) * 6364136223846793005U;
    return hash ^ (hash >> 29U);
}

// parts of a database's header (SQLite's documentation, "Database File Format", 1.3)
constexpr std::string_view sqlite_words{"SQLite format 3\0", 16};
constexpr std::size_t header_size = 100;  // [bytes]
constexpr std::size_t layout_place = 60;
constexpr std::size_t application_place = 68;

// of a rollback journal: a page stands behind its number
constexpr sqlite3_int64 number_size = 4;  // [bytes]

std::int32_t integer_at(const std::uint8_t* bytes) {
    std::uint32_t value = 0;
    for (int k = 0; k < 4; ++k)
        value = value << 8U | bytes[k];
    return static_cast<std::int32_t>(value);
}

std::uint32_t page_number(sqlite3_int64 offset) {
    return static_cast<std::uint32_t>(offset / static_cast<sqlite3_int64>(page_size)) + 1;
}

}  // namespace

std::uint64_t page_checksum(std::span<const std::uint8_t, page_size> page, std::uint32_t number) {
    // the number tells a page from another one's copy; a page of zeros is none
    std::uint64_t hash = stirred(1442695040888963407U, number);
    for (std::size_t place = 0; place < covered; place += word_size)
        hash = stirred(hash, word_at(page, place));
    return stirred(hash, covered);
}

void put_checksum(std::span<std::uint8_t, page_size> page, std::uint32_t number) {
    const std::uint64_t sum = page_checksum(page, number);
    for (std::size_t k = 0; k < checksum_size; ++k)
        page[covered + k] = static_cast<std::uint8_t>(sum >> (8 * k));
}

bool has_checksum(std::span<const std::uint8_t, page_size> page, std::uint32_t number) {
    return word_at(page, covered) == page_checksum(page, number);
}

struct CheckedFiles::System {
    enum class Pages { unknown, checked, unchecked };

    Identity identity;
    Damage damage = Damage::refuse;
    std::function<bool()> is_ours{};  // empty: they are
    Pages pages = Pages::unknown;     // what the header says that was read or written last
    std::string name{};
    sqlite3_vfs* real = nullptr;
    sqlite3_vfs own{};

    void look_at_header(const std::uint8_t* header);
    bool are_ours() const { return !is_ours || is_ours(); }
};

void CheckedFiles::System::look_at_header(const std::uint8_t* header) {
    const bool has_words = std::memcmp(header, sqlite_words.data(), sqlite_words.size()) == 0;
    const bool has_id = integer_at(header + application_place) == identity.application_id;
    const bool has_reserve = header[reserved_place] == checksum_size;
    const std::int32_t layout = integer_at(header + layout_place);
    const bool is_old =
        has_words && has_id && header[reserved_place] == 0 && layout > 0 && layout < identity.first_checked;
    const int signs = (has_words ? 1 : 0) + (has_id ? 1 : 0) + (has_reserve ? 1 : 0);
    pages = signs >= 2 && !is_old ? Pages::checked : Pages::unchecked;
}

namespace {

using System = CheckedFiles::System;

/// An open file as SQLite holds it; that of the system's VFS stands behind it.
struct File {
    sqlite3_file base;
    System* system;
    bool is_journal;
};

File* own(sqlite3_file* file) {
    return reinterpret_cast<File*>(file);
}

sqlite3_file* real(sqlite3_file* file) {
    return reinterpret_cast<sqlite3_file*>(own(file) + 1);
}

// is it one page, whole?
bool is_page(int size, sqlite3_int64 offset) {
    return size == static_cast<int>(page_size) && offset % static_cast<sqlite3_int64>(page_size) == 0;
}

std::span<const std::uint8_t, page_size> page_of(const std::uint8_t* bytes) {
    return std::span<const std::uint8_t, page_size>(bytes, page_size);
}

int read_database(sqlite3_file* file, void* buffer, int size, sqlite3_int64 offset) {
    System& system = *own(file)->system;
    const int code = real(file)->pMethods->xRead(real(file), buffer, size, offset);
    if (code != SQLITE_OK && code != SQLITE_IOERR_SHORT_READ) return code;
    const auto* bytes = static_cast<const std::uint8_t*>(buffer);
    // SQLite asks for the header alone before it knows the size of a page, and for its counter before it reads anew
    const bool is_peek = size <= static_cast<int>(header_size);
    if (is_peek) return code;
    if (code == SQLITE_IOERR_SHORT_READ) {
        sqlite3_int64 end = 0;
        const int known = real(file)->pMethods->xFileSize(real(file), &end);
        if (known != SQLITE_OK) return known;
        if (offset >= end) return code;  // behind the end, where nothing was written yet
    }
    if (offset == 0) system.look_at_header(bytes);
    if (system.pages != System::Pages::checked || system.damage == Damage::salvage) return code;
    const bool is_whole =
        code == SQLITE_OK && is_page(size, offset) && has_checksum(page_of(bytes), page_number(offset));
    return is_whole ? SQLITE_OK : SQLITE_IOERR_DATA;
}

int write_database(sqlite3_file* file, const void* buffer, int size, sqlite3_int64 offset) {
    System& system = *own(file)->system;
    if (is_page(size, offset)) {
        // SQLite's own memory, where the reserved bytes are ours; it copies them into the journal with the next change
        auto* bytes = static_cast<std::uint8_t*>(const_cast<void*>(buffer));
        if (offset == 0) system.look_at_header(bytes);
        // unknown: an interrupted change is being undone, with pages that have their checksums
        if (system.pages == System::Pages::checked)
            put_checksum(std::span<std::uint8_t, page_size>(bytes, page_size), page_number(offset));
    }
    return real(file)->pMethods->xWrite(real(file), buffer, size, offset);
}

int read_journal(sqlite3_file* file, void* buffer, int size, sqlite3_int64 offset) {
    const System& system = *own(file)->system;
    sqlite3_file* journal = real(file);
    const int code = journal->pMethods->xRead(journal, buffer, size, offset);
    const bool is_copy = code == SQLITE_OK && size == static_cast<int>(page_size) && offset >= number_size;
    if (!is_copy || system.pages != System::Pages::checked || system.damage == Damage::salvage) return code;
    std::uint8_t number[number_size] = {};
    const int read = journal->pMethods->xRead(journal, number, number_size, offset - number_size);
    if (read != SQLITE_OK) return read;
    const bool is_whole =
        has_checksum(page_of(static_cast<const std::uint8_t*>(buffer)), static_cast<std::uint32_t>(integer_at(number)));
    return is_whole ? SQLITE_OK : SQLITE_IOERR_DATA;
}

int close_file(sqlite3_file* file) {
    return real(file)->pMethods->xClose(real(file));
}

int read_file(sqlite3_file* file, void* buffer, int size, sqlite3_int64 offset) {
    return own(file)->is_journal ? read_journal(file, buffer, size, offset) : read_database(file, buffer, size, offset);
}

int write_file(sqlite3_file* file, const void* buffer, int size, sqlite3_int64 offset) {
    if (!own(file)->is_journal) return write_database(file, buffer, size, offset);
    return real(file)->pMethods->xWrite(real(file), buffer, size, offset);
}

// SQLite takes a file without one whole page for an empty one: so it becomes where an interrupted beginning is undone
bool is_empty(sqlite3_int64 size) {
    return size < static_cast<sqlite3_int64>(page_size);
}

int truncate_file(sqlite3_file* file, sqlite3_int64 size) {
    const int code = real(file)->pMethods->xTruncate(real(file), size);
    if (code == SQLITE_OK && !own(file)->is_journal && is_empty(size))
        own(file)->system->pages = System::Pages::checked;
    return code;
}

// the rest is the system's; no shared memory and no mapped pages (version 1), past which nothing would be looked at
const sqlite3_io_methods checked_methods{
    1,
    close_file,
    read_file,
    write_file,
    truncate_file,
    [](sqlite3_file* file, int flags) { return real(file)->pMethods->xSync(real(file), flags); },
    [](sqlite3_file* file, sqlite3_int64* size) { return real(file)->pMethods->xFileSize(real(file), size); },
    [](sqlite3_file* file, int level) { return real(file)->pMethods->xLock(real(file), level); },
    [](sqlite3_file* file, int level) { return real(file)->pMethods->xUnlock(real(file), level); },
    [](sqlite3_file* file, int* out) { return real(file)->pMethods->xCheckReservedLock(real(file), out); },
    [](sqlite3_file* file, int what, void* argument) {
        return real(file)->pMethods->xFileControl(real(file), what, argument);
    },
    [](sqlite3_file* file) { return real(file)->pMethods->xSectorSize(real(file)); },
    [](sqlite3_file* file) { return real(file)->pMethods->xDeviceCharacteristics(real(file)); },
    nullptr,
    nullptr,
    nullptr,
    nullptr,
    nullptr,
    nullptr};

System& system_of(sqlite3_vfs* vfs) {
    return *static_cast<System*>(vfs->pAppData);
}

int open_file(sqlite3_vfs* vfs, const char* name, sqlite3_file* file, int flags, int* given) {
    System& system = system_of(vfs);
    const bool is_database = (flags & SQLITE_OPEN_MAIN_DB) != 0;
    const bool is_journal = (flags & SQLITE_OPEN_MAIN_JOURNAL) != 0;
    if (!is_database && !is_journal) return system.real->xOpen(system.real, name, file, flags, given);
    *own(file) = {{nullptr}, &system, is_journal};
    real(file)->pMethods = nullptr;
    int code = system.real->xOpen(system.real, name, real(file), flags, given);
    if (real(file)->pMethods == nullptr) return code;
    if (code == SQLITE_OK && is_journal && (flags & SQLITE_OPEN_READWRITE) != 0 && !system.are_ours()) {
        real(file)->pMethods->xClose(real(file));
        return SQLITE_CANTOPEN;
    }
    file->pMethods = &checked_methods;
    sqlite3_int64 size = 0;
    if (code == SQLITE_OK && is_database) code = real(file)->pMethods->xFileSize(real(file), &size);
    if (code == SQLITE_OK && is_database && is_empty(size)) system.pages = System::Pages::checked;
    return code;
}

sqlite3_vfs checked_system(System& system) {
    sqlite3_vfs vfs{};
    vfs.iVersion = 2;
    vfs.szOsFile = static_cast<int>(sizeof(File)) + system.real->szOsFile;
    vfs.mxPathname = system.real->mxPathname;
    vfs.zName = system.name.c_str();
    vfs.pAppData = &system;
    vfs.xOpen = open_file;
    vfs.xDelete = [](sqlite3_vfs* own, const char* name, int sync) {
        if (!system_of(own).are_ours()) return SQLITE_IOERR_DELETE;
        return system_of(own).real->xDelete(system_of(own).real, name, sync);
    };
    vfs.xAccess = [](sqlite3_vfs* own, const char* name, int flags, int* out) {
        return system_of(own).real->xAccess(system_of(own).real, name, flags, out);
    };
    vfs.xFullPathname = [](sqlite3_vfs* own, const char* name, int size, char* out) {
        return system_of(own).real->xFullPathname(system_of(own).real, name, size, out);
    };
    vfs.xRandomness = [](sqlite3_vfs* own, int size, char* out) {
        return system_of(own).real->xRandomness(system_of(own).real, size, out);
    };
    vfs.xSleep = [](sqlite3_vfs* own, int microseconds) {
        return system_of(own).real->xSleep(system_of(own).real, microseconds);
    };
    vfs.xCurrentTime = [](sqlite3_vfs* own, double* out) {
        return system_of(own).real->xCurrentTime(system_of(own).real, out);
    };
    vfs.xGetLastError = [](sqlite3_vfs* own, int size, char* out) {
        return system_of(own).real->xGetLastError(system_of(own).real, size, out);
    };
    vfs.xCurrentTimeInt64 = [](sqlite3_vfs* own, sqlite3_int64* out) {
        return system_of(own).real->xCurrentTimeInt64(system_of(own).real, out);
    };
    return vfs;
}

}  // namespace

CheckedFiles::CheckedFiles(const Identity& identity, Damage damage, std::function<bool()> is_ours)
    : system_(std::make_unique<System>()) {
    system_->is_ours = std::move(is_ours);
    system_->identity = identity;
    system_->damage = damage;
    sqlite3_initialize();
    system_->real = sqlite3_vfs_find(nullptr);
    // one per connection, which alone knows its name
    system_->name = "stridor-" + std::to_string(reinterpret_cast<std::uintptr_t>(system_.get()));
    system_->own = checked_system(*system_);
    sqlite3_vfs_register(&system_->own, 0);
}

CheckedFiles::~CheckedFiles() {
    sqlite3_vfs_unregister(&system_->own);
}

const char* CheckedFiles::name() const {
    return system_->name.c_str();
}

bool CheckedFiles::are_checked() const {
    return system_->pages == System::Pages::checked;
}

}  // namespace stridor::storage
