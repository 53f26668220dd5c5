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

/// Runs the command of the arguments and returns the exit code. Says an error on stderr.
int run(const Program& program, int argc, char** argv);

/// Prepares a process: opens its standard streams, and makes a closed pipe an error.
void begin_process();

}  // namespace stridor::app
