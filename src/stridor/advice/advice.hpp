#pragma once

#include "stridor/advice/headline.hpp"
#include "stridor/advice/margins.hpp"
#include "stridor/advice/quieting.hpp"
#include "stridor/advice/tolerance.hpp"
#include "stridor/crew/crew.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

/// How far a quiet design is from another verdict, what to change on a noisy one, and the chance of noise.
namespace stridor::advice {

/// The stages of the work on advice.
enum class AdviceStage { margins, nearest, changes, chance };

inline constexpr std::array<std::string_view, 4> advice_stage_names{"margins", "nearest design", "changes", "chance"};

/// The progress of advice.
struct AdviceProgress {
    AdviceStage stage = AdviceStage::margins;
    std::size_t runs = 0;  // [1] designs simulated so far
    double share =
        0.0;  // [1] of the work done, never falling: an estimate, for each stage asks what the one before found
};

/// What happens to advice that is stopped.
enum class WhenStopped {
    refused,  // an `Error` (interrupted)
    kept,     // the results so far, with the stage in which it ended
};

/// The request for advice, and how it is computed.
struct AdviceOptions {
    std::vector<AskedRange> over{};            // the quantities to change; empty: all with a usual range
    std::vector<AskedTolerance> tolerances{};  // empty: the default ones of a quiet design (`default_tolerances`)
    AskedRuns runs{};                          // the motions by which a design is judged
    ChanceOptions chance{};
    crew::CrewMaker crew = crew::thread_crews();  // the crew that computes
    std::stop_token stop{};                       // asks for an early end
    WhenStopped when_stopped = WhenStopped::refused;
    std::function<void(const AdviceProgress&)> progress{};  // called from the caller's thread
};

/// The verdict on a design, and the changes of verdict close to it.
struct DesignStanding {
    DesignSpace space{};
    DesignVerdict present{};
    std::optional<Neighbourhood> near{};  // of a quiet design, if it was looked for
};

/// The design that a change leads to, judged as if it were the case.
struct ChangedDesign {
    DesignStanding standing{};
    std::optional<Chance> chance{};  // of noise within the given tolerances, else the usual ones
};

/// Advice on a design.
struct Advice {
    DesignSpace space{};
    DesignVerdict present{};
    std::optional<Neighbourhood> near{};     // of a quiet design: the changes within a few per cent of it
    std::vector<ParameterMargin> margins{};  // by parameter
    std::vector<std::size_t> ranking{};  // parameters by what they buy: smallest verified quieting change first, or,
                                         // of a quiet design, smallest distance to the nearest change of verdict
    std::optional<NearestDesign>
        nearest{};  // as a whole: the nearest quiet design, or, of a quiet one, the nearest not quiet
    std::vector<DesignChange> changes{};       // verified quieting changes, smallest first; empty for a quiet design
    std::optional<std::size_t> recommended{};  // the place of the recommended one
    std::optional<ChangedDesign> changed{};    // the design that it leads to; `std::nullopt` if not examined
    std::optional<Chance> chance{};            // of noise within tolerances, of the present design
    std::size_t runs = 0;                      // [1] simulated motions
    std::optional<AdviceStage> stopped_in{};   // `WhenStopped::kept`: the results of this and later stages are missing
};

/// Whether only a design is judged, or also the designs around it.
enum class Look { here, around };

/// Judges a design, and looks around it if it is quiet. That is enough for its headline, and much cheaper than advice.
/// Throws as `advise` does.
DesignStanding standing_of(const parameters::Case& c, Look look, const AdviceOptions& options = {});

/// Returns the first line about a design (`headline`).
std::string headline(const Advice& advice);
std::string headline(const DesignStanding& design);

/// Returns how far the changed design is from noise: "quiet, but only just: 0.4 % less plate mass squeals; chance of
/// noise within usual tolerances 12 % (8.1 to 17 %)".
std::string changed_words(const ChangedDesign& changed);

/// Returns advice on a case; the result does not depend on the crew. Throws `Error` (input) for faults of the case and
/// the options, and (interrupted) when stopped, unless the results so far are kept.
Advice advise(const parameters::Case& c, const AdviceOptions& options = {});

/// Returns the change as options of the command line: "--set contact.preload=12 --set ...".
std::string settings_of(const DesignSpace& space, const DesignChange& change);

}  // namespace stridor::advice
