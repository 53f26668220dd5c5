#pragma once

namespace CLI {
class App;
}

namespace stridor::app {

/// Adds a command per figure of the rig: `stridor rig NAME`.
void add_rig_friction(CLI::App& rig);
void add_rig_sensitivity(CLI::App& rig);

}  // namespace stridor::app
