#include "stridor/explorer/http.hpp"

namespace stridor::explorer {

Response plain(int status, std::string_view text) {
    Response response;
    response.status = status;
    response.body = std::string(text) + "\n";
    return response;
}

std::string parameter(std::string_view text, std::string_view name, char separator) {
    const std::vector<std::string> values = parameters(text, name, separator);
    return values.empty() ? std::string() : values.front();
}

std::vector<std::string> parameters(std::string_view text, std::string_view name, char separator) {
    std::vector<std::string> values;
    while (!text.empty()) {
        std::string_view item = text.substr(0, text.find(separator));
        text.remove_prefix(item.size() < text.size() ? item.size() + 1 : text.size());
        while (item.starts_with(' '))
            item.remove_prefix(1);
        if (item.starts_with(name) && item.substr(name.size()).starts_with('='))
            values.emplace_back(item.substr(name.size() + 1));
    }
    return values;
}

std::vector<std::pair<std::string, std::string>> security_headers(const std::string& frame_origin) {
    return {
        {"Content-Security-Policy",
         "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; media-src 'self' blob:; "
         "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors " +
             (frame_origin.empty() ? "'none'" : frame_origin)},
        {"X-Content-Type-Options", "nosniff"},
        {"Referrer-Policy", "no-referrer"},
        {"Cross-Origin-Opener-Policy", "same-origin"},
        {"Cross-Origin-Resource-Policy", "same-origin"},
        {"Permissions-Policy", "camera=(), microphone=(self), geolocation=()"},
        {"Cache-Control", "no-store"}};
}

}  // namespace stridor::explorer
