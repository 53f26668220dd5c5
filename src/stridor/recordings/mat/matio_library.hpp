#pragma once

// libmatio, opened when the first MAT file is: not every machine has it. Private to this folder.

#include <matio.h>

namespace stridor::recordings {

/// The functions that Stridor uses, of the version it was built with.
struct Matio {
    decltype(&::Mat_Open) Mat_Open = nullptr;
    decltype(&::Mat_VarReadNextInfo) Mat_VarReadNextInfo = nullptr;
    decltype(&::Mat_VarReadDataAll) Mat_VarReadDataAll = nullptr;
};

/// The library, opened once for the process. Null where this machine lacks it.
const Matio* matio_library();

}  // namespace stridor::recordings
