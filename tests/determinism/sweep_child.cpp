// Runs the sweep of `swept_study` into a store: sweep_child STORE THREADS REFINE. Its test kills it.

#include "determinism/swept_study.hpp"
#include "stridor/base/error.hpp"
#include "stridor/sweep/run.hpp"

#include <iostream>
#include <string>

int main(int argc, char** argv) {
    using namespace stridor;
    if (argc != 4) return 2;
    try {
        const sweep::Study study = sweep::swept_study(std::stoi(argv[3]));
        sweep::Store store(argv[1], study);
        sweep::RunOptions options;
        options.threads = std::stoi(argv[2]);
        // many commits, so that kills fall into some
        options.cells_per_commit = 4;
        sweep::run(study, store, options);
        return 0;
    } catch (const Error& error) {
        std::cerr << error.what() << '\n';
        return base::exit_code(error.kind());
    }
}
