#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// HTTP in the explorer: requests and responses as plain data, independent of the server.
namespace stridor::explorer {

/// A request; a missing header field is empty.
struct HttpRequest {
    std::string method;  // "GET", "POST"
    std::string path;    // "/api/chart", as sent
    std::string query;   // "token=..", as sent; without "?"
    std::string host;
    std::string origin;
    std::string fetch_site;  // Sec-Fetch-Site
    std::string cookie;
    std::string content_type;
    std::string body;
};

/// Sends a part of a streamed body; waits while the client is slow to take the earlier parts.
using Send = std::function<void(std::string part)>;

/// An answer to a request, whole or streamed.
struct Response {
    int status = 200;
    std::string content_type = "text/plain; charset=utf-8";
    std::string body{};
    std::vector<std::pair<std::string, std::string>> headers{};         // besides those that every response has
    std::function<void(const Send&, const std::stop_token&)> stream{};  // if set, it makes the body part by part
};

/// Answers a request. Called from several threads at a time; the token is stopped when the client goes away, the time
/// for the request is over or the server ends.
using Handler = std::function<Response(const HttpRequest&, const std::stop_token&)>;

/// Decides which requests are answered: returns the refusal, or `std::nullopt` for one that may go on. Called on the
/// thread that carries bytes, so it must be quick.
using Admit = std::function<std::optional<Response>(const HttpRequest&)>;

/// Returns an answer of one line: "No such page".
Response plain(int status, std::string_view text);

/// Returns the value of a query's or a cookie's parameter; empty if it is missing. `separator` is '&' or ';'.
std::string parameter(std::string_view text, std::string_view name, char separator);

/// Returns the values of all parameters of a name, in their order.
std::vector<std::string> parameters(std::string_view text, std::string_view name, char separator);

/// Returns the header fields of every response: nothing from outside, no framing but by `frame_origin` (empty: by
/// nobody), no guessing of types, no copies kept.
std::vector<std::pair<std::string, std::string>> security_headers(const std::string& frame_origin = {});

}  // namespace stridor::explorer
