#include "stridor/drawing/cairo_library.hpp"

namespace stridor::drawing {

const Cairo& cairo() {
    static const Cairo opened;
    opened.library.expect_whole("pictures cannot be drawn");
    return opened;
}

const Pango& pango() {
    static const Pango opened;
    opened.library.expect_whole("text cannot be drawn");
    return opened;
}

}  // namespace stridor::drawing
