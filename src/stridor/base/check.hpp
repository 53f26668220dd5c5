#pragma once

/// Programmer errors: preconditions on entry (EXPECT), promises on exit (ENSURE).
///
/// They stop the program in debug, sanitizer and test builds (STRIDOR_CHECKS=1) and cost nothing in a release build.
/// What a user can cause is never checked here: that throws `stridor::Error`.

#if defined(STRIDOR_CHECKS) && STRIDOR_CHECKS
#    include <cstdlib>
#    define STRIDOR_EXPECT(condition) ((condition) ? static_cast<void>(0) : std::abort())
#    define STRIDOR_ENSURE(condition) ((condition) ? static_cast<void>(0) : std::abort())
#else
#    define STRIDOR_EXPECT(condition) static_cast<void>(sizeof(condition))
#    define STRIDOR_ENSURE(condition) static_cast<void>(sizeof(condition))
#endif
