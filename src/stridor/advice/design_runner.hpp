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

/// The verdict on a design: that of each phase, by DesignSpace::phases, the worst of all of its runs (starts.hpp). A
/// start that the design does not have, such as sliding where no steady sliding exists, does not count.
struct DesignVerdict {
    std::vector<sweep::StartVerdict> phases;
    std::string message{};                      // why it has no result; empty otherwise
    std::vector<parameters::Initial> starts{};  // of the run that decided each phase
    std::size_t runs = 0;                       // [1] simulated for it
};

/// Says whether both verdicts are equal in every phase.
bool are_alike(const DesignVerdict& a, const DesignVerdict& b);

/// Says whether a phase is `none` since it slides or sticks. A phase that could not be computed or decided is not.
bool is_quiet_phase(const DesignVerdict& verdict, std::size_t phase);

/// Says whether every phase is quiet.
bool is_quiet(const DesignVerdict& verdict);

/// Says whether every phase is quiet without sticking. The contact still rubs, and does so quietly.
bool slips_quietly(const DesignVerdict& verdict);

/// Says whether any phase squeals, squeaks or creaks.
bool is_noisy(const DesignVerdict& verdict);

/// Says whether the values contradict each other, so that there is no such design.
bool is_invalid(const DesignVerdict& verdict);

/// Returns the worst verdict of the phases (starts.hpp).
sweep::StartVerdict overall(const DesignVerdict& verdict);

/// Returns the judging of designs as the work of a crew. The space must outlive the crew.
crew::Work work_of(const DesignSpace& space);

/// Lets a crew judge designs of a space.
class DesignRunner {
public:
    /// Makes the crew. The space must outlive this object.
    DesignRunner(const DesignSpace& space, const crew::CrewMaker& crew, const std::stop_token& stop);

    /// Returns the verdicts of designs, in their order, for any crew. Throws `Error` (interrupted) when stopped.
    std::vector<DesignVerdict> judge(std::span<const Design> designs);
    /// Returns the verdicts of points of the box, in their order. Throws `Error` (interrupted) when stopped.
    std::vector<DesignVerdict> judge(std::span<const Shares> points);

    /// Applies these settings to all later designs, before their own.
    void set_out_from(std::vector<Design::Setting> settings) { first_ = std::move(settings); }

    /// Sets a function that is called from the caller's thread ten times a second, with the number of runs so far.
    void on_progress(std::function<void(std::size_t runs)> progress);

    /// Returns the number of runs so far.
    std::size_t runs() const { return runs_; }

private:
    const DesignSpace& space_;
    std::unique_ptr<crew::Crew> crew_;
    std::function<void(std::size_t)> progress_{};
    std::vector<Design::Setting> first_{};
    std::size_t runs_ = 0;
};

}  // namespace stridor::advice
