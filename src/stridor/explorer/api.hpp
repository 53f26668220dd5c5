#pragma once

#include "stridor/explorer/http.hpp"
#include "stridor/explorer/world.hpp"

namespace stridor::explorer {

/// The explorer's page and data, for requests that the gate let pass. Never throws: what goes wrong is a document
/// "stridor.explorer.error/1" with status 400 (input), 422 (no result), 503 (stopped) or 500.
Response answer(const World& world, const HttpRequest& request, const std::stop_token& stop);

}  // namespace stridor::explorer
