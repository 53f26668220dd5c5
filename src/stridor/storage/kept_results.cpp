#include "stridor/storage/kept_results.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/hash.hpp"
#include "stridor/base/version.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <system_error>
#include <utility>

namespace stridor::storage {

namespace {

constexpr int schema = 1;
constexpr std::chrono::milliseconds longest_wait{250};  // as of a chart's store
constexpr std::chrono::milliseconds longest_unwritten{500};
constexpr const char* compute_anew = "Remove the file: the same command computes the same results anew.";

constexpr const char* create_meta = "CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID";
constexpr const char* create_result = "CREATE TABLE result(id INTEGER PRIMARY KEY, text TEXT NOT NULL)";

DatabaseOptions options_for(const std::string& word) {
    DatabaseOptions options;
    options.words = {word, "Remove the file.", "Wait until that ends.", compute_anew,
                     "run the same command again: it goes on from what is kept."};
    options.identity = kept_results_identity;
    options.wait = longest_wait;
    return options;
}

// empty where there is none
std::filesystem::path cache_folder() {
    const char* cache = std::getenv("XDG_CACHE_HOME");
    if (cache != nullptr && *cache == '/') return std::filesystem::path(cache) / "stridor";
    const char* home = std::getenv("HOME");
    if (home != nullptr && *home == '/') return std::filesystem::path(home) / ".cache" / "stridor";
    return {};
}

}  // namespace

KeptResults::KeptResults(const std::filesystem::path& file, const std::string& what, std::string word)
    : database_(file, options_for(word)),
      word_(std::move(word)) {
    Transaction transaction(database_);
    if (database_.is_new())
        create(what);
    else
        verify(what);
    Statement rows = database_.prepare("SELECT id, text FROM result ORDER BY id");
    while (rows.step())
        found_.emplace(static_cast<std::uint64_t>(rows.integer(0)), rows.text(1));
    rows.reset();
    transaction.commit();
}

KeptResults::~KeptResults() {
    try {
        flush();
    } catch (const Error&) {  // NOLINT(bugprone-empty-catch): what is lost is computed again
    }
}

void KeptResults::create(const std::string& what) {
    database_.execute("PRAGMA application_id = " + std::to_string(kept_results_identity.application_id));
    database_.execute("PRAGMA user_version = " + std::to_string(schema));
    database_.execute(create_meta);
    database_.execute(create_result);
    Statement insert = database_.prepare("INSERT INTO meta(key, value) VALUES('what', ?)");
    insert.bind(1, std::string_view(what));
    insert.run();
}

void KeptResults::verify(const std::string& what) {
    const std::string name = "the " + word_ + " " + database_.file().string();
    if (database_.integer("PRAGMA application_id") != kept_results_identity.application_id ||
        database_.integer("PRAGMA user_version") != schema)
        throw Error(ErrorKind::input, {name + " is something else", "another program wrote it", "Remove the file."});
    database_.expect_whole();
    database_.expect_schema(std::array{std::string(create_meta), std::string(create_result)});
    Statement query = database_.prepare("SELECT value FROM meta WHERE key = 'what'");
    const std::string stored = query.step() ? query.text(0) : std::string();
    if (stored != what)
        throw Error(ErrorKind::input, {name + " belongs to something else",
                                       "its results were computed from other values or by another "
                                       "version",
                                       "Remove the file."});
}

std::optional<std::string> KeptResults::find(std::uint64_t number) const {
    const auto place = found_.find(number);
    return place == found_.end() ? std::nullopt : std::optional(place->second);
}

void KeptResults::keep(std::uint64_t number, std::string text) {
    const std::lock_guard lock(mutex_);
    batch_.emplace_back(number, std::move(text));
    if (std::chrono::steady_clock::now() - written_ >= longest_unwritten) write();
}

void KeptResults::flush() {
    const std::lock_guard lock(mutex_);
    write();
}

void KeptResults::write() {
    written_ = std::chrono::steady_clock::now();
    if (batch_.empty()) return;
    const auto batch = std::exchange(batch_, {});
    Transaction transaction(database_);
    Statement insert = database_.prepare("INSERT OR REPLACE INTO result(id, text) VALUES(?, ?)");
    for (const auto& [number, text] : batch) {
        insert.bind(1, static_cast<std::int64_t>(number));
        insert.bind(2, std::string_view(text));
        insert.run();
    }
    transaction.commit();
}

CommandCache::CommandCache(const std::string& command, const std::string& what,
                           const std::function<void(const std::string&)>& note) {
    // bits of two builds never mix
    const std::string all = fmt::format("{} {}\n{}", base::version(), base::commit(), what);
    const std::filesystem::path folder = cache_folder();
    if (folder.empty()) return;
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    file_ = folder / fmt::format("{}-{}.sqlite", command, base::sha256_text(all).substr(0, 16));
    try {
        results_ = std::make_unique<KeptResults>(file_, all, "cache");
    } catch (const Error& failure) {
        note(fmt::format("nothing is kept of this run, should it be stopped: {}", failure.problem().what));
        return;
    }
    if (results_->found() > 0)
        note(fmt::format("goes on from {} results of a run that was stopped", results_->found()));
}

void CommandCache::finish() {
    if (!results_) return;
    results_.reset();
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
}

}  // namespace stridor::storage
