#pragma once

#include "stridor/signal/source.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::recordings {

/// What the number 1 of a file stands for. In a file of whole numbers, 1 is the largest magnitude they can hold.
///
/// Until someone says what it is, it is 1 "FS", and no figure made of it may be called a pressure.
struct FullScale {
    double value = 1.0;                     // [unit]
    std::string unit = signal::full_scale;  // in SI: "Pa", "m/s^2", "m/s", "N", "V", ...
    bool operator==(const FullScale&) const = default;
};

/// "2 Pa", "50 m/s^2", "10 g" (of gravity), "300 mN", "1 FS".
///
/// Throws `Error` (input) without a unit, for an unknown one, and for what is not positive.
FullScale parse_full_scale(std::string_view text);

/// What a unit as labs write it is in SI: "mm/s" 0.001 m/s, "g" 9.80665 m/s^2 (a signal is no mass), "m/sec2" 1 m/s^2,
/// "Newtons" 1 N, "msec" 0.001 s. This is the one table of spellings, of times as of all else.
///
/// Nothing and "-" are "FS", as is "FS"; a word that is no unit stays what it is, with the factor 1.
FullScale unit_of_label(std::string_view label);

/// The unit of a label in Stridor's own letters: "m/sec2" is m/s^2. What is no unit stays what it is.
std::string unit_as_written(std::string_view label);

/// Is this unit label one that Stridor can convert?
bool is_known_unit(std::string_view label);

/// The calibration in the text that accompanies a recording (a WAV's bext description, a comment).
///
/// Understood are "full scale = 2 Pa" and "0dBFS = 109.7 dBSPL" (also "-20 dBFS = 94 dB SPL"). 0 dBFS is the level of a
/// sine whose peaks reach full scale (AES17), so the number 1 is sqrt(2) * 20 uPa * 10^(x/20). The first kind wins: it
/// is exact. Nothing where neither is found or what is found makes no sense.
std::optional<FullScale> calibration_in(std::string_view description);

/// What the calibration that an entry of a noise library keeps says the number 1 of its file stands for, of every
/// channel or of each ("full scale = 2 Pa; full scale = 50 N"), else `calibration_in`; nothing if it is neither.
std::vector<FullScale> full_scales_in(const std::string& calibration);

/// `parse_full_scale` of each.
std::vector<FullScale> parse_full_scales(std::span<const std::string> texts);

/// The text that `calibration_in` reads, for a WAV's description; empty for "FS".
std::string calibration_text(const FullScale& full_scale);

}  // namespace stridor::recordings
