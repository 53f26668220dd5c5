#pragma once

#include "stridor/base/error.hpp"
#include "stridor/explorer/http.hpp"
#include "stridor/explorer/world.hpp"

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

/// Answers below HTTP: a path and a text in, a response out. The server carries them over HTTP, the page in one file
/// from a module beside it.
namespace stridor::explorer {

/// Returns the answer to a body at a path that every carrier knows, or `std::nullopt` for any other path.
std::optional<Response> answer_at(const World& world, std::string_view path, const std::string& body,
                                  const std::stop_token& stop);

/// Returns an error as a document "stridor.explorer.error/1" with this status.
Response refusal(int status, const Error& error);

/// Returns what `make` returns. Never throws: an error becomes a refusal with status 400 (input), 422 (no result), 503
/// (stopped) or 500.
Response answered(const std::function<Response()>& make);

}  // namespace stridor::explorer
