#pragma once

#include "stridor/cluster/messages.hpp"
#include "stridor/crew/crew.hpp"

#include <string>

namespace stridor::cluster {

/// What rank 0 says of a work that it begins.
Begin begin_of(const crew::Work& work);

/// The machine that this process runs on.
std::string host_name();

/// What a rank has to complain of whose program is another than that of rank 0, or which does not have the work that
/// rank 0 has begun: their results would not belong together.
Failure mismatch(const Begin& begun, int rank);

}  // namespace stridor::cluster
