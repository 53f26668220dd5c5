#include "stridor/storage/owner_draft.hpp"

#include "stridor/base/error.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <random>
#include <span>
#include <system_error>

namespace stridor::storage {

namespace {

constexpr double minute = 60.0;  // [s]
constexpr double hour = 3600.0;  // [s]

template <typename Number>
Number number_in(std::string_view text) {
    Number number{};
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

}  // namespace

std::string owner_text(const Owner& owner) {
    return fmt::format(
        "host = {}\nprocess = {}\njob = {}\nmark = {}\nlock = {}\nfiles = {}\ncount = {:<20}\nchanges = {:<20}\n",
        owner.host.substr(0, 255), owner.process, owner.job.substr(0, 255), owner.mark,
        owner.has_lock ? "own " : "none", owner.has_files ? "own " : "left", owner.count, owner.changes);
}

Owner read_owner(std::string_view text) {
    Owner owner;
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(text.size(), line.size() + 1));
        const std::size_t sign = line.find(" = ");
        if (sign == std::string_view::npos) continue;
        const std::string_view key = line.substr(0, sign);
        const std::string_view value = line.substr(sign + 3);
        if (key == "host") owner.host = value;
        if (key == "process") owner.process = number_in<long>(value);
        if (key == "job") owner.job = value;
        if (key == "mark") owner.mark = value;
        if (key == "lock") owner.has_lock = value != "none";
        if (key == "files") owner.has_files = value != "left";
        if (key == "count") owner.count = number_in<std::uint64_t>(value);
        if (key == "changes") owner.changes = number_in<std::uint64_t>(value);
    }
    return owner;
}

std::string text_of(const Owner& owner) {
    if (owner.host.empty()) return "somebody unknown";
    return fmt::format("process {} of host {}", owner.process, owner.host) +
           (owner.job.empty() ? "" : ", job " + owner.job);
}

std::string ago_text(double silence) {
    // by clocks that differ
    if (silence < -2.0 * hour) return fmt::format("{:.0f} h from now", -silence / hour);
    if (silence < -minute) return fmt::format("{:.0f} min from now", -silence / minute);
    if (silence < 2.0 * minute) return fmt::format("{:.0f} s ago", silence < 0.0 ? 0.0 : silence);
    if (silence < 2.0 * hour) return fmt::format("{:.0f} min ago", silence / minute);
    return fmt::format("{:.0f} h ago", silence / hour);
}

namespace fs = std::filesystem;

