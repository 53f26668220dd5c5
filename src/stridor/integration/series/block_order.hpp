#pragma once

namespace stridor::integration {

/// Order of the series of a block: with h = 2/Omega the next term is 2^25/25! = 2e-18 of the first.
inline constexpr int block_order = 24;

}  // namespace stridor::integration
