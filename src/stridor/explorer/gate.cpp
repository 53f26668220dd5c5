#include "stridor/explorer/gate.hpp"

#include "stridor/base/error.hpp"
#include "stridor/explorer/server.hpp"

#include <sys/random.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace stridor::explorer {

namespace {

constexpr std::size_t longest_name = 253;  // RFC 1035

bool is_letter_or_digit(char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
}

bool is_name(std::string_view text) {
    if (text.empty() || text.size() > longest_name) return false;
    if (!is_letter_or_digit(text.front()) || !is_letter_or_digit(text.back())) return false;
    return std::all_of(text.begin(), text.end(), [](char c) { return is_letter_or_digit(c) || c == '-' || c == '.'; });
}

// as a browser writes it: no zeros in front
bool is_port_number(std::string_view text) {
    int port = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
    return error == std::errc() && end == text.data() + text.size() && port >= 1 && port <= 65535 &&
           std::to_string(port) == text;
}

[[noreturn]] void refuse_origin(const std::string& origin) {
    throw Error(ErrorKind::input,
                {"'" + origin + "' is no origin", "it has a scheme, a host in lower case and a port, and nothing else",
                 "Write it as http://localhost:8888, without a path or a slash behind it."});
}

constexpr std::string_view no_session =
    "This page belongs to the person who started stridor. Open the link that the program prints in its terminal; "
    "each link opens once.";

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool is_port(std::string_view text) {
    return !text.empty() && text.size() <= 5 && std::all_of(text.begin(), text.end(), is_digit);
}

}  // namespace

FramingSite read_framing_site(const std::string& origin, const std::vector<std::string>& hosts) {
    std::string_view rest = origin;
    for (const std::string_view scheme : {"http://", "https://"})
        if (rest.size() == origin.size() && rest.starts_with(scheme)) rest.remove_prefix(scheme.size());
    if (rest.size() == origin.size()) refuse_origin(origin);
    const std::size_t colon = rest.find(':');
    const std::string_view host = rest.substr(0, colon);
    if (!is_name(host)) refuse_origin(origin);
    if (colon != std::string_view::npos && !is_port_number(rest.substr(colon + 1))) refuse_origin(origin);
    if (std::find(hosts.begin(), hosts.end(), host) == hosts.end())
        throw Error(ErrorKind::input, {"the explorer is not asked for as '" + std::string(host) + "'",
                                       "a browser gives a frame its session only under the name of the page round it",
                                       "Open the notebook at localhost or 127.0.0.1, or add --host-name."});
    return {origin, std::string(host)};
}

std::string secret() {
    std::array<unsigned char, 32> bytes;
    if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
        throw Error(ErrorKind::io, {"the system gives no random numbers", "a session cannot be protected without", ""});
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (const unsigned char byte : bytes) {
        text += digits[byte / 16];
        text += digits[byte % 16];
    }
    return text;
}

bool is_same_secret(std::string_view a, std::string_view b) {
    if (a.size() != b.size() || a.empty()) return false;
    unsigned difference = 0;
    for (std::size_t k = 0; k < a.size(); ++k)
        difference |= static_cast<unsigned>(static_cast<unsigned char>(a[k]) ^ static_cast<unsigned char>(b[k]));
    return difference == 0;
}

std::string host_name(std::string_view host) {
    std::string_view name = host;
    if (name.starts_with('[')) {
        const std::size_t end = name.find(']');
        if (end == std::string_view::npos) return {};
        name = name.substr(0, end + 1);
    } else {
        name = name.substr(0, name.find(':'));
    }
    const std::string_view port = host.substr(name.size());
    if (!port.empty() && !(port.starts_with(':') && is_port(port.substr(1)))) return {};
    return std::string(name);
}

Gate::Gate(std::vector<std::string> hosts, std::string name, std::function<void(const std::string& token)> announce)
    : hosts_(std::move(hosts)),
      cookie_("stridor-" + std::move(name)),
      announce_(std::move(announce)) {
    announce_(token_);
}

std::optional<Response> Gate::stop(const HttpRequest& request) {
    const std::string name = host_name(request.host);
    if (name.empty() || std::find(hosts_.begin(), hosts_.end(), name) == hosts_.end())
        return plain(421, "This is no name of the explorer's. Use the link that the program prints.");
    const bool is_get = request.method == "GET";
    if (!is_get && request.method != "POST") return plain(405, "Only GET and POST are known here.");
    if (is_get && request.path == "/open") return open(request);
    if (is_get && request.path == "/favicon.ico") return plain(404, "no icon");

    // other servers of this host may have set cookies of the same name
    const std::vector<std::string> sessions = parameters(request.cookie, cookie_, ';');
    const bool has_session = std::any_of(sessions.begin(), sessions.end(),
                                         [&](const std::string& session) { return is_same_secret(session, session_); });
    if (!has_session) return plain(401, no_session);
    const bool is_foreign =
        !request.fetch_site.empty() && request.fetch_site != "same-origin" && request.fetch_site != "none";
    const bool has_other_origin = !request.origin.empty() && request.origin != "http://" + request.host;
    const bool lacks_origin = !is_get && request.origin.empty();
    if (is_foreign || has_other_origin || lacks_origin)
        return plain(403, "The explorer answers its own page only, and this request comes from another one.");
    // neither is a type that a foreign page's form can send
    const bool is_sound = request.path == "/api/recording";
    if (!is_get && !request.content_type.starts_with(is_sound ? "audio/wav" : "application/json"))
        return plain(415, is_sound ? "A recording is a WAV file: Content-Type: audio/wav."
                                   : "Requests are JSON: Content-Type: application/json.");
    return std::nullopt;
}

Response Gate::open(const HttpRequest& request) {
    {
        const std::lock_guard lock(mutex_);
        if (!is_same_secret(parameter(request.query, "token", '&'), token_))
            return plain(403, "This link was used already, or is incomplete. The program prints a new one each time.");
        token_ = secret();
        announce_(token_);
    }
    Response response = plain(303, "Welcome.");
    response.headers = {{"Location", "/"},
                        {"Set-Cookie", cookie_ + "=" + session_ + "; HttpOnly; SameSite=Strict; Path=/"}};
    // a redirect belongs to whoever followed the link: behind a file's it would carry no cookie (SameSite)
    if (request.fetch_site != "cross-site" && request.fetch_site != "same-site") return response;
    response.status = 200;
    response.content_type = "text/html; charset=utf-8";
    response.headers.front() = {"Refresh", "0; url=/"};
    response.body = "<!doctype html><title>Stridor</title><a href=\"/\">Welcome.</a>\n";
    return response;
}

std::string host_in_link(const std::string& address) {
    return address.find(':') == std::string::npos ? address : "[" + address + "]";
}

std::vector<std::string> host_names(const std::string& address, const std::vector<std::string>& added) {
    std::vector<std::string> hosts{"localhost", "127.0.0.1", "[::1]", host_in_link(address)};
    hosts.insert(hosts.end(), added.begin(), added.end());
    return hosts;
}

}  // namespace stridor::explorer
