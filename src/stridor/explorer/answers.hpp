#pragma once

#include "stridor/base/error.hpp"
#include "stridor/explorer/body.hpp"
#include "stridor/explorer/http.hpp"
#include "stridor/explorer/world.hpp"

#include <stop_token>
#include <string>

/// One function per kind of request; api.cpp has the table of their paths. They throw `Error` for what cannot be answered.
namespace stridor::explorer {

/// A document; with a line end after it.
Response json(std::string document);

/// "stridor.explorer.error/1", on one line.
std::string error_document(const base::Problem& problem);

// answers_case.cpp
Response start(const World& world);
Response simulate(const World& world, const Json& body, const std::stop_token& stop);
Response motion(const World& world, const Json& body, const std::stop_token& stop);
Response stability(const World& world, const Json& body, const std::stop_token& stop);
Response toml(const World& world, const Json& body, const std::stop_token& stop);

// answers_chart.cpp
Response chart(const World& world, const Json& body, const std::stop_token& stop);

}  // namespace stridor::explorer
