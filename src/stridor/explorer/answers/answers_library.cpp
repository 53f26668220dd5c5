#include "stridor/base/error.hpp"
#include "stridor/explorer/answers/answers.hpp"
#include "stridor/io/library/library_texts.hpp"
#include "stridor/noise_library/library.hpp"
#include "stridor/recordings/bytes.hpp"
#include "stridor/recordings/open_signal.hpp"

#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace stridor::explorer {

namespace {

using noise_library::Entry;
using noise_library::Library;

constexpr std::size_t most_listed = 1000;  // the newest; more nobody scrolls through
constexpr std::size_t piece = 1U << 16U;   // [B]

// formats that browsers play as they are
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> playable{
    {{"wav", "audio/wav"}, {"flac", "audio/flac"}, {"ogg", "audio/ogg"}, {"oga", "audio/ogg"}}};

Library open(const World& world) {
    if (world.library.empty())
        throw Error(ErrorKind::input, {"there is no noise library", "", "`stridor library add` begins one."});
    return Library(world.library);
}

Entry entry_of(Library& library, std::int64_t id) {
    return library.get(std::array{id}).front();
}

Response list(const World& world) {
    Library library = open(world);
    noise_library::Query query;
    query.extent = noise_library::EntryExtent::figures;
    query.sort = "id";
    query.direction = noise_library::SortOrder::falling;
    query.limit = most_listed;
    io::LibraryJson document;
    std::string text = document.opening(library.file().filename());
    library.visit(query, [&](const Entry& entry) { text += document.entry(entry); });
    return json(text + document.closing());
}

Response audio(const World& world, std::int64_t id) {
    Library library = open(world);
    const Entry entry = entry_of(library, id);
    for (const auto& [format, type] : playable)
        if (entry.format == format) {
            Response response;
            response.content_type = type;
            response.stream = [bytes = recordings::open_plain_bytes(library.sound_file(entry).string())](
                                  const Send& send, const std::stop_token& stop) {
                for (std::uint64_t at = 0; at < bytes->size() && !stop.stop_requested(); at += piece)
                    send(recordings::text_at(*bytes, at, piece));
            };
            return response;
        }
    throw Error(ErrorKind::input, {"a browser does not play " + entry.format + " files", "",
                                   "`stridor convert` makes a WAV file of it."});
}

Response entry_analysis(const World& world, std::int64_t id) {
    Library library = open(world);
    const std::string path = library.sound_file(entry_of(library, id)).string();
    return analysis_of(*recordings::open_signal(path));
}

}  // namespace

// a sound has one mark: what other formats hold is read on the command line alone
Response recording(std::string wav) {
    if (!wav.starts_with("RIFF"))
        throw Error(ErrorKind::input, {"this is no WAV file", "the page sends what a microphone hears as one", ""});
    return analysis_of(*recordings::open_signal({recordings::bytes_of(std::move(wav)), "the recording", {}}));
}

std::optional<Response> library(const World& world, std::string_view path) {
    constexpr std::string_view root = "/api/library";
    if (path == root) return list(world);
    if (!path.starts_with("/api/library/")) return std::nullopt;
    path.remove_prefix(root.size() + 1);
    std::int64_t id = 0;
    const auto [end, problem] = std::from_chars(path.data(), path.data() + path.size(), id);
    path.remove_prefix(static_cast<std::size_t>(end - path.data()));
    if (problem != std::errc() || id <= 0) return std::nullopt;
    if (path == "/audio") return audio(world, id);
    if (path == "/analysis") return entry_analysis(world, id);
    return std::nullopt;
}

}  // namespace stridor::explorer
