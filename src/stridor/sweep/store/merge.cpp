#include "stridor/sweep/store/merge.hpp"

#include "stridor/base/error.hpp"
#include "stridor/storage/hand_over.hpp"
#include "stridor/storage/owner_file.hpp"
#include "stridor/storage/system_io.hpp"
#include "stridor/sweep/refinement.hpp"
#include "stridor/sweep/store/share.hpp"
#include "stridor/sweep/store/store.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>
#include <queue>
#include <string>
#include <utility>
#include <vector>

namespace stridor::sweep {

using storage::Statement;
using storage::Transaction;

namespace fs = std::filesystem;

namespace {

constexpr std::size_t rows_per_look = 4096;  // [1] between looks at the clock
constexpr auto report_tick = std::chrono::milliseconds(100);

// a store and the row that comes next; between two rows it may be closed
class MergeSource {
public:
    MergeSource(fs::path file, const Study& study) : file_(std::move(file)), study_(study) {}

    bool is_open() const { return rows_.has_value(); }

    void open() {
        store_.emplace(file_, study_, StoreUse::read);
        rows_.emplace(has_begun_ ? store_->rows(static_cast<std::int64_t>(index_)) : store_->rows());
        if (has_begun_ && !(rows_->step() && static_cast<std::size_t>(rows_->integer(0)) == index_))
            throw Error(ErrorKind::io, {"the store " + file_.string() + " changed while it was merged",
                                        fmt::format("its cell {} is gone", index_), "Run the same command again."});
    }

    void close() {
        rows_.reset();
        store_.reset();
    }

    bool next() {
        const std::size_t last = std::exchange(index_, 0);
        if (!rows_->step()) return false;
        const std::int64_t index = rows_->integer(0);
        // a negative one is beyond any study, too
        index_ = static_cast<std::size_t>(index);
        if (has_begun_ && index_ <= last) throw no_cell_of_the_study(file_, index);
        has_begun_ = true;
        return true;
    }

    std::size_t index() const { return index_; }
    const Statement& row() const { return *rows_; }
    const fs::path& file() const { return file_; }

    void expect_same(const MergeSource& other) const {
        const std::size_t columns = cell_columns_count();
        for (std::size_t column = 1; column < columns; ++column)
            if (!row().has_same(other.row(), static_cast<int>(column)))
                throw Error(ErrorKind::io, {fmt::format("cell {} is not the same in {} and {}", index_, file().string(),
                                                        other.file().string()),
                                            "one study has one result for each cell, whoever computes it",
                                            "Remove the store of the machine or program that is not to be trusted."});
    }

private:
    fs::path file_;
    const Study& study_;
    std::optional<Store> store_;
    std::optional<Statement> rows_;  // ends before the store
    std::size_t index_ = 0;
    bool has_begun_ = false;
};

// so many stores may be open beside what else this process has open
std::size_t allowed_stores() {
    rlimit files{};
    if (::getrlimit(RLIMIT_NOFILE, &files) != 0) return 2;
    return static_cast<std::size_t>(std::min<rlim_t>(files.rlim_cur, std::numeric_limits<int>::max())) / 2;
}

// the sources that are open: where there are too many, the one that was used longest ago is closed
class OpenSources {
public:
    explicit OpenSources(std::size_t most) : most_(std::max<std::size_t>(2, most)) {}

    MergeSource& opened(MergeSource& source) {
        if (!sources_.empty() && sources_.back() == &source) return source;
        const auto place = std::find(sources_.begin(), sources_.end(), &source);
        if (place != sources_.end()) {
            std::rotate(place, place + 1, sources_.end());
            return source;
        }
        if (sources_.size() == most_) close(*sources_.front());
        source.open();
        sources_.push_back(&source);
        return source;
    }

    void close(MergeSource& source) {
        source.close();
        sources_.erase(std::find(sources_.begin(), sources_.end(), &source));
    }

private:
    std::size_t most_;
    std::vector<MergeSource*> sources_;  // the one that was used last at the end
};

// a store that is written in index order under another name until it is whole
class NewStore {
public:
    NewStore(fs::path file, const std::string& mark, const Study& study)
        : file_(std::move(file)),
          name_(storage::unfinished_name(file_, mark)) {
        database_ = std::make_unique<storage::Database>(name_, store_options());
        // nothing of it is needed unless all of it is there
        database_->execute("PRAGMA journal_mode = MEMORY");
        database_->execute("PRAGMA synchronous = OFF");
        transaction_ = std::make_unique<Transaction>(*database_);
        create_tables(*database_, canonical_text(study));
        insert_ = std::make_unique<Statement>(database_->prepare(insert_cell()));
    }
    ~NewStore() {
        close();
        std::error_code ignored;
        fs::remove(name_, ignored);
    }
    NewStore(const NewStore&) = delete;
    NewStore& operator=(const NewStore&) = delete;

    void add(const Statement& row) {
        const int columns = static_cast<int>(cell_columns_count());
        for (int column = 0; column < columns; ++column)
            insert_->bind_column(column + 1, row, column);
        insert_->run();
    }

    void keep() {
        insert_.reset();
        transaction_->commit();
        close();
        const std::string shown = "the store " + file_.string();
        storage::Descriptor written(::open(name_.c_str(), O_RDWR | O_CLOEXEC));
        if (!written.is_open()) throw storage::system_failure("write", shown, errno);
        storage::flush(written.number(), shown);
        written.close(shown);
        if (std::rename(name_.c_str(), file_.c_str()) != 0) throw storage::system_failure("write", shown, errno);
        storage::flush_folder(file_.parent_path(), shown);
    }

private:
    fs::path file_;
    fs::path name_;
    std::unique_ptr<storage::Database> database_;
    std::unique_ptr<Transaction> transaction_;
    std::unique_ptr<Statement> insert_;

