#pragma once

namespace stridor::sweep {

/// Generation of the numbers. Raise it with every change that moves a result (the changelog's "Results changed"): a
/// store begun before is then refused, for its cells and new ones would not fit together.
inline constexpr int results_version = 14;

}  // namespace stridor::sweep
