#pragma once

#include "stridor/explorer/http.hpp"

#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::explorer {

/// A site that may show the explorer in a frame, such as a notebook.
struct FramingSite {
    std::string origin;  // "http://localhost:8888"; empty: none, and nobody may
    std::string host;    // "localhost"
};

/// Reads an origin: http:// or https://, a name or an IPv4 address in lower case, and a port unless it is the usual
/// one. It allows nothing else, since the text goes into a header field that says who is let in.
///
/// Its host must be one of `hosts`, the explorer's own names. A browser sends the session's cookie inside a frame only
/// if both have the same host name (SameSite; ports do not matter). Throws `Error` (input).
FramingSite read_framing_site(const std::string& origin, const std::vector<std::string>& hosts);

/// Returns a secret that nobody can guess: 32 bytes of the system's random numbers as 64 hexadecimal digits. Throws
/// `Error` (io).
std::string secret();

/// Says whether two texts are equal. The time does not depend on where texts of one length differ, so that it reveals
/// no secret.
bool is_same_secret(std::string_view a, std::string_view b);

/// Returns the address in a request's Host field: "localhost", "127.0.0.1", "[::1]"; without the port. Empty if it is
/// not a host.
std::string host_name(std::string_view host);

/// Returns an address as it stands in a link: "[::1]" for ::1.
std::string host_in_link(const std::string& address);

/// Returns the names by which an explorer at this address may be addressed, with those that the user adds. Unlike
/// names, addresses cannot be made to point elsewhere.
std::vector<std::string> host_names(const std::string& address, const std::vector<std::string>& added);

/// Decides which requests reach the explorer.
///
/// 1. *Host*: only names in the list; a foreign site that makes its own name point to this machine (DNS rebinding) is
///    stopped here, for its requests carry its name.
/// 2. *Session*: a cookie, given once for a token that stands in the link which the program prints. Each token opens
///    once; a new one follows. Cookies know no ports, so the cookie's name holds the port.
/// 3. *Origin*: whatever changes state or computes is a POST from the explorer's own page, with its Origin; another
///    site's request carries that site's.
class Gate {
public:
    /// Takes the allowed hosts. Calls `announce` with each new token, the first one at once; the cookie is called
    /// stridor-`name`.
    Gate(std::vector<std::string> hosts, std::string name, std::function<void(const std::string& token)> announce);

    /// Returns the answer to a request that does not pass, or to /open, which exchanges the token; `std::nullopt` if it
    /// may go on.
    std::optional<Response> stop(const HttpRequest& request);

private:
    Response open(const HttpRequest& request);

    const std::vector<std::string> hosts_;
    const std::string cookie_;
    const std::string session_ = secret();
    const std::function<void(const std::string&)> announce_;
    std::mutex mutex_;  // guards the token
    std::string token_ = secret();
};

}  // namespace stridor::explorer
