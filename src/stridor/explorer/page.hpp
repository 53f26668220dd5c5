#pragma once

#include <string_view>

namespace stridor::explorer {

/// A file of the page, as the build put it into the program.
struct PageFile {
    std::string_view path;  // "/page.js"
    std::string_view type;  // "text/javascript; charset=utf-8"
    std::string_view bytes;
};

/// The file at a path ("/" is the page itself); nothing if there is none. Paths are names in a table and reach no disk.
const PageFile* page_file(std::string_view path);

}  // namespace stridor::explorer
