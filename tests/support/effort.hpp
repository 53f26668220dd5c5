#pragma once

namespace stridor::support {

/// True where contracts are checked while running (debug and sanitizer builds),
/// which makes stepping some twenty times slower.
inline constexpr bool is_checked_build = STRIDOR_CHECKS != 0;

/// The work a test does: all of it in release builds, a documented part of it in checked ones.
template <typename T>
constexpr T effort(T release, T checked) {
    return is_checked_build ? checked : release;
}

}  // namespace stridor::support
