#include "stridor/explorer/page.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace stridor::explorer {

namespace {

#include "stridor/explorer/page_bytes.inc"

template <std::size_t size>
std::string_view text_of(const unsigned char (&bytes)[size]) {
    return {reinterpret_cast<const char*>(bytes), size};
}

}  // namespace

const PageFile* page_file(std::string_view path) {
    static const std::array files{PageFile{"/", "text/html; charset=utf-8", text_of(index_html)},
                                  PageFile{"/page.js", "text/javascript; charset=utf-8", text_of(page_js)},
                                  PageFile{"/chunk.js", "text/javascript; charset=utf-8", text_of(chunk_js)},
                                  PageFile{"/later.js", "text/javascript; charset=utf-8", text_of(later_js)},
                                  PageFile{"/page.css", "text/css; charset=utf-8", text_of(page_css)}};
    const auto found =
        std::find_if(files.begin(), files.end(), [&](const PageFile& file) { return file.path == path; });
    return found == files.end() ? nullptr : &*found;
}

}  // namespace stridor::explorer
