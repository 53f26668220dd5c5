#pragma once

#include <array>
#include <string>
#include <string_view>

/// What the page and the program must say alike, written as TypeScript by the program. The page's copies stand in
/// explorer/src/program; a test compares them with what is written here (tests/program/page_sources_test.sh).
namespace stridor::explorer {

/// Files of explorer/src/program, without their extension.
inline constexpr std::array<std::string_view, 2> typescript_names{"palette", "words"};

/// One of `typescript_names`, as its file holds it and as prettier leaves it.
///
/// - "palette": the fills of categories, the colours of contact states, the stops of the map of figures.
/// - "words": the words that answers and requests are made of, as types and as lists.
std::string typescript(std::string_view name);

}  // namespace stridor::explorer
