#pragma once

#include "stridor/integration/run/end_state.hpp"
#include "stridor/parameters/case.hpp"

#include <string>
#include <string_view>

/// The end state of a run as a JSON document, "stridor.end-state/1" (docs/formats/results.md).
namespace stridor::io {

/// Returns the document of an end state of a case. Numbers read back bit for bit.
std::string end_state_json(const parameters::Case& c, const integration::EndState& state);

/// An end state that was read, and of which case it is.
struct ReadEndState {
    integration::EndState state;
    std::string case_hash;  // of `case_to_go_on`
};

/// Reads a document back; `name` is that of its file in messages. Throws `Error` (input) for any text that is none: not
/// JSON, of another schema, too large, damaged (its checksum), with numbers that are not finite, or of unlike sizes.
ReadEndState read_end_state(std::string_view text, const std::string& name);

/// Reads a file as above; "-" is standard input. Throws `Error` (io) besides.
ReadEndState read_end_state_file(const std::string& path);

/// Returns a hash of all that decides how a run of the case goes on: its canonical text without duration, window, early
/// ending and thresholds.
std::string case_to_go_on(const parameters::Case& c);

/// Throws `Error` (input) if the end state is none of this case.
void expect_same_case(const ReadEndState& read, const parameters::Case& c, const std::string& name);

/// Throws `Error` (input) if a run of this case cannot begin in that state: another number of degrees of freedom, or of
/// contacts.
void expect_same_shape(const ReadEndState& read, const parameters::Case& c, const std::string& name);

}  // namespace stridor::io
