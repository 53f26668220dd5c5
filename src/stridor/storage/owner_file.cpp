#include "stridor/storage/owner_file.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/process.hpp"
#include "stridor/storage/owner_draft.hpp"
#include "stridor/storage/system_io.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <system_error>
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

bool is_running(const Owner& owner) {
    return owner.process > 0 && (::kill(static_cast<pid_t>(owner.process), 0) == 0 || errno != ESRCH);
}

Error refusal(const OwnerLook& look, const fs::path& name, const std::string& shown) {
    const std::string unread =
        look.problem.empty() ? "" : "; " + name.string() + ", which says who, cannot be read: " + look.problem;
    return Error(ErrorKind::io,
                 {shown + " is in use",
                  text_of(look.seen.owner) + " fills it, and was last heard of " + ago_text(look.seen.silence) + unread,
                  "Wait until that ends, or choose another --out."});
}

// a folder, say, where a file should be that tells who fills the file
void expect_out_of_the_way(const OwnerLook& look, const fs::path& name, const std::string& shown) {
    if (look.found != OwnerLook::Found::other_thing) return;
    throw Error(ErrorKind::io, {"nobody can fill " + shown,
                                "who does so says it in " + name.string() + ", and " + look.problem, "Remove that."});
}

// may the owner be replaced or removed? One at a time may. Who died meanwhile is not waited for, nor who has stood
// still for so long by this machine's clock as an owner may
class Turn {
public:
    Turn(const fs::path& owner, const Draft& draft, const Owner& self, const OwnerOptions& options, Unchanged& watched)
        : name_(owner.string() + ".lock"),
          is_mine_(link_to(draft, name_, options.shown)) {
        if (is_mine_) return;
        const OwnerLook look = look_at(name_, draft.time());
        expect_out_of_the_way(look, name_, options.shown);
        if (look.found == OwnerLook::Found::nothing) return;
        // an own one could not be removed
        is_mine_ = look.seen.owner.mark == self.mark;
        const auto same = watched.look(look.state);
        const bool is_over = !may_be_alive(look.seen, options) || (same && *same > options.patience);
        if (!is_mine_ && is_over) remove_name(name_);
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

}  // namespace

fs::path owner_file_of(const fs::path& file) {
    return file.string() + ".owner";
}

namespace {

// at a file's owner, by the clock of the file system
OwnerLook look_at_owner(const fs::path& name) {
    const OwnerLook first = look_at(name, 0.0);
    if (first.found == OwnerLook::Found::nothing || first.found == OwnerLook::Found::other_thing) return first;
    const Draft draft(name, owner_text(this_process({})), name.string());
    // in a folder where nothing can be made the own clock must do
    const std::chrono::duration<double> now = std::chrono::system_clock::now().time_since_epoch();
    return look_at(name, draft.failure() == 0 ? draft.time() : now.count());
}

bool names_somebody(const OwnerLook& look) {
    return look.found == OwnerLook::Found::owner || look.found == OwnerLook::Found::unreadable;
}

}  // namespace

std::optional<SeenOwner> owner_of(const fs::path& file) {
    const OwnerLook look = look_at_owner(owner_file_of(file));
    return names_somebody(look) ? std::optional(look.seen) : std::nullopt;
}

bool is_of_this_host(const Owner& owner) {
    return owner.host == this_host();
}

bool may_be_alive(const SeenOwner& seen, const OwnerOptions& options) {
    if (is_silent(seen, options)) return false;
    const bool is_here = seen.owner.host == (options.host.empty() ? this_host() : options.host);
    return !is_here || is_running(seen.owner);
}

void expect_not_filled(const fs::path& file, const OwnerOptions& options) {
    const OwnerLook look = look_at_owner(owner_file_of(file));
    const bool is_self = look.seen.owner.host == this_host() && look.seen.owner.process == ::getpid();
    if (names_somebody(look) && !is_self && may_be_alive(look.seen, options))
        throw refusal(look, owner_file_of(file), options.shown);
}

OwnerFile::OwnerFile(fs::path file, OwnerOptions options)
    : file_(std::move(file)),
      name_(owner_file_of(file_)),
      options_(std::move(options)) {
    self_ = this_process(options_);
    self_.has_lock = options_.has_lock;
    try {
        heart_ = std::jthread([this](const std::stop_token& stop) { live(stop); });
    } catch (const std::system_error& failure) {
        throw base::no_thread(failure);
    }
    claim(Neighbour::left_to_the_lock);
}

OwnerFile::~OwnerFile() {
    heart_ = {};
    if (!is_own_ || is_lost_) return;
    try {
        const Draft draft(name_, owner_text(self_), options_.shown);
        Waiting waiting({}, std::chrono::seconds(1));
        Unchanged turned;
        do {
            const Turn turn(name_, draft, self_, options_, turned);
            if (!turn.is_mine()) continue;
            const std::optional<SeenOwner> seen = seen_at(name_, 0.0);
            if (seen && seen->owner.mark == self_.mark) remove_name(name_);
            return;
        } while (draft.failure() == 0 && waiting.goes_on(options_.shown));
    } catch (const std::exception&) {
        // it grows old, and whoever comes next takes over
    }
}

void OwnerFile::confirm() {
    if (!may_change()) {
        // a neighbour had the lock before, and has let go of it
        const std::scoped_lock lock(mutex_);
        is_own_ = false;
        is_lost_ = false;
    }
    claim(Neighbour::replaced);
    if (!may_change()) fail_as_lost();
}

bool OwnerFile::may_change() {
    const std::scoped_lock lock(mutex_);
    if (is_own_ && !is_lost_) beat();
    return !is_lost_;
}

bool OwnerFile::may_be_in_other_hands() const {
    return replaced_ && (replaced_->owner.host != self_.host || !replaced_->owner.has_files);
}

void OwnerFile::settle() {
    const std::scoped_lock lock(mutex_);
    self_.has_files = true;
    if (is_own_) beat();
}

// Until somebody is named: this one, or one of this host with whom the lock decides.
void OwnerFile::claim(Neighbour neighbour) {
    Waiting waiting(options_.wait, 2 * options_.patience);
    Unchanged named;
    Unchanged turned;
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
        const OwnerLook look = look_at(name_, draft.time());
        expect_out_of_the_way(look, name_, options_.shown);
        const Standing standing =
            look.found == OwnerLook::Found::nothing ? Standing::gone : stand(look, neighbour, named);
        if (standing == Standing::left_to_the_lock) return;
        if (standing == Standing::at_work) throw refusal(look, name_, options_.shown);
        if (standing == Standing::over && replace(draft, look, turned)) break;
        const std::string whom = standing == Standing::unclear
                                     ? "a sign of life of " + text_of(look.seen.owner) + ", last heard of " +
                                           ago_text(look.seen.silence) + " by the clock of the file system"
                                     : "its turn to take over " + options_.shown;
        if (!waiting.goes_on(whom)) throw refusal(look, name_, options_.shown);
    }
    const std::scoped_lock lock(mutex_);
    if (is_own_) return;
    if (const std::optional<SeenOwner> own = seen_at(name_, 0.0)) remove_left_drafts(name_, self_.host, -own->silence);
    is_own_ = true;
    last_beat_ = now_ms();
}

