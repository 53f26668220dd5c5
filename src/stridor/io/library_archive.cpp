#include "stridor/io/library_archive.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/sha256.hpp"
#include "stridor/io/json_entry.hpp"
#include "stridor/io/tar.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <system_error>
#include <utility>

namespace stridor::io {

namespace fs = std::filesystem;
using json_parts::Json;
using noise_library::AudioName;
using noise_library::Entry;
using noise_library::Field;
using noise_library::Figure;
using noise_library::Library;
using noise_library::Staged;

namespace {

constexpr const char* schema = "stridor.library-archive/1";
constexpr const char* manifest_name = "manifest.jsonl";
constexpr std::size_t longest_line = std::size_t{4} << 20U;          // [bytes] of an entry
constexpr std::uint64_t longest_manifest = std::uint64_t{1} << 29U;  // [bytes]
constexpr int deepest = 4;                                           // levels of an entry's line; more is no entry

AudioName audio_of(const Entry& entry) {
    return {entry.audio, entry.format};
}

std::string member_name(const AudioName& audio) {
    return "audio/" + noise_library::path_of(audio).string();
}

std::string line_of(const Json& object) {
    return object.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string manifest_line(Entry entry, std::uint64_t bytes) {
    entry.id = 0;
    Json object = json_parts::entry_object(entry);
    Json figures = Json::array();
    for (const Figure& figure : entry.figures)
        figures.push_back({{"name", figure.name}, {"unit", figure.unit}, {"value", figure.value}});
    if (!figures.empty()) object["figures"] = std::move(figures);
    object["bytes"] = bytes;
    return line_of(object);
}

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
        sizes.emplace(audio_of(entry), size);
    }
    return sizes;
}

void write_audio(TarWriter& tar, const Library& library, const AudioName& audio, std::uint64_t size) {
    const fs::path file = library.audio_folder() / noise_library::path_of(audio);
    base::Sha256 hash;
    std::uint64_t written = 0;
    tar.begin({member_name(audio), size});
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

fs::path temporary_beside(const fs::path& file) {
    const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
    return file.parent_path() / (".stridor-" + std::to_string(::getpid()) + "-" + std::to_string(now) + ".tmp");
}

/// The lines of a manifest, which is read in pieces.
class Lines {
public:
    Lines(TarReader& tar, const fs::path& archive) : tar_(&tar), archive_(archive) {}

    // nothing at the end
    std::optional<std::string> next() {
        std::size_t end = buffer_.find('\n', place_);
        while (end == std::string::npos) {
            const std::string_view piece = tar_->read();
            if (piece.empty()) break;
            buffer_.erase(0, std::exchange(place_, 0));
            const std::size_t from = buffer_.size();
            buffer_ += piece;
            end = buffer_.find('\n', from);
            if (std::min(end, buffer_.size()) > longest_line) refuse("a line is longer than 4 MiB");
        }
        if (place_ >= buffer_.size()) return std::nullopt;
        ++number_;
        const std::size_t length = std::min(end, buffer_.size()) - place_;
        std::string line = buffer_.substr(place_, length);
        place_ += length + 1;
        return line;
    }

    [[noreturn]] void refuse(const std::string& why) const {
        throw Error(ErrorKind::input, {"the manifest of " + archive_.string() + " is damaged", why, ""},
                    base::Place{archive_.string() + ":" + manifest_name, number_, 0, ""});
    }

    Json object(const std::string& line) const {
        const auto limit = [this](int depth, Json::parse_event_t, Json&) {
            if (depth > deepest) refuse("a line is no entry");
            return true;
        };
        Json object = Json::parse(line, limit, false);
        if (!object.is_object()) refuse("a line is no JSON object");
        return object;
    }

private:
    TarReader* tar_;
    fs::path archive_;
    std::string buffer_;
    std::size_t place_ = 0;  // in the buffer, of the next line
    int number_ = 0;         // of the line given last
};

/// An entry with what its audio must be.
struct Announced {
    Entry entry;
    std::uint64_t bytes = 0;
};

Figure figure_of(const Json& object) {
    Figure figure{object.at("name").get<std::string>(), object.at("unit").get<std::string>(),
                  object.at("value").get<double>()};
    const bool has_control = std::any_of(figure.unit.begin(), figure.unit.end(),
                                         [](char c) { return static_cast<unsigned char>(c) < 0x20; });
    if (!noise_library::is_figure_name(figure.name) || has_control || figure.unit.size() > 64)
        throw Error(ErrorKind::input, {"a figure has no proper name or unit", "", ""});
    return figure;
}

void take_field(Announced& announced, const std::string& name, const Json& value) {
    Entry& entry = announced.entry;
    if (name == "bytes") {
        announced.bytes = value.get<std::uint64_t>();
    } else if (name == "figures") {
        for (const Json& each : value)
            noise_library::set_figure(entry, figure_of(each));
    } else if (const Field* field = noise_library::find_field(name); field == nullptr) {
        throw Error(ErrorKind::input, {"\"" + name + "\" is no field of an entry", "", ""});
    } else if (std::holds_alternative<noise_library::Quantity>(field->kind)) {
        noise_library::set_quantity(entry, *field, value.get<double>());
    } else {
        noise_library::set_from_text(entry, *field, value.get<std::string>());
    }
}

Announced announced_in(const Lines& lines, const std::string& line) {
    const Json object = lines.object(line);
    Announced announced;
    try {
        for (const auto& [name, value] : object.items())
            take_field(announced, name, value);
    } catch (const Json::exception&) {
        lines.refuse("a value is of the wrong kind");
    } catch (const Error& error) {
        lines.refuse(error.problem().what + (error.problem().why.empty() ? "" : ": " + error.problem().why));
    }
    if (!noise_library::is_audio_name(audio_of(announced.entry))) lines.refuse("an entry does not name its audio");
    return announced;
}

void expect_schema(const Lines& lines, const std::string& line) {
    const Json opening = lines.object(line);
    const std::string found = opening.contains("schema") && opening["schema"].is_string()
                                  ? opening["schema"].get<std::string>()
                                  : std::string("none");
    if (found != schema) lines.refuse("its schema is " + found + ", this program reads " + schema);
}

std::vector<Announced> read_manifest(TarReader& tar, const fs::path& archive) {
    const std::optional<TarMember> first = tar.next();
    Lines lines(tar, archive);
    if (!first || first->name != manifest_name)
        throw Error(ErrorKind::input, {archive.string() + " is no archive of a noise library",
                                       "its first file is not " + std::string(manifest_name), ""});
    if (first->size > longest_manifest) lines.refuse("it is longer than 512 MiB");
    const std::optional<std::string> opening = lines.next();
    if (!opening) lines.refuse("it is empty");
    expect_schema(lines, *opening);
    std::vector<Announced> entries;
    for (std::optional<std::string> line = lines.next(); line; line = lines.next())
        entries.push_back(announced_in(lines, *line));
    return entries;
}

// by the name in the archive
std::map<std::string, std::pair<AudioName, std::uint64_t>> expected_audio(const std::vector<Announced>& entries) {
    std::map<std::string, std::pair<AudioName, std::uint64_t>> expected;
    for (const Announced& each : entries)
        expected.emplace(member_name(audio_of(each.entry)), std::pair(audio_of(each.entry), each.bytes));
    return expected;
}

std::vector<Staged> stage_audio(TarReader& tar, noise_library::Intake& intake, const fs::path& archive,
                                const std::vector<Announced>& entries) {
    const auto refuse = [&](const std::string& why) {
        throw Error(ErrorKind::input, {archive.string() + " is damaged", why, "Ask for it again."});
    };
    auto expected = expected_audio(entries);
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

}  // namespace

void export_library(const Library& library, std::span<const Entry> entries, const fs::path& archive) {
    std::error_code error;
    if (fs::equivalent(archive, library.file(), error))
        throw Error(ErrorKind::input, {archive.string() + " is the library itself", "", "Choose another file."});
    const std::map<AudioName, std::uint64_t> sizes = sizes_of(library, entries);
    std::string manifest = line_of(
        {{"schema", schema}, {"version", base::version()}, {"commit", base::commit()}, {"entries", entries.size()}});
    for (const Entry& entry : entries)
        manifest += manifest_line(entry, sizes.at(audio_of(entry)));

    storage::NewFile file(temporary_beside(archive), archive.string());
    TarWriter tar(file);
    tar.begin({manifest_name, manifest.size()});
    tar.write(manifest);
    tar.end();
    for (const auto& [audio, size] : sizes)
        write_audio(tar, library, audio, size);
    tar.finish();
    file.finish();
    file.keep(archive);
}

Import import_library(Library& library, const fs::path& archive) {
    TarReader tar(archive);
    const std::vector<Announced> announced = read_manifest(tar, archive);
    noise_library::Intake intake(library.audio_folder());
    std::vector<Staged> staged = stage_audio(tar, intake, archive, announced);
    std::vector<Entry> entries;
    for (const Announced& each : announced)
        entries.push_back(each.entry);
    Import result;
    for (const std::int64_t id : library.add(intake, staged, entries, noise_library::Twins::skip_equal)) {
        if (id == 0)
            ++result.skipped;
        else
            result.added.push_back(id);
    }
    return result;
}

}  // namespace stridor::io
