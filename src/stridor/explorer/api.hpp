#pragma once

#include "stridor/explorer/http.hpp"
#include "stridor/explorer/world.hpp"

#include <string_view>

namespace stridor::explorer {

/// A file of the page, as the build put it into the program.
struct PageFile {
    std::string_view path;  // "/page.js"
    std::string_view type;  // "text/javascript; charset=utf-8"
    std::string_view bytes;
};

/// Returns the file at a path ("/" is the page itself), or null if there is none. Paths are names in a table and reach
/// no disk.
const PageFile* page_file(std::string_view path);

/// Returns the explorer's page and data, for requests that the gate let pass. Never throws: an error becomes a document
/// "stridor.explorer.error/1" with status 400 (input), 422 (no result), 503 (stopped) or 500.
Response answer(const World& world, const HttpRequest& request, const std::stop_token& stop);

}  // namespace stridor::explorer
