#include "stridor/io/library/library_archive.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/hash.hpp"
#include "stridor/io/library/archive_manifest.hpp"
#include "stridor/io/sound/json_sound.hpp"
#include "stridor/noise_library/field.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <algorithm>
#include <map>
#include <system_error>
#include <utility>

namespace stridor::io {

namespace fs = std::filesystem;
using noise_library::AudioName;
using noise_library::Entry;
using noise_library::Library;
using noise_library::Staged;

namespace {

// sizes of the audio, each once
std::map<AudioName, std::uint64_t> sizes_of(const Library& library, std::span<const Entry> entries) {
    std::map<AudioName, std::uint64_t> sizes;
    for (const Entry& entry : entries) {
        const fs::path file = library.audio_file(entry);
        std::error_code error;
        const std::uint64_t size = fs::file_size(file, error);
        if (error)
            throw Error(
                ErrorKind::io,
                {"the audio of entry " + std::to_string(entry.id) + " cannot be read",
                 file.string() + ": " + error.message(),
                 "Bring the file back, or leave the entry out: --where \"id != " + std::to_string(entry.id) + "\"."});
        sizes.emplace(noise_library::audio_of(entry), size);
    }
    return sizes;
}

void write_audio(TarWriter& tar, const Library& library, const AudioName& audio, std::uint64_t size) {
    const fs::path file = library.audio_folder() / noise_library::path_of(audio);
    base::Sha256 hash;
    std::uint64_t written = 0;
    tar.begin({archive_member(audio), size});
    noise_library::FilePieces pieces(file);
    for (std::string_view piece = pieces(); !piece.empty(); piece = pieces()) {
        hash.add(piece);
        written += piece.size();
        tar.write(piece);
    }
    tar.end();
    if (written != size || hash.text() != audio.hash)
        throw Error(ErrorKind::io, {"the audio " + file.string() + " is damaged", "its bytes are not those of its name",
                                    "Add the recording again: that mends it."});
}

// by name in the archive: the audio, and its size; two entries may share one
using ExpectedAudio = std::map<std::string, std::pair<AudioName, std::uint64_t>>;

/// What a first reading of the manifest leaves in memory.
struct ArchiveContents {
    ExpectedAudio audio;
    std::vector<bool> is_heard_otherwise{};  // shape [entry]
    std::string digest;
};

// has the library an entry that differs from this one in the verdict by ear alone?
bool is_heard_otherwise(Library& library, const Entry& entry) {
    noise_library::Query query;
    query.conditions = {{"audio", noise_library::Comparison::equal, entry.audio}};
    query.extent = noise_library::EntryExtent::whole;
    const std::vector<Entry> known = library.find(query);
    const std::string whole = noise_library::digest(entry);
    const std::string words = noise_library::digest(without_verdict(entry));
    const auto is_equal = [&](const Entry& each) { return noise_library::digest(each) == whole; };
    const auto is_alike = [&](const Entry& each) { return noise_library::digest(without_verdict(each)) == words; };
    return std::none_of(known.begin(), known.end(), is_equal) && std::any_of(known.begin(), known.end(), is_alike);
}

ArchiveContents contents_of(Manifest& manifest, Library& library) {
    ArchiveContents contents;
    while (const std::optional<Announced> each = manifest.next()) {
        contents.audio.emplace(archive_member(noise_library::audio_of(each->entry)),
                               std::pair(noise_library::audio_of(each->entry), each->bytes));
        contents.is_heard_otherwise.push_back(is_heard_otherwise(library, each->entry));
    }
    contents.digest = manifest.digest();
    return contents;
}

std::vector<Staged> stage_audio(TarReader& tar, noise_library::Intake& intake, const fs::path& archive,
                                ExpectedAudio expected) {
    const auto refuse = [&](const std::string& why) {
        throw Error(ErrorKind::input, {archive.string() + " is damaged", why, "Ask for it again."});
    };
    std::vector<Staged> staged;
    while (const std::optional<TarMember> member = tar.next()) {
        const auto found = expected.find(member->name);
        if (found == expected.end()) refuse("no entry has the file " + member->name + ", or it is there twice");
        const auto& [audio, bytes] = found->second;
        if (bytes != member->size) refuse(member->name + " is not as long as its entry says");
        staged.push_back(intake.stage(audio.format, [&] { return tar.read(); }));
        if (staged.back().name != audio) refuse("the bytes of " + member->name + " are not those of its name");
        expected.erase(found);
    }
    if (!expected.empty()) refuse(expected.begin()->first + " is missing");
    return staged;
}

void expect_whole(const fs::path& archive) {
    TarReader tar(archive);
    expect_whole_manifest(tar, archive.string());
}

}  // namespace

void export_library(const Library& library, std::span<const Entry> entries, const fs::path& archive) {
    std::error_code error;
    if (fs::equivalent(archive, library.file(), error))
        throw Error(ErrorKind::input, {archive.string() + " is the library itself", "", "Choose another file."});
    const std::map<AudioName, std::uint64_t> sizes = sizes_of(library, entries);
    std::string manifest = manifest_opening(entries.size());
    for (const Entry& entry : entries)
        manifest += manifest_line(entry, sizes.at(noise_library::audio_of(entry)));
    manifest += manifest_closing(manifest);

    storage::PiecewiseFile file(archive.string());
    TarWriter tar(file);
    tar.begin({manifest_name, manifest.size()});
    tar.write(manifest);
    tar.end();
    for (const auto& [audio, size] : sizes)
        write_audio(tar, library, audio, size);
    tar.finish();
    file.commit();
}

std::vector<Entry> archived_entries(const fs::path& archive) {
    expect_whole(archive);
    TarReader tar(archive);
    Manifest manifest(tar, archive.string());
    std::vector<Entry> entries;
    while (std::optional<Announced> each = manifest.next())
        entries.push_back(std::move(each->entry));
    return entries;
}

std::vector<Staged> archived_audio(const fs::path& archive, noise_library::Intake& intake,
                                   std::span<const AudioName> wanted) {
    TarReader tar(archive);
    std::vector<Staged> staged;
    while (const std::optional<TarMember> member = tar.next())
        for (const AudioName& name : wanted) {
            if (member->name != archive_member(name)) continue;
            Staged audio = intake.stage(name.format, [&] { return tar.read(); });
            if (audio.name == name) staged.push_back(std::move(audio));
        }
    return staged;
}

Import import_library(Library& library, const fs::path& archive, const TarProgress& progress) {
    expect_whole(archive);
    TarReader tar(archive, progress);
    Manifest announced(tar, archive.string());
    const ArchiveContents contents = contents_of(announced, library);
    noise_library::Intake intake(library.audio_folder());
    std::vector<Staged> staged = stage_audio(tar, intake, archive, contents.audio);
    // the entries are read once more now that their audio is there, so that they never stand in memory together
    TarReader again(archive);
    Manifest manifest(again, archive.string());
    std::size_t place = 0;
    const auto next = [&]() -> std::optional<Entry> {
        while (std::optional<Announced> each = manifest.next()) {
            const bool is_known = place < contents.is_heard_otherwise.size() && contents.is_heard_otherwise[place];
            ++place;
            if (!is_known) return std::move(each->entry);
        }
        if (manifest.digest() != contents.digest)
            throw Error(ErrorKind::io, {archive.string() + " changed while it was read", "",
                                        "Run the same command once it is written."});
        return std::nullopt;
    };
    Import result;
    result.heard_otherwise = static_cast<std::size_t>(
        std::count(contents.is_heard_otherwise.begin(), contents.is_heard_otherwise.end(), true));
    result.skipped = result.heard_otherwise;
    for (const std::int64_t id : library.add(intake, staged, next, noise_library::Twins::skip_equal)) {
        if (id == 0)
            ++result.skipped;
        else
            result.added.push_back(id);
    }
    return result;
}

}  // namespace stridor::io
