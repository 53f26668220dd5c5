#include "stridor/explorer/api.hpp"

#include "stridor/base/error.hpp"
#include "stridor/explorer/answers/answers.hpp"
#include "stridor/explorer/answers/seam.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace stridor::explorer {

namespace {

#include "stridor/explorer/page_bytes.inc"

template <std::size_t size>
std::string_view text_of(const unsigned char (&bytes)[size]) {
    return {reinterpret_cast<const char*>(bytes), size};
}

Response unknown(const HttpRequest& request) {
    const std::string what = request.method + " " + request.path.substr(0, 100) + " means nothing here";
    return refusal(404, Error(ErrorKind::input, {what, "", ""}));
}

Response route(const World& world, const HttpRequest& request, const std::stop_token& stop) {
    if (request.method == "GET") {
        if (request.path == "/api/start") return start(world);
        if (const PageFile* file = page_file(request.path))
            return {200, std::string(file->type), std::string(file->bytes)};
        if (std::optional<Response> found = library(world, request.path)) return std::move(*found);
        return unknown(request);
    }
    if (request.path == "/api/recording") return recording(request.body);
    if (request.path == "/api/report") return report(world, parse_body(request.body), stop);
    if (std::optional<Response> found = answer_at(world, request.path, request.body, stop)) return std::move(*found);
    return unknown(request);
}

}  // namespace

const PageFile* page_file(std::string_view path) {
    static const std::array files{PageFile{"/", "text/html; charset=utf-8", text_of(index_html)},
                                  PageFile{"/page.js", "text/javascript; charset=utf-8", text_of(page_js)},
                                  PageFile{"/chunk.js", "text/javascript; charset=utf-8", text_of(chunk_js)},
                                  PageFile{"/later.js", "text/javascript; charset=utf-8", text_of(later_js)},
                                  PageFile{"/microphone.js", "text/javascript; charset=utf-8", text_of(microphone_js)},
                                  PageFile{"/page.css", "text/css; charset=utf-8", text_of(page_css)}};
    const auto found =
        std::find_if(files.begin(), files.end(), [&](const PageFile& file) { return file.path == path; });
    return found == files.end() ? nullptr : &*found;
}

Response answer(const World& world, const HttpRequest& request, const std::stop_token& stop) {
    return answered([&] { return route(world, request, stop); });
}

}  // namespace stridor::explorer
