#pragma once

#include "stridor/advice/advice.hpp"
#include "stridor/explorer/body.hpp"
#include "stridor/explorer/world.hpp"

#include <stop_token>

namespace stridor::explorer {

/// Returns the request for advice in a body: ranges in "over", tolerances in "tolerance", and "samples". Throws `Error`
/// (input) for any that cannot be meant.
advice::AdviceOptions advice_options_in(const World& world, const Json& body, const std::stop_token& stop);

}  // namespace stridor::explorer
