#pragma once

#include <string>
#include <vector>

namespace stridor::explorer {

/// A site that may show the explorer in a frame: a notebook's, say.
struct FramingSite {
    std::string origin;  // "http://localhost:8888"; empty: none, and nobody may
    std::string host;    // "localhost"
};

/// Reads an origin: http:// or https://, a name or an IPv4 address in lower case, and a port where it is not the usual
/// one; nothing else, for the text goes into a header field that says who is let in.
///
/// Its host must be one of `hosts`, under which the explorer is asked for. A browser sends the session's cookie inside
/// a frame only if both have the same host name (SameSite; ports do not matter). Throws `Error` (input).
FramingSite read_framing_site(const std::string& origin, const std::vector<std::string>& hosts);

}  // namespace stridor::explorer
