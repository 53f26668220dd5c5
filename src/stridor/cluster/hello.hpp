#pragma once

#include "stridor/cluster/messages.hpp"
#include "stridor/sweep/study.hpp"

namespace stridor::cluster {

/// What a rank says of itself before it gets work on a study.
Hello hello_of(const sweep::Study& study, std::size_t threads);

/// Throws `Error` (input) unless a rank runs the same program on the same study as this one: else their cells would not
/// belong together.
void expect_same(const Hello& ours, const Hello& theirs, int rank);

}  // namespace stridor::cluster
