#pragma once

#include "stridor/io/structure/part_files.hpp"

#include <string>
#include <vector>

namespace CLI {
class App;
}

/// What the commands of finite-element parts share.
namespace stridor::app {

/// The part to use, and its units.
struct PartOptions {
    io::PartFiles files;
    std::string units = "m-kg-s";
    reduction::LinearSolver solver = reduction::LinearSolver::eigen;
};

void add_part_options(CLI::App& command, PartOptions& options);

/// Reads the part in SI. Throws `Error` (input) if it is not a structure; notes, and a doubt about its units, go to
/// stderr.
reduction::ElasticPart load_part(const PartOptions& options);

void add_structure_info(CLI::App& structure);
void add_structure_check(CLI::App& structure);
void add_structure_reduce(CLI::App& structure);

}  // namespace stridor::app
