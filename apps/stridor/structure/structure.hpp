#pragma once

#include "stridor/io/structure/part_files.hpp"

#include <string>
#include <vector>

namespace CLI {
class App;
}

/// What the commands over finite-element parts share.
namespace stridor::app {

/// Which part, and in which units it is.
struct PartOptions {
    io::PartFiles files;
    std::string units = "m-kg-s";
    reduction::LinearSolver solver = reduction::LinearSolver::eigen;
};

void add_part_options(CLI::App& command, PartOptions& options);

/// Reads the part in SI and refuses it if it is no structure; its notes, and a doubt of its units, go to stderr.
reduction::ElasticPart load_part(const PartOptions& options);

void add_structure_info(CLI::App& structure);
void add_structure_check(CLI::App& structure);
void add_structure_reduce(CLI::App& structure);

}  // namespace stridor::app
