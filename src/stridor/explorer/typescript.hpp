#pragma once

#include <array>
#include <string>
#include <string_view>

/// Facts that the page and the program share, written as TypeScript by the program. The page's copies stand in
/// explorer/src/program; a test compares them with these texts (tests/program/page_sources_test.sh).
namespace stridor::explorer {

/// Files of explorer/src/program, without their extension.
inline constexpr std::array<std::string_view, 2> typescript_names{"palette", "words"};

/// Returns one of `typescript_names`, as its file holds it and in prettier's layout.
///
/// - "palette": the fills of categories, the colours of contact states, the stops of the map of figures.
/// - "words": the words that answers and requests are made of, as types and as lists, and the types of their records.
std::string typescript(std::string_view name);

}  // namespace stridor::explorer
