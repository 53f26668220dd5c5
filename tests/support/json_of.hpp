#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace stridor::support {

/// A JSON document as the program prints it; throws `nlohmann::json::parse_error` for any other text. The parser's
/// templates are compiled here once for all tests of the program.
nlohmann::json json_of(const std::string& text);

}  // namespace stridor::support
