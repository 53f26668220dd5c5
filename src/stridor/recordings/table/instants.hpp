#pragma once

// Times of the day and dates, as tables hold them. Private to this folder.

#include <optional>
#include <string_view>

namespace stridor::recordings::csv_table {

/// A time of the day, or a date with one.
struct ClockTime {
    double seconds = 0.0;  // [s] since midnight, or since 1970 with a date; a zone is ignored
    int decimals = 0;      // [1] printed behind the second
};

/// Reads "10:00:00.250", "10:00:00:250", "00:12.250" (minutes and seconds) and "10:00:00 AM", alone or behind a date:
/// "2024-03-11T10:00:00.25+01:00", "11.03.2024 10:00:00,25", "03/11/2024 10:00:00 AM". Of two numbers between slashes
/// the first is the month if it can be. Returns `std::nullopt` for any other text.
std::optional<ClockTime> instant_in(std::string_view text);

}  // namespace stridor::recordings::csv_table
