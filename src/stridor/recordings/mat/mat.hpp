#pragma once

#include "stridor/recordings/raw_signal.hpp"

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace stridor::recordings {

namespace mat {
class Answers;
struct Wishes;
}  // namespace mat

/// Says whether a file begins like one of MATLAB: version 4, 5 (7) or 7.3.
bool is_mat(std::string_view beginning);

/// Opens the vectors and matrices of a MAT file through libmatio; `mat::choose` chooses and names the channels. Numbers
/// keep their bits.
///
/// The library is optional. It works in a confined process (`base::ChildProcess`) that gets this one file: what
/// damaged bytes do to it, or to HDF5 below it, is only an error. Times must be even as in a table. Throws
/// `Error` (input) if the library is missing, with the packages to install; for a file that is damaged, truncated, or
/// longer than its bytes can hold; and if no recording can be chosen.
RawSignal open_mat(const SignalInput& input, const mat::Wishes& wishes);

/// Opens a MAT file from the answers of any process. A file of `file_size` bytes limits how many numbers it can hold.
RawSignal open_mat_answers(std::shared_ptr<mat::Answers> answers, std::uint64_t file_size, const mat::Wishes& wishes,
                           const std::string& file);

}  // namespace stridor::recordings
