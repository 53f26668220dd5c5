#pragma once

#include "stridor/io/case/toml_document.hpp"

#include <filesystem>
#include <map>
#include <string>

/// The explorer's page in one file, with its own module in place of a server.
namespace stridor::explorer {

/// Returns the page without a case that belongs to this program: beside it in a build folder, or where it was
/// installed. Throws `Error` (io) if there is none, with what makes one.
std::string one_file_page(const std::filesystem::path& program);

/// A case or a chart with all that it leans on.
struct StandingCase {
    std::string toml;
    std::map<std::string, std::string> files{};  // the bytes of those that the text still names, by their last part
};

/// Returns a case or a chart that stands alone: what its file names is read, and its numbers stand in the text; a file
/// that the text names still, such as the samples of a drive, is taken along. Throws `Error` (input) for a file that is
/// no case.
StandingCase standing_alone(const io::TomlSource& source);

/// Returns the page with a case in it. No text ends the element that holds it. Throws `Error` (io) if the page has no
/// place for a case.
std::string page_with_case(std::string page, const StandingCase& standing);

}  // namespace stridor::explorer
