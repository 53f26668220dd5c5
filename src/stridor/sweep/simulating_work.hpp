#pragma once

#include "stridor/crew/crew.hpp"
#include "stridor/integration/simulate.hpp"

#include <functional>
#include <optional>
#include <stop_token>
#include <string>

/// The work of a crew whose tasks are runs of an engine.
namespace stridor::sweep {

/// Computes one task; nothing if it was stopped. Several threads call it at once, each with its own workspace.
using Simulating = std::function<std::optional<std::string>(const crew::Task& task, const std::stop_token& stop,
                                                            integration::Workspace& workspace)>;

/// A work of this text (`crew::Work`). What `compute` refers to must outlive the crew.
crew::Work simulating_work(std::string text, Simulating compute);

}  // namespace stridor::sweep
