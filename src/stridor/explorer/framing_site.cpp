#include "stridor/explorer/framing_site.hpp"

#include "stridor/base/error.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

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

}  // namespace stridor::explorer
