// Runs the sweep of `swept_study` into a store and prints how many cells it computed: sweep_child STORE THREADS REFINE
// [READY GO]. Its test kills it: a mark goes to stderr when it begins, when the store is open and as batches of cells
// are kept. READY and GO are two open pipes: it writes a byte into one and begins when the other one is closed.

#include "determinism/swept_study.hpp"
#include "stridor/base/error.hpp"
#include "stridor/sweep/run.hpp"

#include <unistd.h>

#include <functional>
#include <iostream>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace stridor;

void mark() {
    std::cerr << '.' << std::flush;
}

// marks what it keeps
class MarkingKeeper final : public sweep::CellKeeper {
public:
    explicit MarkingKeeper(sweep::Store& store) : store_(store) {}

    std::string name() const override { return store_.name(); }
    std::vector<bool> stored() override { return store_.stored(); }
    sweep::Counts counts() override { return store_.counts(); }
    void write(std::span<const sweep::IndexedCell> cells) override {
        store_.write(cells);
        mark();
    }
    void visit(std::size_t first, std::size_t last, const std::function<void(sweep::IndexedCell&)>& use) override {
        store_.visit(first, last, use);
    }

private:
    sweep::Store& store_;
};

void wait_for_go(int ready, int go) {
    char byte = 0;
    if (write(ready, &byte, 1) != 1 || read(go, &byte, 1) != 0) throw std::runtime_error("no barrier");
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4 && argc != 6) return 2;
    try {
        const sweep::Study study = sweep::swept_study(std::stoi(argv[3]));
        if (argc == 6) wait_for_go(std::stoi(argv[4]), std::stoi(argv[5]));
        mark();
        sweep::Store store(argv[1], study);
        mark();
        MarkingKeeper keeper(store);
        sweep::RunOptions options;
        options.crew = crew::thread_crews(std::stoi(argv[2]));
        // many commits, so that kills fall into some
        options.cells_per_commit = 4;
        std::cout << sweep::run(study, keeper, options).computed << std::endl;
        return 0;
    } catch (const Error& error) {
        std::cerr << error.what() << '\n';
        return base::exit_code(error.kind());
    }
}
