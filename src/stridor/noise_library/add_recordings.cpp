#include "stridor/noise_library/add_recordings.hpp"

#include "stridor/base/error.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>

namespace stridor::noise_library {

namespace {

/// An error of a file, which is refused; those of the library end it all.
struct Refusal {
    Error error;
};

// "run.csv:12: the file is empty"
std::string reason_of(const std::string& file, const Error& error) {
    const base::Problem& problem = error.problem();
    const std::string place = error.place() ? base::describe(*error.place()) : file;
    const std::string why = problem.why.empty() ? "" : " (" + problem.why + ")";
    return (problem.what.find(file) == std::string::npos ? place + ": " : "") + problem.what + why;
}

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
            arrivals.refused.push_back({file.string(), reason_of(file.string(), refusal.error)});
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
