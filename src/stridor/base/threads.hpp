#pragma once

#include "stridor/base/error.hpp"

#include <system_error>

namespace stridor::base {

/// What to throw (io) where the system starts no more threads.
Error no_thread(const std::system_error& failure);

}  // namespace stridor::base
