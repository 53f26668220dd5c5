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

/// Does a file begin like one of MATLAB: version 4, 5 (7) or 7.3?
bool is_mat(std::string_view beginning);

/// Opens the vectors and matrices of a MAT file through libmatio; what they are called and which are the channels says
/// `mat::choose`. Numbers keep their bits.
///
/// The library is optional. It works in a confined process (`base::ChildProcess`) that gets this one file: what
/// damaged bytes do to it, or to HDF5 behind it, is an error and no more. Times must be even as in a table. Throws
/// `Error` (input) where the library is missing, with what to install; for what is damaged, cut off, or longer than its
/// bytes can hold; and where no recording can be chosen.
RawSignal open_mat(const SignalInput& input, const mat::Wishes& wishes);

/// The same from answers of anybody. A file of so many bytes holds so many numbers at most.
RawSignal open_mat_answers(std::shared_ptr<mat::Answers> answers, std::uint64_t file_size, const mat::Wishes& wishes,
                           const std::string& file);

}  // namespace stridor::recordings
