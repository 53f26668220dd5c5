#pragma once

#include "stridor/base/child_process.hpp"
#include "stridor/base/opened_library.hpp"

#include <matio.h>

// A MAT file read by libmatio, in a confined process. Private to this folder.
namespace stridor::recordings {

// libmatio, opened with the first MAT file, since not every machine has it. Private to this folder.

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

/// Returns the library, opened once for the process. Null if this machine lacks it.
const Matio* matio_library();

/// Answers questions about the process' file (`mat_answers.hpp`) until nobody asks any more.
void answer_with_matio(const Matio& matio, const base::ChildProcess::Channel& channel);

}  // namespace stridor::recordings
