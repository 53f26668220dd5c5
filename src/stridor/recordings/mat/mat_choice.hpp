#pragma once

// Which variables of a MAT file are the channels of a recording.

#include "stridor/recordings/mat/mat_answers.hpp"
#include "stridor/signal/source.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stridor::recordings::mat {

/// A variable of the file without its numbers.
struct Variable {
    std::string name;
    MatKind kind = MatKind::object;
    std::uint64_t rows = 0;
    std::uint64_t columns = 0;
    double value = 0.0;  // of a single number
};

/// Facts that the user knows better than the file.
struct Wishes {
    std::optional<double> rate{};  // [Hz]
    std::string channel{};         // its variable is read even where others are of another length
};

/// The variables and columns to be read.
struct MatChoice {
    std::vector<MatColumn> columns{};         // of the channels
    std::vector<signal::Channel> channels{};  // their names
    std::uint64_t frames = 0;
    std::optional<double> rate{};     // [Hz]; `std::nullopt` if the times must tell it
    std::optional<MatColumn> time{};  // [s]
    std::string time_name{};          // "t", "data(1)"
    bool is_time_guessed = false;     // no name says that it is a time
    bool has_single_times = false;    // of seven digits
    std::vector<std::string> notes{};
    std::vector<std::string> left_out{};                          // "s (a structure)"
    std::vector<std::pair<std::string, std::string>> metadata{};  // other single numbers
};

/// Chooses the channels: all vectors of numbers of one length, and the columns of matrices, NAME(1) to NAME(n). The
/// longer side of a matrix is its time, a square's its rows.
///
/// The rate is a single number called `fs`, `sample_rate` or the like, or one over `dt`. The times are a vector called
/// `t` or `time` in seconds, or the first column of a matrix that is alone and without a rate. If there are times, the
/// variables of their length are chosen. A rate from the user has priority over times: these are left out. Throws
/// `Error` (input) that lists the variables if nothing or no single length can be chosen, and if there is neither a
/// rate nor times.
MatChoice choose(const std::vector<Variable>& variables, const Wishes& wishes, const std::string& file);

}  // namespace stridor::recordings::mat
