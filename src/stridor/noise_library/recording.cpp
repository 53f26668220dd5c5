#include "stridor/noise_library/recording.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/sha256.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <span>
#include <tuple>
#include <vector>

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

}  // namespace stridor::noise_library
