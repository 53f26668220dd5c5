#include "stridor/storage/owner_draft.hpp"

#include "stridor/base/error.hpp"
#include "stridor/storage/owner_text.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <random>
#include <system_error>

namespace stridor::storage {

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

std::optional<SeenOwner> seen_at(const fs::path& name, double now) {
    // opened, for then NFS asks the server for the time instead of remembering one
    const Descriptor opened(::open(name.c_str(), O_RDONLY | O_CLOEXEC));
    struct stat status {};
    std::array<char, longest_owner_text> text{};
    if (!opened.is_open() || ::fstat(opened.number(), &status) != 0) return std::nullopt;
    const ssize_t size = ::read(opened.number(), text.data(), text.size());
    if (size < 0) return std::nullopt;
    const Owner owner = read_owner({text.data(), static_cast<std::size_t>(size)});
    return SeenOwner{owner, now - seconds(status.st_mtim)};
}

Draft::Draft(const fs::path& owner, std::string_view text, const std::string& shown)
    : name_(owner.string() + "." + new_mark()),
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
