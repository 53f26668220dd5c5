#include "stridor/storage/owner_file.hpp"

#include "stridor/base/error.hpp"
#include "stridor/storage/owner_draft.hpp"
#include "stridor/storage/owner_text.hpp"
#include "stridor/storage/system_io.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <utility>

namespace stridor::storage {

namespace fs = std::filesystem;

namespace {

// by a clock that goes on while the machine sleeps
std::int64_t now_ms() {
    timespec now{};
    ::clock_gettime(CLOCK_BOOTTIME, &now);
    return std::int64_t{now.tv_sec} * 1000 + now.tv_nsec / 1'000'000;
}

std::string this_host() {
    std::array<char, 256> host{};
    if (::gethostname(host.data(), host.size() - 1) != 0) return "unknown";
    return host.data();
}

Owner this_process(const OwnerOptions& options) {
    const char* job = std::getenv("SLURM_JOB_ID");
    return {options.host.empty() ? this_host() : options.host, ::getpid(), job == nullptr ? "" : job, new_mark(), 0};
}

bool is_silent(const SeenOwner& seen, const OwnerOptions& options) {
    return seen.silence > std::chrono::duration<double>(options.patience).count();
}

// may the owner be replaced or removed? One at a time may; who died meanwhile is not waited for
class Turn {
public:
    Turn(const fs::path& owner, const Draft& draft, const Owner& self, const OwnerOptions& options)
        : name_(owner.string() + ".lock"),
          is_mine_(link_to(draft, name_, options.shown)) {
        if (is_mine_) return;
        const std::optional<SeenOwner> other = seen_at(name_, draft.time());
        // an own one could not be removed
        is_mine_ = other && other->owner.mark == self.mark;
        if (other && !is_mine_ && !may_be_alive(*other, options)) remove_name(name_);
    }
    ~Turn() {
        if (is_mine_) remove_name(name_);
    }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

