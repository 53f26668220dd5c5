#pragma once

#include "stridor/advice/design_space.hpp"
#include "stridor/sweep/starts.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace stridor::advice {

/// How a design behaves: the verdict of each phase, by DesignSpace::phases.
struct DesignVerdict {
    std::vector<sweep::StartVerdict> phases;
    std::vector<classification::Quiet> quiet{};  // why each phase is quiet, if it is
    std::string message{};                       // why it has no result; empty otherwise
};

/// Do both behave alike in every phase?
bool are_alike(const DesignVerdict& a, const DesignVerdict& b);

/// Is every phase `none`? What could not be computed or decided is not.
bool is_quiet(const DesignVerdict& verdict);

/// Is every phase `none`, and none of them because it sticks? The contact still rubs, and does so quietly.
bool slips_quietly(const DesignVerdict& verdict);

/// Does any phase squeal, squeak or creak?
bool is_noisy(const DesignVerdict& verdict);

/// Do the values contradict each other, so that there is no such design?
bool is_invalid(const DesignVerdict& verdict);

/// The loudest of the phases (starts.hpp).
sweep::StartVerdict overall(const DesignVerdict& verdict);

/// Runs designs on many threads.
class DesignRunner {
public:
    /// `threads` 0: one per processor this process may use.
    DesignRunner(int threads, std::stop_token stop);
    ~DesignRunner();
    DesignRunner(const DesignRunner&) = delete;
    DesignRunner& operator=(const DesignRunner&) = delete;

    /// The verdicts of designs, in their order, whatever the number of threads.
    /// Throws `Error` (interrupted) when stopped.
    std::vector<DesignVerdict> judge(const DesignSpace& space, std::span<const Shares> designs);
    /// The same for designs that are given as cases.
    std::vector<DesignVerdict> judge(const DesignSpace& space, std::span<const parameters::Case> cases);

    /// Called from the caller's thread after every few runs, with their number so far.
    void on_progress(std::function<void(std::size_t runs)> progress);

    /// Number of runs so far.
    std::size_t runs() const;

private:
    struct Threads;
    std::unique_ptr<Threads> threads_;
};

}  // namespace stridor::advice
