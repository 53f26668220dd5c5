#include "stridor/storage/hand_over.hpp"

#include "stridor/base/error.hpp"
#include "stridor/storage/system_io.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <string_view>
#include <system_error>

namespace stridor::storage {

namespace fs = std::filesystem;

namespace {

// a former owner finishes one change at most
constexpr int most_copies = 8;

// of a journal: how many pages it puts back, and a number unlike that of any other change (SQLite's documentation,
// "Database File Format", 3). Zeros, or nothing: there is no change
constexpr std::size_t journal_header = 28;  // [bytes]

// a link leads to the file that has the journal beside it
fs::path place_of(const fs::path& file) {
    std::error_code missing;
    const fs::path place = fs::canonical(file, missing);
    return missing ? file : place;
}

fs::path journal_of(const fs::path& file) {
    return place_of(file).string() + "-journal";
}

std::string named_file(const fs::path& file) {
    return "\"" + file.string() + "\"";
}

// removed at the end of the block, under whatever of its names it has by then
class Temporaries {
public:
    explicit Temporaries(fs::path file) : file_(std::move(file)) {}
    ~Temporaries() {
        std::error_code ignored;
        for (const fs::path& each : {file_, journal_of(file_)})
            fs::remove(each, ignored);
    }
    Temporaries(const Temporaries&) = delete;
    Temporaries& operator=(const Temporaries&) = delete;

private:
    fs::path file_;
};

// opened anew, for then NFS asks the server
std::string header_of(const fs::path& journal) {
    const Descriptor opened(::open(journal.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    std::array<char, journal_header> header{};
    const ssize_t size = opened.is_open() ? ::pread(opened.number(), header.data(), header.size(), 0) : 0;
    return {header.data(), static_cast<std::size_t>(size > 0 ? size : 0)};
}

void copy_all(const fs::path& file, const fs::path& copy) {
    std::error_code error;
    fs::copy_file(file, copy, fs::copy_options::overwrite_existing, error);
    if (error == std::errc::no_such_file_or_directory && !fs::exists(file)) {
        fs::remove(copy, error);
        return;
    }
    if (error) throw system_failure("copy", named_file(file), error.value());
}

void undo_open_change(const fs::path& file, const DatabaseOptions& options) {
    DatabaseOptions undoing = options;
    undoing.ownership = Ownership::shared;
    undoing.missing = MissingFile::refuse;
    undoing.confirm = {};
    undoing.is_ours = {};
    Database database(file, undoing);
    Transaction reading(database, Transaction::Purpose::read);
    database.integer("SELECT count(*) FROM sqlite_schema");
    reading.commit();
    std::error_code none;
    fs::remove(journal_of(file), none);
}

void make_empty(const fs::path& file) {
    Descriptor made(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (!made.is_open()) throw system_failure("write", named_file(file), errno);
    made.close(named_file(file));
}

void put_in_place(const fs::path& file, const fs::path& place) {
    if (::rename(file.c_str(), place.c_str()) != 0) throw system_failure("write", named_file(place), errno);
}

}  // namespace

fs::path unfinished_name(const fs::path& file, const std::string& mark) {
    return file.string() + ".new." + mark;
}

void remove_unfinished(const fs::path& file, const std::string& mark) {
    const std::string begins = unfinished_name(file.filename(), "").string();
    const std::string own = begins + mark;
    std::error_code ignored;
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    for (fs::directory_iterator each(folder, ignored), end; !ignored && each != end; each.increment(ignored)) {
        const std::string name = each->path().filename().string();
        std::error_code stays;
        if (name.starts_with(begins) && !name.starts_with(own)) fs::remove(each->path(), stays);
    }
}

bool has_open_change(const fs::path& file) {
    const std::string header = header_of(journal_of(file));
    return !header.empty() && header.front() != '\0';
}

void copy_database(const fs::path& file, const fs::path& copy, const DatabaseOptions& options) {
    const fs::path journal = journal_of(file);
    for (int copies = 0;; ++copies) {
        if (copies == most_copies)
            throw Error(ErrorKind::io, {"cannot copy " + named_file(file), "somebody changes it all the time",
                                        "Wait until that ends."});
        const std::string header = header_of(journal);
        copy_all(journal, journal_of(copy));
        copy_all(file, copy);
        if (header_of(journal) == header) break;
    }
    try {
        undo_open_change(copy, options);
    } catch (const Error& error) {
        base::Problem problem = error.problem();
        if (const std::size_t name = problem.what.find(copy.string()); name != std::string::npos)
            problem.what.replace(name, copy.string().size(), file.string());
        throw Error(error.kind(), problem);
    }
}

void hand_over(const fs::path& file, const std::string& mark, const DatabaseOptions& options,
               const std::function<void()>& expect_own) {
    const fs::path place = place_of(file);
    std::error_code missing;
    if (!fs::is_regular_file(place, missing)) return;
    const fs::path copy = unfinished_name(place, mark);
    const Temporaries ended(copy);
    try {
        copy_database(place, copy, options);
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::input) return;
        throw;
    }
    const Descriptor written(::open(copy.c_str(), O_RDWR | O_CLOEXEC));
    if (!written.is_open()) throw system_failure("write", named_file(file), errno);
    flush(written.number(), named_file(file));
    expect_own();
    // first the database: with the former journal the copy is what it is without
    put_in_place(copy, place);
    if (fs::exists(journal_of(place))) {
        make_empty(journal_of(copy));
        put_in_place(journal_of(copy), journal_of(place));
    }
    flush_folder(place.parent_path(), named_file(file));
}

}  // namespace stridor::storage
