#include "stridor/io/archive_library.hpp"

namespace stridor::io {

const Libarchive& libarchive() {
    static const Libarchive opened;
    opened.library.expect_whole("archives cannot be read");
    return opened;
}

}  // namespace stridor::io
