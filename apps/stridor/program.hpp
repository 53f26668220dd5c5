#pragma once

#include <span>
#include <string>

namespace CLI {
class App;
}

namespace stridor::app {

/// A program with commands.
struct Program {
    std::string name;
    std::string description;
    std::string footer;
    std::span<void (*const)(CLI::App&)> commands;  // each adds its own to the program
};

/// Runs the command that the arguments ask for; the exit code. Says what went wrong, if anything does.
int run(const Program& program, int argc, char** argv);

/// What a program does before anything else: open its standard streams, take a closed pipe for an error.
void begin_process();

}  // namespace stridor::app
