#pragma once

#include <string>
#include <string_view>

namespace stridor::explorer {

/// Is this a link to a page of the explorer, or its part from "#" on, and not the name of a file?
bool is_link(std::string_view text);

/// What stands behind the "#" of a link that *Share* made: the page's whole state, which the page alone reads.
///
/// Throws `Error` (input) for what no page writes: no "#", no case, one that leans on another machine's file, a
/// character that an address does not hold, or more than 8000 of them.
std::string fragment_of(std::string_view link);

}  // namespace stridor::explorer
