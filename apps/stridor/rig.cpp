#include "rig.hpp"

#include "commands.hpp"

#include <CLI/CLI.hpp>

namespace stridor::app {

void add_rig(CLI::App& program) {
    CLI::App* rig = program.add_subcommand("rig", "Figures of measurements on a test rig.");
    rig->require_subcommand(1);
    add_rig_friction(*rig);
}

}  // namespace stridor::app
