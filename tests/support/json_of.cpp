#include "support/json_of.hpp"

namespace stridor::support {

nlohmann::json json_of(const std::string& text) {
    return nlohmann::json::parse(text);
}

}  // namespace stridor::support
