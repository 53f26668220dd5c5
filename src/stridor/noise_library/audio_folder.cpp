#include "stridor/noise_library/audio_folder.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/hash.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <memory>
#include <system_error>
#include <utility>

namespace stridor::noise_library {

namespace fs = std::filesystem;

namespace {

constexpr const char* marker_extension = ".marker";

fs::path incoming(const fs::path& audio_folder) {
    return audio_folder / "incoming";
}

// a folder that the disk remembers, too
void make_folder(const fs::path& folder) {
    std::error_code error;
    const bool is_new = fs::create_directory(folder, error);
    if (error) throw storage::system_failure("make the folder", folder.string(), error.value());
    if (is_new) storage::flush_folder(folder.parent_path(), folder.string());
}

/// A marker that was locked without waiting: its owner is dead.
class DeadMarker {
public:
    // empty if the owner lives or the file is gone
    static std::unique_ptr<DeadMarker> taken(const fs::path& file) {
        const int descriptor = ::open(file.c_str(), O_RDWR | O_CLOEXEC);
        if (descriptor < 0) return nullptr;
        auto marker = std::unique_ptr<DeadMarker>(new DeadMarker(descriptor, file));
        return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 ? std::move(marker) : nullptr;
    }
    ~DeadMarker() { ::close(descriptor_); }
    DeadMarker(const DeadMarker&) = delete;
    DeadMarker& operator=(const DeadMarker&) = delete;

    const fs::path& file() const { return file_; }

    // the audio it was about to place or remove
    std::vector<AudioName> names() const {
        std::vector<AudioName> names;
        std::ifstream stream(file_);
        for (AudioName name; stream >> name.hash >> name.format;)
            // a line may be cut short
            if (is_audio_name(name)) names.push_back(name);
        return names;
    }

private:
    DeadMarker(int descriptor, fs::path file) : descriptor_(descriptor), file_(std::move(file)) {}

    int descriptor_;
    fs::path file_;
};

std::vector<fs::path> files_in(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::directory_iterator each(folder, error), end; !error && each != end; each.increment(error))
        files.push_back(each->path());
    return files;
}

std::vector<std::unique_ptr<DeadMarker>> dead_markers(const std::vector<fs::path>& files) {
    std::vector<std::unique_ptr<DeadMarker>> dead;
    for (const fs::path& file : files)
        if (file.extension() == marker_extension)
            if (auto marker = DeadMarker::taken(file)) dead.push_back(std::move(marker));
    return dead;
}

// "123-0" of "123-0.7.part" and of "123-0.marker"
std::string owner_of(const fs::path& file) {
    const std::string name = file.filename().string();
    return name.substr(0, name.find('.'));
}

// a part whose process has withdrawn its marker, or lost it with the power; a marker stands before its
// parts and after them
bool is_abandoned(const fs::path& file) {
    std::error_code error;
    fs::path marker = file.parent_path() / (owner_of(file) + marker_extension);
    return file.extension() != marker_extension && !fs::exists(marker, error) && !error;
}

// is it gone? What cannot be removed stays a leftover, and the next to open the library tries again
bool remove_leftover(const fs::path& file) {
    std::error_code error;
    fs::remove(file, error);
    return !error;
}

}  // namespace

bool is_audio_name(const AudioName& name) {
    const auto is_hex = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
    return name.hash.size() == 64 && std::all_of(name.hash.begin(), name.hash.end(), is_hex) &&
           format_of("x." + name.format) == name.format;
}

fs::path path_of(const AudioName& name) {
    // a damaged or hostile database may say anything, and a path is made of it
    if (!is_audio_name(name))
        throw Error(ErrorKind::io, {"an entry of the library is damaged", "it does not name its audio",
                                    "Restore the library from a copy or an export."});
    return fs::path(name.hash.substr(0, 2)) / (name.hash + "." + name.format);
}

