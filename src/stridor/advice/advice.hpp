#pragma once

#include "stridor/advice/headline.hpp"
#include "stridor/advice/margins.hpp"
#include "stridor/advice/quieting.hpp"
#include "stridor/advice/tolerance.hpp"
#include "stridor/crew/thread_crew.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

/// What keeps a design quiet: how far it is from another verdict, what to change, and the chance of noise.
namespace stridor::advice {

/// What advice is being worked on.
enum class AdviceStage { margins, nearest, changes, chance };

inline constexpr std::array<std::string_view, 4> advice_stage_names{"margins", "nearest design", "changes", "chance"};

/// How far advice is.
struct AdviceProgress {
    AdviceStage stage = AdviceStage::margins;
    std::size_t runs = 0;  // [1] designs simulated so far
    double share =
        0.0;  // [1] of the work done, never falling: an estimate, for each stage asks what the one before found
};

/// What becomes of advice that is stopped?
enum class WhenStopped {
    refused,  // an `Error` (interrupted)
    kept,     // what is known by then, with the stage in which it ended
};

/// What advice is asked for, and how it is computed.
struct AdviceOptions {
    std::vector<AskedRange> over{};            // what may be changed; empty: all with a usual range
    std::vector<AskedTolerance> tolerances{};  // empty: of a quiet design the default ones (`default_tolerances`)
    AskedRuns runs{};                          // by which motions a design is judged
    ChanceOptions chance{};
    crew::CrewMaker crew = crew::thread_crews();  // who computes
    std::stop_token stop{};                       // asks for an early end
    WhenStopped when_stopped = WhenStopped::refused;
    std::function<void(const AdviceProgress&)> progress{};  // called from the caller's thread
};

/// What a design does and what lies close to it.
struct DesignStanding {
    DesignSpace space{};
    DesignVerdict present{};
    std::optional<Neighbourhood> near{};  // of a quiet design, if it was looked for
};

/// The design that a change leads to, looked at as if it were the case.
struct ChangedDesign {
    DesignStanding standing{};
    std::optional<Chance> chance{};  // of noise within the tolerances asked for; within the usual ones where nobody did
};

/// Advice on a design.
struct Advice {
    DesignSpace space{};
    DesignVerdict present{};
    std::optional<Neighbourhood> near{};     // of a quiet design: what lies within a few per cent of it
    std::vector<ParameterMargin> margins{};  // by parameter
    std::vector<std::size_t> ranking{};  // parameters by what they buy: smallest verified quieting change first, or,
                                         // of a quiet design, smallest distance to the nearest change of verdict
    std::optional<NearestDesign>
        nearest{};  // as a whole: the nearest quiet design, or, of a quiet one, the nearest not quiet
    std::vector<DesignChange> changes{};       // verified quieting changes, smallest first; none of a quiet design
    std::optional<std::size_t> recommended{};  // which of them
    std::optional<ChangedDesign> changed{};    // where that one leads; nothing where it was not looked at
    std::optional<Chance> chance{};            // of noise within tolerances, of the design as it is
    std::size_t runs = 0;                      // [1] simulated motions
    std::optional<AdviceStage> stopped_in{};   // `WhenStopped::kept`: what of this stage and those behind it is missing
};

/// How far a design is looked at.
enum class Look { here, around };

/// Judges a design, and looks around it if it is quiet: what its headline needs, much cheaper than advice. Throws as
/// `advise` does.
DesignStanding standing_of(const parameters::Case& c, Look look, const AdviceOptions& options = {});

/// The line that is said first of a design (`headline`).
std::string headline(const Advice& advice);
std::string headline(const DesignStanding& design);

/// Says how far the changed design is from noise: "quiet, but only just: 0.4 % less plate mass squeals; chance of
/// noise within usual tolerances 12 % (8.1 to 17 %)".
std::string changed_words(const ChangedDesign& changed);

/// Advice on a case: the same for every crew. Throws `Error` (input) for what is wrong with case and
/// options, and (interrupted) when stopped, unless what is known is kept.
Advice advise(const parameters::Case& c, const AdviceOptions& options = {});

/// The change as options of the command line: "--set contact.preload=12 --set ...".
std::string settings_of(const DesignSpace& space, const DesignChange& change);

}  // namespace stridor::advice