    bool is_mine() const { return is_mine_; }

private:
    fs::path name_;
    bool is_mine_;
};

Error refusal(const SeenOwner& seen, const std::string& shown) {
    return Error(ErrorKind::io, {shown + " is in use",
                                 text_of(seen.owner) + " fills it, and was last heard of " + ago_text(seen.silence),
                                 "Wait until that ends, or choose another --out."});
}

void pause() {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

}  // namespace

fs::path owner_file_of(const fs::path& file) {
    return file.string() + ".owner";
}

std::optional<SeenOwner> owner_of(const fs::path& file) {
    const fs::path name = owner_file_of(file);
    if (!fs::exists(name)) return std::nullopt;
    const Draft draft(name, owner_text(this_process({})), name.string());
    // in a folder where nothing can be made the own clock must do
    const std::chrono::duration<double> now = std::chrono::system_clock::now().time_since_epoch();
    return seen_at(name, draft.failure() == 0 ? draft.time() : now.count());
}

bool may_be_alive(const SeenOwner& seen, const OwnerOptions& options) {
    if (is_silent(seen, options)) return false;
    const bool is_here = seen.owner.host == (options.host.empty() ? this_host() : options.host);
    return !is_here || ::kill(static_cast<pid_t>(seen.owner.process), 0) == 0 || errno != ESRCH;
}

void expect_not_filled(const fs::path& file, const OwnerOptions& options) {
    const std::optional<SeenOwner> seen = owner_of(file);
    const bool is_self = seen && seen->owner.host == this_host() && seen->owner.process == ::getpid();
    if (seen && !is_self && may_be_alive(*seen, options)) throw refusal(*seen, options.shown);
}

OwnerFile::OwnerFile(fs::path file, OwnerOptions options)
    : file_(std::move(file)),
      name_(owner_file_of(file_)),
      options_(std::move(options)) {
    self_ = this_process(options_);
    claim(Neighbour::left_to_the_lock);
}

OwnerFile::~OwnerFile() {
    heart_ = {};
    if (!is_own_ || is_lost_) return;
    try {
        const Draft draft(name_, owner_text(self_), options_.shown);
        for (int tries = 0; draft.failure() == 0 && tries < 100; ++tries) {
            const Turn turn(name_, draft, self_, options_);
            if (!turn.is_mine()) {
                pause();
                continue;
            }
            const std::optional<SeenOwner> seen = seen_at(name_, 0.0);
            if (seen && seen->owner.mark == self_.mark) remove_name(name_);
            return;
        }
    } catch (const std::exception&) {
        // it grows old, and whoever comes next takes over
    }
}

void OwnerFile::confirm() {
    claim(Neighbour::replaced);
}

// Until somebody is named: this one, or one of this host with whom the lock decides.
void OwnerFile::claim(Neighbour neighbour) {
    while (!is_own_) {
        const Draft draft(name_, owner_text(self_), options_.shown);
        const int failure = draft.failure();
        if (failure != 0) {
            // without a folder there is nothing to be claimed, as whoever opens the file will say
            if (failure == ENOENT || failure == ENOTDIR) return;
            const bool is_only_read = failure == EACCES || failure == EROFS || failure == EPERM;
            if (is_only_read && fs::exists(file_)) return;
            throw system_failure("write", options_.shown, failure);
        }
        if (link_to(draft, name_, options_.shown)) break;
        const std::optional<SeenOwner> seen = seen_at(name_, draft.time());
        if (!seen) continue;
        const bool is_neighbour = seen->owner.host == self_.host;
        if (!is_silent(*seen, options_)) {
            const bool is_refused = !is_neighbour || (!options_.has_lock && may_be_alive(*seen, options_));
            if (is_refused) throw refusal(*seen, options_.shown);
            if (options_.has_lock && neighbour == Neighbour::left_to_the_lock) return;
        }
        const Turn turn(name_, draft, self_, options_);
        const std::optional<SeenOwner> still = seen_at(name_, draft.time());
        if (turn.is_mine() && still && still->owner.mark == seen->owner.mark &&
            (is_neighbour || is_silent(*still, options_))) {
            if (::rename(draft.name().c_str(), name_.c_str()) != 0) {
                if (errno == ENOENT) continue;  // it stood still until somebody removed the draft
                throw system_failure("write", options_.shown, errno);
            }
            replaced_ = still;
            break;
        }
        pause();
    }
    if (heart_.joinable()) return;
    if (const std::optional<SeenOwner> own = seen_at(name_, 0.0)) remove_left_drafts(name_, self_.host, -own->silence);
    is_own_ = true;
    last_beat_ = now_ms();
    heart_ = std::jthread([this](const std::stop_token& stop) { live(stop); });
}

void OwnerFile::live(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested() && !is_lost_) {
        // nobody notifies: it wakes after its time, or at once at the end
        changed_.wait_for(lock, stop, options_.heartbeat, [] { return false; });
        if (!stop.stop_requested()) beat();
    }
}

// Called with the mutex held: tells how far it is; false, with the system's number of why, if that failed.
bool OwnerFile::beat() {
    const Descriptor opened(::open(name_.c_str(), O_RDWR | O_CLOEXEC));
    if (!opened.is_open() && errno != ENOENT) return false;  // the disk may come back; silence is noticed by others
    std::array<char, longest_owner_text> text{};
    const ssize_t size = opened.is_open() ? ::read(opened.number(), text.data(), text.size()) : 0;
    if (size < 0) return false;
    is_lost_ = read_owner({text.data(), static_cast<std::size_t>(size)}).mark != self_.mark;
    if (is_lost_) return false;
    // of the same length, so that nobody finds half of it; another file that has the name by now is not touched
    Owner owner = self_;
    owner.count = count_;
    owner.changes = changes_;
    const std::string told = owner_text(owner);
    const ssize_t written = ::pwrite(opened.number(), told.data(), told.size(), 0);
    const bool is_told = written == static_cast<ssize_t>(told.size());
    const int code = written < 0 ? errno : ENOSPC;
    // a full disk may still know the time
    if (is_told || ::futimens(opened.number(), nullptr) == 0) last_beat_ = now_ms();
    errno = code;
    return is_told;
}

void OwnerFile::expect_own() {
    const std::scoped_lock lock(mutex_);
    if (!is_own_) return;
    if (!is_lost_ && now_ms() - last_beat_ > 3 * options_.heartbeat.count()) beat();
    if (!is_lost_) return;
    const std::optional<SeenOwner> seen = owner_of(file_);
    throw Error(ErrorKind::io, {options_.shown + " is no longer this process's",
                                seen ? text_of(seen->owner) + " has taken it over" : name_.string() + " was removed",
                                "What was kept before is there: run the same command again once nobody fills it."});
}

void OwnerFile::tell(std::uint64_t count) {
    const std::scoped_lock lock(mutex_);
    count_ = count;
}

void OwnerFile::begin_change() {
    const std::scoped_lock lock(mutex_);
    changes_ |= 1U;
    // one that was lost is nobody's to look at, as `expect_own` will say
    if (is_own_ && !beat() && !is_lost_) throw system_failure("write", name_.string(), errno);
}

void OwnerFile::end_change() {
    const std::scoped_lock lock(mutex_);
    changes_ += changes_ & 1U;
    // where it cannot be told others wait for the next one
    if (is_own_) beat();
}

}  // namespace stridor::storage
