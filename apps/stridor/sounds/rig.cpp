#include "sounds/rig.hpp"

#include "commands.hpp"

#include <CLI/CLI.hpp>

namespace stridor::app {

void add_rig(CLI::App& program) {
    CLI::App* rig =
        program.add_subcommand("rig", "Measurements on a test rig: friction from a force, and what moves the noise.");
    rig->require_subcommand(1);
    add_rig_friction(*rig);
    add_rig_sensitivity(*rig);
}

}  // namespace stridor::app