    void close() {
        insert_.reset();
        transaction_.reset();
        database_.reset();
    }
};

struct Later {
    bool operator()(const MergeSource* a, const MergeSource* b) const { return a->index() > b->index(); }
};

// shows the rows of all sources in index order, each cell once
template <typename Use>
void visit_all(std::vector<std::unique_ptr<MergeSource>>& sources, std::size_t cells, OpenSources open, Use&& use) {
    std::priority_queue<MergeSource*, std::vector<MergeSource*>, Later> queue;
    const auto go_on = [&](MergeSource& source) {
        if (!open.opened(source).next()) return open.close(source);
        if (source.index() >= cells)
            throw no_cell_of_the_study(source.file(), static_cast<std::int64_t>(source.index()));
        queue.push(&source);
    };
    const auto next = [&]() -> MergeSource& {
        MergeSource& source = *queue.top();
        queue.pop();
        return open.opened(source);
    };
    for (const std::unique_ptr<MergeSource>& source : sources)
        go_on(*source);
    while (!queue.empty()) {
        MergeSource& first = next();
        while (!queue.empty() && queue.top()->index() == first.index()) {
            MergeSource& other = next();
            open.opened(first).expect_same(open.opened(other));
            go_on(other);
        }
        use(open.opened(first));
        go_on(first);
    }
}

// says how far it is, and ends it on request
class Reporter {
public:
    Reporter(const MergeOptions& options, std::size_t cells) : options_(options), cells_(cells) {}

    void note(std::size_t index) {
        if (++rows_ % rows_per_look != 0) return;
        if (options_.stop.stop_requested())
            throw Error(ErrorKind::interrupted,
                        {"the merge was stopped", "everything is as it was before", "Run the same command again."});
        const auto now = std::chrono::steady_clock::now();
        if (!options_.progress || now - reported_ < report_tick) return;
        reported_ = now;
        options_.progress(static_cast<double>(index) / static_cast<double>(cells_));
    }

private:
    const MergeOptions& options_;
    std::size_t cells_;
    std::size_t rows_ = 0;
    std::chrono::steady_clock::time_point reported_;
};

int mark_in(const Study& study, const MergeSource& source, std::size_t cells) {
    if (study.refine == 0) return 0;
    const std::optional<IndexedCell> cell = cell_in(source.row(), cells);
    if (!cell) throw no_cell_of_the_study(source.file(), static_cast<std::int64_t>(source.index()));
    return mark_of(study, cell->cell);
}

}  // namespace

std::vector<ShareStore> share_stores(const fs::path& folder) {
    std::vector<ShareStore> found;
    std::error_code missing;
    for (const fs::directory_entry& entry : fs::directory_iterator(shares_folder(folder), missing)) {
        if (entry.path().extension() != ".sqlite") continue;
        ShareStore store{entry.path(), share_of_file_name(entry.path().stem().string())};
        const std::optional<storage::SeenOwner> owner = storage::owner_of(entry.path());
        store.is_filled = owner && storage::may_be_alive(*owner);
        found.push_back(std::move(store));
    }
    std::sort(found.begin(), found.end(), [](const ShareStore& a, const ShareStore& b) { return a.file < b.file; });
    return found;
}

MergeReport merge(const Study& study, const fs::path& folder, const MergeOptions& options) {
    const fs::path merged = folder / "chart.sqlite";
    storage::OwnerOptions claim = owner_options(merged);
    claim.wait = options.wait;
    claim.has_lock = false;  // the merged store is another file than the one that is there
    storage::OwnerFile owner(merged, claim);
    take_over_files(owner, merged);
    owner.end_change();  // the one that is there stays as it is until another takes its name
    MergeReport report;
    report.shares = share_stores(folder);
    const std::size_t cells = cell_count(study);
    std::vector<int> marks(cells, unknown_mark);
    std::vector<std::unique_ptr<MergeSource>> sources;
    // a store of an unknown name would be there by mistake, and is looked at all the same
    for (const ShareStore& store : report.shares)
        if (!store.is_filled) sources.push_back(std::make_unique<MergeSource>(store.file, study));
    if (fs::exists(merged)) sources.push_back(std::make_unique<MergeSource>(merged, study));
    NewStore written(merged, owner.mark(), study);
    Reporter reporter(options, cells);
    visit_all(sources, cells, OpenSources(std::min(options.most_open, allowed_stores())),
              [&](const MergeSource& source) {
                  marks[source.index()] = mark_in(study, source, cells);
                  written.add(source.row());
                  ++report.cells;
                  reporter.note(source.index());
              });
    // where the locks of another machine are not seen somebody may have begun meanwhile
    for (const ShareStore& store : report.shares)
        if (!store.is_filled) storage::expect_not_filled(store.file, owner_options(store.file));
    owner.begin_change();
    written.keep();
    report.missing = refine(study, marks).missing;
    const std::size_t points = cells / study.directions.size();
    for (const std::size_t run : report.missing)
        for (std::size_t k = 0; k < directions_per_run(study); ++k)
            report.missing_cells += marks[run + k * points] == unknown_mark ? 1 : 0;
    return report;
}

}  // namespace stridor::sweep
