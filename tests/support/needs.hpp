#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace stridor::support {

/// Is this a continuous-integration run? The services set CI, and `.ci/run` does.
inline bool is_ci_run() {
    const char* ci = std::getenv("CI");
    return ci != nullptr && *ci != '\0';
}

/// What to say of a program or library that is not there, and which of Debian's packages have it.
inline std::string lacking(const std::string& what, const std::string& packages) {
    return what + " is not there: apt-get install " + packages;
}

}  // namespace stridor::support

/// Leaves a test out where the machine lacks something that Stridor runs without, and says what to install.
///
/// A continuous-integration run installs everything: there the test fails, since a hole in it would be seen by nobody.
#define STRIDOR_NEEDS(is_there, what, packages)                                                 \
    do {                                                                                        \
        if (is_there) break;                                                                    \
        if (stridor::support::is_ci_run()) FAIL() << stridor::support::lacking(what, packages); \
        GTEST_SKIP() << stridor::support::lacking(what, packages);                              \
    } while (false)
