#pragma once

#include "stridor/advice/design_space.hpp"
#include "stridor/crew/crew.hpp"
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

/// The judging of designs as the work of a crew. The space must outlive the crew.
crew::Work work_of(const DesignSpace& space);

/// Has a crew judge designs of a space.
class DesignRunner {
public:
    /// The space must outlive it.
    DesignRunner(const DesignSpace& space, const crew::CrewMaker& crew, const std::stop_token& stop);

    /// The verdicts of designs, in their order, whoever computes them.
    /// Throws `Error` (interrupted) when stopped.
    std::vector<DesignVerdict> judge(std::span<const Design> designs);
    /// The same for points of the box.
    std::vector<DesignVerdict> judge(std::span<const Shares> points);

    /// Called from the caller's thread ten times a second, with the number of runs so far.
    void on_progress(std::function<void(std::size_t runs)> progress);

    /// Number of runs so far.
    std::size_t runs() const { return runs_; }

private:
    const DesignSpace& space_;
    std::unique_ptr<crew::Crew> crew_;
    std::function<void(std::size_t)> progress_{};
    std::size_t runs_ = 0;
};

}  // namespace stridor::advice
