#include "stridor/noise_library/replacement.hpp"

#include "stridor/noise_library/entry_rows.hpp"
#include "stridor/noise_library/library_file.hpp"
#include "stridor/storage/system_io.hpp"

#include <algorithm>
#include <system_error>

namespace stridor::noise_library {

namespace fs = std::filesystem;

namespace {

void remove_database(const fs::path& file) {
    std::error_code ignored;  // what is in the way is met again when the file is made
    fs::remove(file.string() + "-journal", ignored);
    fs::remove(file, ignored);
}

storage::DatabaseOptions replacement_options(const fs::path& library) {
    storage::DatabaseOptions options = database_options(library, {Access::fill});
    options.ownership = storage::Ownership::alone;
    return options;
}

}  // namespace

Replacement::Replacement(const fs::path& library) {
    std::error_code error;
    // the file itself, not a link to it
    library_ = fs::is_symlink(library, error) ? fs::weakly_canonical(library, error) : library;
    file_ = library_.string() + ".new";
    remove_database(file_);
    database_.emplace(file_, replacement_options(library));
    transaction_.emplace(*database_);
    create_tables(*database_);
}

Replacement::~Replacement() {
    transaction_.reset();
    database_.reset();
    if (!file_.empty()) remove_database(file_);
}

std::int64_t Replacement::write(const Entry& entry) {
    return write_entry(*database_, entry);
}

void Replacement::reserve(std::int64_t last_id) {
    // SQLite keeps the number of a table that has had a row
    const std::int64_t known = database_->integer("SELECT seq FROM sqlite_sequence WHERE name = 'entry'");
    database_->execute("DELETE FROM sqlite_sequence WHERE name = 'entry'");
    database_->execute("INSERT INTO sqlite_sequence(name, seq) VALUES('entry', " +
                       std::to_string(std::max(known, last_id)) + ")");
}

void Replacement::keep() {
    transaction_->commit();
    transaction_.reset();
    database_.reset();
    std::error_code error;
    const fs::perms permissions = fs::status(library_, error).permissions();
    if (!error) fs::permissions(file_, permissions, error);
    if (!error) fs::rename(file_, library_, error);
    if (error) throw storage::system_failure("write", library_.string(), error.value());
    file_.clear();
    storage::flush_folder(library_.parent_path(), library_.string());
}

}  // namespace stridor::noise_library
