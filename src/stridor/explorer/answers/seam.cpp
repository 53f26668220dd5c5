#include "stridor/explorer/answers/seam.hpp"

#include "stridor/explorer/answers/answers.hpp"

#include <array>
#include <exception>

namespace stridor::explorer {

namespace {

struct Route {
    std::string_view path;
    Response (*answer)(const World&, const Json& body, const std::stop_token&);
};

constexpr std::array routes{
    Route{"/api/simulate", simulate}, Route{"/api/motion", motion}, Route{"/api/stability", stability},
    Route{"/api/toml", toml},         Route{"/api/chart", chart},   Route{"/api/sound", sound},
    Route{"/api/analysis", analysis}, Route{"/api/advice", advice}, Route{"/api/design", design},
    Route{"/api/value", value},       Route{"/api/share", share},   Route{"/api/modal", modal_lines},
    Route{"/api/friction", friction},
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

}  // namespace

Response refusal(int status, const Error& error) {
    Response response = json(error_document(error));
    response.status = status;
    return response;
}

std::optional<Response> answer_at(const World& world, std::string_view path, const std::string& body,
                                  const std::stop_token& stop) {
    for (const Route& route : routes)
        if (path == route.path) return route.answer(world, parse_body(body), stop);
    return std::nullopt;
}

Response answered(const std::function<Response()>& make) {
    try {
        return make();
    } catch (const Error& error) {
        return refusal(status_of(error.kind()), error);
    } catch (const std::exception& error) {
        return refusal(500, Error(ErrorKind::io, {"the explorer failed", error.what(), ""}));
    }
}

}  // namespace stridor::explorer
