#include "stridor/noise_library/add_recordings.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/hash.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <span>
#include <tuple>

namespace stridor::noise_library {

namespace {

// changes with every write to the file
auto state_of(const std::filesystem::path& file) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) throw storage::system_failure("read", file.string(), errno);
    if (!S_ISREG(status.st_mode))
        throw Error(ErrorKind::input, {file.string() + " is no file", "a recording is copied into the library", ""});
    return std::tuple(status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec, status.st_ino);
}

// a name that can be printed and stored as one line of text
std::string name_of(const std::filesystem::path& file) {
    std::string name = file.filename().string();
    std::replace_if(
        name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
    return name;
}

/// An error of a file, which is refused; those of the library end it all.
struct Refusal {
    Error error;
};

// what goes wrong in there is the file's fault
template <typename Work>
auto with(const Work& work) {
    try {
        return work();
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::interrupted) throw;
        throw Refusal{error};
    }
}

void take(Library& library, const std::filesystem::path& file, const Adding& adding, Arrivals& arrivals) {
    if (adding.known == Known::skipped) {
        const std::string hash = with([&] { return audio_hash(file); });
        const std::optional<std::int64_t> twin = library.entry_with(hash);
        if (twin) return arrivals.known.push_back({file.string(), *twin});
    }
    const Recording recording{file, adding.given,
                              adding.known == Known::skipped ? Twins::refuse_same_audio : Twins::accept};
    try {
        const Entry entry = add_recording(
            library, recording, [&](const auto& path, Entry& each) { with([&] { adding.probe(path, each); }); });
        arrivals.added.push_back(entry.id);
        adding.added(entry);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::input) throw;
        throw Refusal{error};  // it changed meanwhile, or another process was quicker
    }
}

void add_all(Library& library, const recordings::RecordingFiles& files, const Adding& adding, Arrivals& arrivals) {
    for (const std::filesystem::path& file : files.files) {
        go_on(adding.stop, arrivals.left);
        adding.begin(file);
        try {
            take(library, file, adding, arrivals);
        } catch (const Refusal& refusal) {
            if (adding.refused == Refused::thrown) throw Error(refusal.error);
            arrivals.refused.push_back({file.string(), recordings::refusal_reason(file.string(), refusal.error)});
        }
        adding.end();
        --arrivals.left;
    }
    // of those named, not of folders: what stays behind there is said, too
    const std::size_t all = files.files.size() + files.unreadable.size();
    if (!arrivals.refused.empty())
        throw Error(ErrorKind::input,
                    {fmt::format("refused {} of {} recording{}", arrivals.refused.size(), all, all == 1 ? "" : "s"), "",
                     "What could be added is in; the same command again tries these alone."});
}

}  // namespace

Entry add_recording(Library& library, const Recording& recording, const Probe& probe) {
    const auto before = state_of(recording.file);
    Entry entry = recording.given;
    entry.file = name_of(recording.file);
    probe(recording.file, entry);

    Intake intake(library.audio_folder());
    std::vector<Staged> staged;
    FilePieces pieces(recording.file);
    staged.push_back(intake.stage(format_of(recording.file), [&] { return pieces(); }));
    if (state_of(recording.file) != before)
        throw Error(ErrorKind::input, {recording.file.string() + " changed while it was added",
                                       "it is still being written", "Add it once its recording has ended."});
    entry.audio = staged.front().name.hash;
    entry.format = staged.front().name.format;
    entry.id = library.add(intake, staged, std::span(&entry, 1), recording.twins).front();
    return entry;
}

std::string audio_hash(const std::filesystem::path& file) {
    static_cast<void>(state_of(file));  // a pipe would keep its reader for ever
    base::Sha256 hash;
    FilePieces pieces(file);
    for (std::string_view piece = pieces(); !piece.empty(); piece = pieces())
        hash.add(piece);
    return hash.text();
}

Added add_recordings(Library& library, const recordings::RecordingFiles& files, const Adding& adding) {
    Added result;
    result.arrivals.passed_over = files.passed_over;
    result.arrivals.refused = files.unreadable;
    result.arrivals.left = files.files.size();
    try {
        add_all(library, files, adding, result.arrivals);
    } catch (const Error&) {
        result.ended_by = std::current_exception();
    }
    return result;
}

void go_on(const std::stop_token& stop, std::size_t left) {
    if (stop.stop_requested())
        throw Error(ErrorKind::interrupted, {fmt::format("stopped before {} file{}", left, left == 1 ? "" : "s"),
                                             "what was added stays", "The same command again goes on."});
}

}  // namespace stridor::noise_library
