#include "stridor/io/library/archive_manifest.hpp"

#include "stridor/base/error.hpp"
#include "stridor/io/library/json_entry.hpp"
#include "stridor/noise_library/field.hpp"
#include "stridor/noise_library/library.hpp"

#include <algorithm>
#include <utility>

namespace stridor::io {

using base::Json;
using noise_library::AudioName;
using noise_library::Entry;
using noise_library::Figure;

namespace {

constexpr const char* schema = "stridor.library-archive/2";
constexpr const char* unhashed_schema = "stridor.library-archive/1";  // without the last line, which has the hash
constexpr std::size_t longest_line = std::size_t{4} << 20U;           // [bytes] of an entry
constexpr std::uint64_t longest_manifest = std::uint64_t{1} << 29U;   // [bytes]
constexpr int deepest = 4;                                            // levels of an entry's line; more is no entry

std::string line_of(const Json& object) {
    return object.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

/// The lines of a manifest, which is read in pieces.
class Manifest::Lines {
public:
    Lines(TarReader& tar, std::string archive) : tar_(&tar), archive_(std::move(archive)) {}

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
        throw Error(ErrorKind::input, {"the manifest of " + archive_ + " is damaged", why, ""},
                    base::Place{archive_ + ":" + manifest_name, number_, 0, ""});
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
    std::string archive_;
    std::string buffer_;
    std::size_t place_ = 0;  // in the buffer, of the next line
    int number_ = 0;         // of the line given last
};

namespace {

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
        // a number too large for 64 bits is read as a floating one, whose conversion means nothing
        if (!value.is_number_unsigned()) throw Error(ErrorKind::input, {"\"bytes\" is no number of bytes", "", ""});
        announced.bytes = value.get<std::uint64_t>();
    } else if (name == "figures") {
        for (const Json& each : value)
            noise_library::set_figure(entry, figure_of(each));
    } else if (const noise_library::EntryField* field = noise_library::find_field(name); field == nullptr) {
        throw Error(ErrorKind::input, {"\"" + name + "\" is no field of an entry", "", ""});
    } else if (std::holds_alternative<noise_library::EntryQuantity>(field->kind)) {
        noise_library::set_quantity(entry, *field, value.get<double>());
    } else {
        noise_library::set_from_text(entry, *field, value.get<std::string>());
    }
}

Announced announced_in(const Manifest::Lines& lines, const std::string& line) {
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
    if (!noise_library::is_audio_name(noise_library::audio_of(announced.entry)))
        lines.refuse("an entry does not name its audio");
    return announced;
}

// must the manifest end with its hash?
bool is_hashed(const Manifest::Lines& lines, const std::string& line) {
    const Json opening = lines.object(line);
    const std::string found = opening.contains("schema") && opening["schema"].is_string()
                                  ? opening["schema"].get<std::string>()
                                  : std::string("none");
    if (found != schema && found != unhashed_schema)
        lines.refuse("its schema is " + found + ", this program reads " + schema);
    return found == schema;
}

// the last line, with the hash of all before
std::string closing_of(const std::string& hash) {
    return line_of({{"sha256", hash}});
}

}  // namespace

std::string archive_member(const AudioName& audio) {
    return "audio/" + noise_library::path_of(audio).string();
}

std::string manifest_opening(std::size_t entries) {
    return line_of(
        {{"schema", schema}, {"version", base::version()}, {"commit", base::commit()}, {"entries", entries}});
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

std::string manifest_closing(std::string_view lines) {
    return closing_of(base::sha256_text(lines));
}

void expect_whole_manifest(TarReader& tar, const std::string& archive) {
    const std::optional<TarMember> first = tar.next();
    // what is no archive at all is refused by who reads it
    if (!first || first->name != manifest_name || first->size > longest_manifest) return;
    Manifest::Lines lines(tar, archive);
    base::Sha256 hash;
    std::string last;
    bool says_so = false;
    for (std::optional<std::string> line = lines.next(); line; line = lines.next()) {
        if (last.empty())
            says_so = line->find(schema) != std::string::npos;
        else
            hash.add(last + "\n");
        last = std::move(*line);
    }
    // no single bit hides both that there is a hash and the hash itself
    const bool has_hash = last.find("\"sha256\"") != std::string::npos;
    if ((says_so || has_hash) && last + "\n" != closing_of(hash.text()))
        throw Error(ErrorKind::io,
                    {archive + " is damaged", "its manifest does not have its hash", "Ask for it again."});
}

Manifest::Manifest(TarReader& tar, const std::string& archive) : lines_(std::make_unique<Lines>(tar, archive)) {
    const std::optional<TarMember> first = tar.next();
    if (!first || first->name != manifest_name)
        throw Error(ErrorKind::input, {archive + " is no archive of a noise library",
                                       "its first file is not " + std::string(manifest_name), ""});
    if (first->size > longest_manifest) lines_->refuse("it is longer than 512 MiB");
    const std::optional<std::string> opening = lines_->next();
    if (!opening) lines_->refuse("it is empty");
    is_hashed_ = is_hashed(*lines_, *opening);
    hash_.add(*opening + "\n");
}

Manifest::~Manifest() = default;

std::optional<Announced> Manifest::next() {
    const std::optional<std::string> line = lines_->next();
    if (!line && is_hashed_) lines_->refuse("its last line, with its hash, is missing");
    if (!line) return std::nullopt;
    if (is_hashed_ && *line + "\n" == closing_of(base::Sha256(hash_).text())) {
        if (lines_->next()) lines_->refuse("lines follow its hash");
        is_hashed_ = false;
        return std::nullopt;
    }
    hash_.add(*line + "\n");
    return announced_in(*lines_, *line);
}

std::string Manifest::digest() {
    return hash_.text();
}

}  // namespace stridor::io
