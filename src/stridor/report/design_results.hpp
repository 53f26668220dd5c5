#pragma once

#include "stridor/advice/advice.hpp"
#include "stridor/advice/design_space.hpp"
#include "stridor/analysis/stability_scan.hpp"
#include "stridor/base/error.hpp"
#include "stridor/classification/recording_verdict.hpp"
#include "stridor/classification/verdict.hpp"
#include "stridor/integration/motion.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/record/schedule.hpp"
#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/run.hpp"
#include "stridor/sweep/study.hpp"

#include <chrono>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace stridor::report {

using PartTime = std::chrono::duration<double>;  // [s]

/// What one direction sounds like, of the motion that stands for the sound of the case (`hearing::heard_motion`).
struct DesignSound {
    parameters::Direction direction = parameters::Direction::going;
    classification::RecordingVerdict heard{};  // by ear
    std::string wav{};                         // the bytes of a WAV file; empty: nothing moves
};

/// A motion of a design: of all starts the one that speaks most for noise, in the directions for which it stands.
struct DesignMotion {
    parameters::Case of{};              // the design with direction and start put in
    std::vector<record::Phase> phases;  // of the design
    integration::Motion motion{};       // with trace and history for the picture
};

/// What a report on one design is made from; what was not computed is left out.
struct DesignResults {
    parameters::Case design;
    std::string author{};                             // who answers for it
    std::string part{};                               // its number
    std::string file{};                               // of the case
    std::string date{};                               // of the report: "2026-11-25"
    std::string command{};                            // that makes the report, or prints the verdict, again
    advice::DesignStanding standing{};                // what it does, both ways and from every start
    std::vector<DesignMotion> motions{};              // in the order of the directions, each once
    std::vector<classification::Verdict> verdicts{};  // by phase of the design, of those motions
    std::string heard{};                              // "joint velocity along x"
    std::vector<DesignSound> sounds{};                // by direction
    std::string without_sound{};                      // why there is none
    std::optional<sweep::SweepResult> chart{};
    std::string about_chart{};  // why it is coarse, or is not there
    std::optional<analysis::StabilityScan> stability{};
    std::string without_stability{};  // why there is none
    std::optional<advice::Advice> advice{};
    std::string without_advice{};           // why there is none or not all of it, if it was wanted
    std::optional<PartTime> advice_time{};  // in which it did not end
};

/// The longest sound of a direction in a report [s]: 0.5 MB in the file.
inline constexpr double longest_sound = 4.0;

/// A design with its verdicts and motions, which no report goes without, and its stability where that is known. Throws
/// `Error` where no run has a result (input, numerical) or one was stopped (interrupted).
DesignResults basic_results(const parameters::Case& design, const advice::AdviceOptions& options);

/// Returns the day of today, or of SOURCE_DATE_EPOCH where that is set: "2026-11-25". Throws `Error` (input) where that
/// is no number.
std::string report_date();

/// What a report says first (`advice::headline`): with what lies close to the design, where advice looked at it.
std::string headline(const DesignResults& results);

/// Says why a part is left out, as a sentence. Throws the error again where it is no reason to go on without (anything
/// but input and numerical).
std::string reason_of(const Error& error);

/// A chart in memory. Throws `Error` (interrupted) where it was stopped.
sweep::SweepResult chart_in_memory(const sweep::Study& study, const sweep::RunOptions& options);

/// The chart of a report: over the axes asked for, else those of the file, else preload and kinetic friction (or the
/// temperature that it follows) within their usual ranges. No axis has more than so many points; it has categories
/// alone, of the same directions and starts as the design is judged by.
///
/// Throws `Error` (input) for one axis alone, and what reading a study and `advice::design_space` throw.
sweep::Study chart_to_report(const io::TomlSource& source, const parameters::Case& c, io::AxisTexts axes, int points,
                             const advice::AskedRuns& runs = {});

/// Gives a chart the directions and starts by which a design is judged.
void judge_alike(sweep::Study& study, const advice::DesignSpace& space);

}  // namespace stridor::report
