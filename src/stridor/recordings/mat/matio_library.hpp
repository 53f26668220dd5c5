#pragma once

// libmatio, opened when the first MAT file is: not every machine has it. Private to this folder.

#include "stridor/base/opened_library.hpp"

#include <matio.h>

namespace stridor::recordings {

/// The functions that Stridor uses, of the version it was built with.
struct Matio {
    base::OpenedLibrary library{STRIDOR_MATIO_LIBRARY};
    decltype(&::Mat_Open) open = library.function("Mat_Open");
    decltype(&::Mat_VarReadNextInfo) read_next_info = library.function("Mat_VarReadNextInfo");
    decltype(&::Mat_VarGetNumberOfFields) field_count = library.function("Mat_VarGetNumberOfFields");
    decltype(&::Mat_VarGetStructFieldnames) field_names = library.function("Mat_VarGetStructFieldnames");
    decltype(&::Mat_VarGetStructFieldByIndex) field = library.function("Mat_VarGetStructFieldByIndex");
    decltype(&::Mat_VarReadDataAll) read_all_data = library.function("Mat_VarReadDataAll");
};

/// The library, opened once for the process. Null where this machine lacks it.
const Matio* matio_library();

}  // namespace stridor::recordings
