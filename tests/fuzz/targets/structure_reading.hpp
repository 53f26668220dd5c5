#pragma once

#include "fuzz/targets/targets.hpp"
#include "stridor/base/error.hpp"
#include "stridor/io/structure/field_scanner.hpp"

#include <string>
#include <string_view>

namespace stridor::fuzz {

inline io::structure::StructureInput input_of(std::string_view bytes) {
    return {recordings::bytes_of(std::string(bytes)), "input"};
}

/// What a reader of a part makes of the bytes; an error stands in the file.
template <typename Read>
void expect_end(Read read) {
    try {
        read();
    } catch (const Error& error) {
        require(error.kind() == ErrorKind::input && error.place().has_value() && !error.problem().what.empty());
    }
}

}  // namespace stridor::fuzz
