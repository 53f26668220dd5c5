#pragma once

#include "stridor/advice/advice.hpp"
#include "stridor/advice/design_space.hpp"
#include "stridor/analysis/stability_scan.hpp"
#include "stridor/base/error.hpp"
#include "stridor/classification/recording_verdict.hpp"
#include "stridor/classification/verdict.hpp"
#include "stridor/integration/run/motion.hpp"
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

/// The sound of one direction, from the motion that is heard as the sound of the case (`hearing::heard_motion`).
struct DesignSound {
    parameters::Direction direction = parameters::Direction::going;
    classification::RecordingVerdict heard{};  // by ear
    std::string wav{};                         // the bytes of a WAV file; empty: silence
};

/// A motion of a design: from the start with the worst verdict, in the directions that it represents.
struct DesignMotion {
    parameters::Case of{};              // the design with its direction and start
    std::vector<record::Phase> phases;  // of the design
    integration::Motion motion{};       // with trace and history for the picture
};

/// The results for a report on one design; parts that were not computed are left out.
struct DesignResults {
    parameters::Case design;
    std::string author{};                             // who is responsible for it
    std::string part{};                               // its number
    std::string file{};                               // of the case
    std::string date{};                               // of the report: "2026-11-25"
    std::string command{};                            // that repeats the report, or prints the verdict
    advice::DesignStanding standing{};                // its verdicts, both ways and from every start
    std::vector<DesignMotion> motions{};              // in the order of the directions, each once
    std::vector<classification::Verdict> verdicts{};  // by phase of the design, of those motions
    std::string heard{};                              // "joint velocity along x"
    std::vector<DesignSound> sounds{};                // by direction
    std::string without_sound{};                      // why there is none
    std::optional<sweep::SweepResult> chart{};
    std::string about_chart{};  // why it is coarse or missing
    std::optional<analysis::StabilityScan> stability{};
    std::string without_stability{};  // why there is none
    std::optional<advice::Advice> advice{};
    std::string without_advice{};           // why there is none or not all of it, if it was asked for
    std::optional<PartTime> advice_time{};  // the time in which it did not end
};

/// The longest sound of a direction in a report [s]: 0.5 MB in the file.
inline constexpr double longest_sound = 4.0;

/// Returns a design with its verdicts and motions, which every report needs, and its stability if that is known. Throws
/// `Error` if no run has a result (input, numerical) or one was stopped (interrupted).
DesignResults basic_results(const parameters::Case& design, const advice::AdviceOptions& options);

/// Returns the day of today, or of SOURCE_DATE_EPOCH if that is set: "2026-11-25". Throws `Error` (input) if that is
/// not a number.
std::string report_date();

/// Returns the first line of a report (`advice::headline`), with the changes close to the design if advice looked for
/// them.
std::string headline(const DesignResults& results);

/// Returns why a part is left out, as a sentence. Throws the error again if the report cannot go on without the part
/// (any kind but input and numerical).
std::string reason_of(const Error& error);

/// Returns a chart computed in memory. Throws `Error` (interrupted) if it was stopped.
sweep::SweepResult chart_in_memory(const sweep::Study& study, const sweep::RunOptions& options);

/// Returns the chart of a report: over the axes asked for, else those of the file, else preload and kinetic friction
/// (or the temperature on which it depends) within their usual ranges. No axis has more than `points` points; the chart
/// has categories alone, with the directions and starts by which the design is judged.
///
/// Throws `Error` (input) for one axis alone, and the errors of reading a study and of `advice::design_space`.
sweep::Study chart_to_report(const io::TomlSource& source, const parameters::Case& c, io::AxisTexts axes, int points,
                             const advice::AskedRuns& runs = {});

/// Gives a chart the directions and starts by which a design is judged.
void judge_alike(sweep::Study& study, const advice::DesignSpace& space);

}  // namespace stridor::report