namespace {

constexpr std::size_t mark_length = 16;       // [1] hexadecimal digits
constexpr double longest_making = 60.0 * 60;  // [s] a draft lives for milliseconds

double seconds(const timespec& time) {
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// a signal may come between
int open_new(const fs::path& name) {
    int number = -1;
    do
        number = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    while (number < 0 && errno == EINTR);
    return number;
}

// a name may be anybody's: no link is followed and no pipe is waited for
int open_existing(const fs::path& name) {
    int number = -1;
    do
        number = ::open(name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    while (number < 0 && errno == EINTR);
    return number;
}

ssize_t read_some(int number, std::span<char> into) {
    ssize_t size = -1;
    do
        size = ::read(number, into.data(), into.size());
    while (size < 0 && errno == EINTR);
    return size;
}

// in words, if it is no file
std::string other_thing(mode_t mode) {
    if (S_ISREG(mode)) return "";
    if (S_ISDIR(mode)) return "it is a folder";
    if (S_ISLNK(mode)) return "it is a link";
    if (S_ISFIFO(mode)) return "it is a pipe";
    return "it is no file";
}

bool is_draft(std::string_view name, std::string_view owner) {
    if (name.size() != owner.size() + 1 + mark_length || !name.starts_with(owner) || name[owner.size()] != '.')
        return false;
    return name.find_first_not_of("0123456789abcdef", owner.size() + 1) == std::string_view::npos;
}

}  // namespace

std::string new_mark() {
    std::random_device device;
    return fmt::format("{:08x}{:08x}", device(), device());
}

void remove_name(const fs::path& name) {
    while (::unlink(name.c_str()) != 0 && errno == EINTR) {
    }
}

OwnerLook look_at(const fs::path& name, double now) {
    struct stat status {};
    OwnerLook look;
    if (::lstat(name.c_str(), &status) != 0) {
        if (errno == ENOENT || errno == ENOTDIR) return look;
        look.found = OwnerLook::Found::unreadable;
        look.problem = reason_of(errno);
        return look;
    }
    look.problem = other_thing(status.st_mode);
    look.found = OwnerLook::Found::other_thing;
    if (!look.problem.empty()) return look;
    // opened, for then NFS asks the server for the time instead of remembering one
    const Descriptor opened(open_existing(name));
    look.found = OwnerLook::Found::nothing;
    if (!opened.is_open() && errno == ENOENT) return look;
    std::array<char, longest_owner_text> text{};
    const ssize_t size = opened.is_open() ? read_some(opened.number(), text) : -1;
    look.found = size < 0 ? OwnerLook::Found::unreadable : OwnerLook::Found::owner;
    if (size < 0)
        look.problem = reason_of(errno);
    else
        look.seen.owner = read_owner({text.data(), static_cast<std::size_t>(size)});
    if (opened.is_open()) ::fstat(opened.number(), &status);
    look.seen.silence = now - seconds(status.st_mtim);
    look.state =
        fmt::format("{} {} {}.{:09}", status.st_dev, status.st_ino, status.st_mtim.tv_sec, status.st_mtim.tv_nsec);
    return look;
}

std::optional<SeenOwner> seen_at(const fs::path& name, double now) {
    const OwnerLook look = look_at(name, now);
    return look.found == OwnerLook::Found::owner ? std::optional(look.seen) : std::nullopt;
}

Draft::Draft(const fs::path& owner, std::string_view text, const std::string& shown)
    : name_(owner.string() + "." + new_mark()),
      shown_(shown),
      file_(open_new(name_)) {
    code_ = file_.is_open() ? 0 : errno;
    if (!file_.is_open()) return;
    try {
        write_all(file_.number(), text, shown);
    } catch (const Error&) {
        remove_name(name_);
        throw;
    }
}

Draft::~Draft() {
    if (file_.is_open()) remove_name(name_);
}

void Draft::rewrite(std::string_view text) const {
    const ssize_t size = ::pwrite(file_.number(), text.data(), text.size(), 0);
    if (size != static_cast<ssize_t>(text.size())) throw system_failure("write", shown_, size < 0 ? errno : ENOSPC);
}

double Draft::time() const {
    struct stat status {};
    return ::fstat(file_.number(), &status) == 0 ? seconds(status.st_mtim) : 0.0;
}

bool link_to(const Draft& draft, const fs::path& name, const std::string& shown) {
    if (::link(draft.name().c_str(), name.c_str()) == 0) return true;
    const int code = errno;
    struct stat status {};
    // the link may be there all the same, and the answer have been lost on its way
    if (code == EEXIST) return ::stat(draft.name().c_str(), &status) == 0 && status.st_nlink == 2;
    if (code == ENOENT) return false;
    const bool knows_no_links = code == EPERM || code == EOPNOTSUPP || code == ENOSYS || code == EMLINK;
    if (!knows_no_links) throw system_failure("write", shown, code);
    // such a file system is none that machines share; of two copies one is made
    std::error_code exists;
    return fs::copy_file(draft.name(), name, exists);
}

void remove_left_drafts(const fs::path& owner, const std::string& host, double now) {
    OwnerOptions here;
    here.host = host;
    std::error_code ignored;
    const fs::path folder = owner.has_parent_path() ? owner.parent_path() : fs::path(".");
    for (fs::directory_iterator entry(folder, ignored), end; !ignored && entry != end; entry.increment(ignored)) {
        const fs::path& name = entry->path();
        if (!is_draft(name.filename().string(), owner.filename().string())) continue;
        const std::optional<SeenOwner> left = seen_at(name, now);
        if (!left) continue;
        // one that was not written yet is nobody's
        const bool is_neighbours = left->owner.host == host;
        const bool is_left = is_neighbours ? !may_be_alive({left->owner, 0.0}, here) : left->silence > longest_making;
        if (is_left) remove_name(name);
    }
}

}  // namespace stridor::storage
