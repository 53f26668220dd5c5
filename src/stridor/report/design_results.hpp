#pragma once

#include "stridor/advice/advice.hpp"
#include "stridor/analysis/stability_scan.hpp"
#include "stridor/classification/sound_verdict.hpp"
#include "stridor/classification/verdict.hpp"
#include "stridor/integration/motion.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/sweep/cell.hpp"

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace stridor::report {

/// What one direction sounds like, of the motion that stands for the sound of the case (`hearing::heard_motion`).
struct DesignSound {
    parameters::Direction direction = parameters::Direction::going;
    classification::RecordingVerdict heard{};  // by ear
    std::string wav{};                         // the bytes of a WAV file; empty: nothing moves
};

/// What a report on one design is made from; what was not computed is left out.
struct DesignResults {
    parameters::Case design;
    std::string command{};                            // that makes the report, or prints the verdict, again
    integration::Motion motion{};                     // with trace and history for the picture
    std::vector<classification::Verdict> verdicts{};  // by phase
    std::string heard{};                              // "joint velocity along x"
    std::vector<DesignSound> sounds{};                // by direction
    std::string without_sound{};                      // why there is none
    std::optional<sweep::SweepResult> chart{};
    std::optional<analysis::StabilityScan> stability{};
    std::optional<advice::Advice> advice{};
    std::string without_advice{};  // why there is none, if it was wanted
};

/// The longest sound of a direction in a report [s]: 0.5 MB in the file.
inline constexpr double longest_sound = 4.0;

/// The motion of a design with its verdicts, sounds and stability: what costs little. Throws `Error` where the run has
/// no result (input, numerical) or was stopped (interrupted).
DesignResults basic_results(const parameters::Case& design, const std::stop_token& stop);

/// A chart in memory. Throws `Error` (interrupted) where it was stopped.
sweep::SweepResult chart_in_memory(const sweep::Study& study, int threads, const std::stop_token& stop);

}  // namespace stridor::report
