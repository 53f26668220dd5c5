#include "stridor/explorer/api.hpp"

#include "stridor/base/error.hpp"
#include "stridor/explorer/answers/answers.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>

namespace stridor::explorer {

namespace {

#include "stridor/explorer/page_bytes.inc"

template <std::size_t size>
std::string_view text_of(const unsigned char (&bytes)[size]) {
    return {reinterpret_cast<const char*>(bytes), size};
}

struct Route {
    std::string_view path;
    Response (*answer)(const World&, const Json& body, const std::stop_token&);
};

constexpr std::array routes{
    Route{"/api/simulate", simulate}, Route{"/api/motion", motion},     Route{"/api/stability", stability},
    Route{"/api/toml", toml},         Route{"/api/chart", chart},       Route{"/api/sound", sound},
    Route{"/api/analysis", analysis}, Route{"/api/advice", advice},     Route{"/api/design", design},
    Route{"/api/report", report},     Route{"/api/value", value},       Route{"/api/share", share},
    Route{"/api/modal", modal_lines}, Route{"/api/friction", friction},
};

int status_of(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::input:
            return 400;
        case ErrorKind::numerical:
            return 422;
        case ErrorKind::interrupted:
            return 503;
        case ErrorKind::io:
            return 500;
    }
    return 500;
}

Response refusal(int status, const Error& error) {
    Response response = json(error_document(error));
    response.status = status;
    return response;
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
    for (const Route& route : routes)
        if (request.path == route.path) return route.answer(world, parse_body(request.body), stop);
    return unknown(request);
}

}  // namespace

const PageFile* page_file(std::string_view path) {
    static const std::array files{PageFile{"/", "text/html; charset=utf-8", text_of(index_html)},
                                  PageFile{"/page.js", "text/javascript; charset=utf-8", text_of(page_js)},
                                  PageFile{"/chunk.js", "text/javascript; charset=utf-8", text_of(chunk_js)},
                                  PageFile{"/later.js", "text/javascript; charset=utf-8", text_of(later_js)},
                                  PageFile{"/page.css", "text/css; charset=utf-8", text_of(page_css)}};
    const auto found =
        std::find_if(files.begin(), files.end(), [&](const PageFile& file) { return file.path == path; });
    return found == files.end() ? nullptr : &*found;
}

Response answer(const World& world, const HttpRequest& request, const std::stop_token& stop) {
    try {
        return route(world, request, stop);
    } catch (const Error& error) {
        return refusal(status_of(error.kind()), error);
    } catch (const std::exception& error) {
        return refusal(500, Error(ErrorKind::io, {"the explorer failed", error.what(), ""}));
    }
}

}  // namespace stridor::explorer