std::string format_of(const fs::path& file) {
    std::string extension = file.extension().string();
    if (!extension.empty()) extension.erase(0, 1);
    for (char& c : extension) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
        if (!((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'))) return "audio";
    }
    return extension.empty() || extension.size() > 8 ? "audio" : extension;
}

Marker::Marker(const fs::path& audio_folder) {
    make_folder(audio_folder);
    make_folder(incoming(audio_folder));
    for (int number = 0;; ++number) {
        file_ = incoming(audio_folder) / (std::to_string(::getpid()) + "-" + std::to_string(number) + marker_extension);
        descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor_ < 0 && errno == EEXIST) continue;
        if (descriptor_ < 0) throw storage::system_failure("write", incoming(audio_folder).string(), errno);
        // somebody may have taken it for a dead one before it was locked, and is not waited for
        const bool is_taken = ::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
        struct stat status {};
        if (!is_taken && ::fstat(descriptor_, &status) == 0 && status.st_nlink > 0) break;
        ::close(descriptor_);
    }
    storage::flush_folder(incoming(audio_folder), incoming(audio_folder).string());
}

Marker::~Marker() {
    if (!is_held_) ::unlink(file_.c_str());
    ::close(descriptor_);
}

void Marker::announce(const std::set<AudioName>& names) {
    std::string text;
    for (const AudioName& name : names)
        text += name.hash + " " + name.format + "\n";
    is_held_ = true;
    storage::write_all(descriptor_, text, file_.parent_path().string());
    storage::flush(descriptor_, file_.parent_path().string());
}

fs::path Marker::temporary() {
    fs::path name = file_;
    return name.replace_extension("." + std::to_string(temporaries_++) + ".part");
}

Intake::Intake(fs::path audio_folder) : folder_(std::move(audio_folder)), marker_(folder_) {}

Staged Intake::stage(const std::string& format, const Pieces& pieces) {
    storage::NewFile file(marker_.temporary(), folder_.string());
    base::Sha256 hash;
    for (std::string_view piece = pieces(); !piece.empty(); piece = pieces()) {
        hash.add(piece);
        file.write(piece);
    }
    file.finish();
    const std::uint64_t size = file.size();
    return {{hash.text(), format}, size, std::move(file)};
}

void Intake::place(std::span<Staged> staged, const std::set<AudioName>& needed) {
    marker_.announce(needed);
    for (Staged& each : staged) {
        if (!needed.contains(each.name)) continue;
        const fs::path name = folder_ / path_of(each.name);
        make_folder(name.parent_path());
        // over a file of the same content, which this mends should it have been damaged
        each.file.keep(name);
    }
}

bool is_whole(const fs::path& file, const AudioName& name) {
    // a pipe or a device in a library from elsewhere would keep its reader for ever
    std::error_code error;
    if (fs::exists(file, error) && !fs::is_regular_file(file, error)) return false;
    base::Sha256 hash;
    FilePieces pieces(file);
    for (std::string_view piece = pieces(); !piece.empty(); piece = pieces())
        hash.add(piece);
    return hash.text() == name.hash;
}

bool has_leftovers(const fs::path& audio_folder) {
    const std::vector<fs::path> files = files_in(incoming(audio_folder));
    return !dead_markers(files).empty() || std::any_of(files.begin(), files.end(), is_abandoned);
}

void clear_leftovers(const fs::path& audio_folder, const std::function<bool(const AudioName&)>& is_used) {
    const std::vector<fs::path> files = files_in(incoming(audio_folder));
    const std::vector<std::unique_ptr<DeadMarker>> dead = dead_markers(files);
    bool is_clear = true;
    for (const fs::path& file : files) {
        const bool is_of_dead = std::any_of(dead.begin(), dead.end(), [&](const std::unique_ptr<DeadMarker>& marker) {
            return owner_of(marker->file()) == owner_of(file);
        });
        const bool is_left = is_of_dead ? file.extension() != marker_extension : is_abandoned(file);
        if (is_left && !remove_leftover(file)) is_clear = false;
    }
    for (const std::unique_ptr<DeadMarker>& marker : dead)
        for (const AudioName& name : marker->names())
            if (!is_used(name) && !remove_leftover(audio_folder / path_of(name))) is_clear = false;
    // last: should this process die here, the next one finds them and begins again
    for (const std::unique_ptr<DeadMarker>& marker : dead)
        if (is_clear) ::unlink(marker->file().c_str());
}

FilePieces::FilePieces(const fs::path& file)
    : file_(file),
      descriptor_(::open(file.c_str(), O_RDONLY | O_CLOEXEC)),
      block_(std::size_t{1} << 20U) {
    if (descriptor_ < 0) throw storage::system_failure("read", file.string(), errno);
}

FilePieces::~FilePieces() {
    ::close(descriptor_);
}

std::string_view FilePieces::operator()() {
    while (true) {
        const ssize_t count = ::read(descriptor_, block_.data(), block_.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw storage::system_failure("read", file_.string(), errno);
        return {block_.data(), static_cast<std::size_t>(count)};
    }
}

}  // namespace stridor::noise_library