OwnerFile::Standing OwnerFile::stand(const OwnerLook& look, Neighbour neighbour, Unchanged& named) const {
    const Owner& owner = look.seen.owner;
    const bool is_neighbour = look.found == OwnerLook::Found::owner && owner.host == self_.host;
    if (is_neighbour && options_.has_lock && owner.has_lock && owner.has_files)
        return neighbour == Neighbour::replaced ? Standing::over : Standing::left_to_the_lock;
    if (is_silent(look.seen, options_) || (is_neighbour && !is_running(owner))) return Standing::over;
    const bool is_from_the_future = look.seen.silence < -std::chrono::duration<double>(options_.patience).count();
    if (!is_from_the_future) return Standing::at_work;
    const auto same = named.look(look.state);
    if (!same) return Standing::at_work;
    return *same > options_.patience ? Standing::over : Standing::unclear;
}

// By a draft, with the one lock, if nothing has changed; false if not.
bool OwnerFile::replace(const Draft& draft, const OwnerLook& look, Unchanged& turned) {
    const Turn turn(name_, draft, self_, options_, turned);
    if (!turn.is_mine()) return false;
    const OwnerLook still = look_at(name_, draft.time());
    if (still.found != look.found || still.state != look.state || still.seen.owner.mark != look.seen.owner.mark)
        return false;
    const Owner& former = look.seen.owner;
    self_.has_files = former.host == self_.host && former.has_files;
    draft.rewrite(owner_text(self_));
    if (::rename(draft.name().c_str(), name_.c_str()) != 0) {
        if (errno == ENOENT) return false;  // it stood still until somebody removed the draft
        throw system_failure("write", options_.shown, errno);
    }
    replaced_ = look.seen;
    return true;
}

void OwnerFile::live(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
        // nobody notifies: it wakes after its time, or at once at the end
        changed_.wait_for(lock, stop, options_.heartbeat, [] { return false; });
        if (!stop.stop_requested() && is_own_ && !is_lost_) beat();
    }
}

// Called with the mutex held: tells how far it is; false, with the system's number of why, if that failed.
bool OwnerFile::beat() {
    const Descriptor opened(::open(name_.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    const bool is_gone = errno == ENOENT || errno == ELOOP || errno == EISDIR || errno == ENXIO;
    if (!opened.is_open() && !is_gone) return false;  // the disk may come back; silence is noticed by others
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

void OwnerFile::fail_as_lost() const {
    const std::optional<SeenOwner> seen = owner_of(file_);
    throw Error(ErrorKind::io, {options_.shown + " is no longer this process's",
                                seen ? text_of(seen->owner) + " has taken it over" : name_.string() + " was removed",
                                "What was kept before is there: run the same command again once nobody fills it."});
}

void OwnerFile::expect_own() {
    const std::scoped_lock lock(mutex_);
    if (!is_own_) return;
    if (!is_lost_ && now_ms() - last_beat_ > 3 * options_.heartbeat.count()) beat();
    if (is_lost_) fail_as_lost();
}

void OwnerFile::tell(std::uint64_t count) {
    const std::scoped_lock lock(mutex_);
    count_ = count;
}

void OwnerFile::begin_change() {
    const std::scoped_lock lock(mutex_);
    changes_ |= 1U;
    if (!is_own_ || beat()) return;
    if (is_lost_) fail_as_lost();
    throw system_failure("write", name_.string(), errno);
}

void OwnerFile::end_change() {
    const std::scoped_lock lock(mutex_);
    changes_ += changes_ & 1U;
    // where it cannot be told others wait for the next one
    if (is_own_ && !beat() && is_lost_) fail_as_lost();
}

}  // namespace stridor::storage
