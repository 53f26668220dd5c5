#include "stridor/recordings/mat/matio_library.hpp"

namespace stridor::recordings {

const Matio* matio_library() {
    static const Matio opened;
    return opened.library.is_whole() ? &opened : nullptr;
}

}  // namespace stridor::recordings
