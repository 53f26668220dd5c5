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
#include <utility>
#include <vector>

namespace stridor::advice {

/// How a design behaves: the verdict of each phase, by DesignSpace::phases, of all of its runs the worst one
/// (starts.hpp). A start that the design does not have, such as sliding where no steady sliding exists, is none of
/// them.
struct DesignVerdict {
    std::vector<sweep::StartVerdict> phases;
    std::string message{};                      // why it has no result; empty otherwise
    std::vector<parameters::Initial> starts{};  // of the run that each phase has its verdict from
    std::size_t runs = 0;                       // [1] that it took
};

/// Do both behave alike in every phase?
bool are_alike(const DesignVerdict& a, const DesignVerdict& b);

/// Is a phase `none` since it slides or sticks? What could not be computed or decided is not.
bool is_quiet_phase(const DesignVerdict& verdict, std::size_t phase);

/// Is every phase?
bool is_quiet(const DesignVerdict& verdict);

/// Is every phase quiet, and none of them because it sticks? The contact still rubs, and does so quietly.
bool slips_quietly(const DesignVerdict& verdict);

/// Does any phase squeal, squeak or creak?
bool is_noisy(const DesignVerdict& verdict);

/// Do the values contradict each other, so that there is no such design?
bool is_invalid(const DesignVerdict& verdict);

/// The worst of the phases (starts.hpp).
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

    /// Makes all designs from here on changes of a changed design: its settings come before their own.
    void set_out_from(std::vector<Design::Setting> settings) { first_ = std::move(settings); }

    /// Called from the caller's thread ten times a second, with the number of runs so far.
    void on_progress(std::function<void(std::size_t runs)> progress);

    /// Number of runs so far.
    std::size_t runs() const { return runs_; }

private:
    const DesignSpace& space_;
    std::unique_ptr<crew::Crew> crew_;
    std::function<void(std::size_t)> progress_{};
    std::vector<Design::Setting> first_{};
    std::size_t runs_ = 0;
};

}  // namespace stridor::advice
