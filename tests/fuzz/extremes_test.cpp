// Every numeric field far from any sense, over the four cases of Table 1, all drives and both engines: a refusal that
// names what is wrong, an outcome that says so, or figures that agree with each other; soon, or within a second of
// Ctrl-C, in little memory. STRIDOR_EXTREMES=all tries every combination (minutes); without it each field meets each
// value in a few of
// them.

#include "stridor/base/error.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/parameters/rules/check.hpp"
#include "support/effort.hpp"
#include "support/oracles/figure_laws.hpp"
#include "support/patience.hpp"
#include "support/shrink.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

namespace stridor {
namespace {

using namespace parameters;

bool tries_all() {
    return std::getenv("STRIDOR_EXTREMES") != nullptr;
}

std::vector<double> extremes(const Range& range) {
    constexpr double most = std::numeric_limits<double>::max();
    std::vector<double> values{1e-300, 1e-12, 1e12, 1e300, std::max(range.low, -most), std::min(range.high, most)};
    if (range.low_end == Range::Low::open) values[4] = std::nextafter(range.low, most);
    return values;
}

Case with_drive(Case c, DriveKind kind) {
    c.drive.kind = kind;
    if (kind != DriveKind::sampled) return c;
    c.drive.times = {0.0, 0.1, 0.2, 0.3, 0.5};
    c.drive.velocities = {0.1, -0.1, 0.0, 0.1, -0.1};
    return c;
}

Case with_engine(Case c, Engine engine) {
    c.run.engine = engine;
    c.run.step = 1e-5;
    if (engine == Engine::beta_2) c.contact().impact = ImpactKind::plastic;
    return c;
}

// what is wrong with what became of a case; empty if nothing is
std::string complaint(const Case& c, double patience_in_seconds) {
    const std::vector<Finding> found = findings(c);
    for (const Finding& finding : found)
        if (finding.problem.what.empty() || find_field(finding.key) == nullptr) return "a refusal without a reason";
    if (!found.empty()) return {};
    return support::complaint_of_run(c, patience_in_seconds);
}

TEST(Extremes, OfEveryFieldEndSoonAndSayWhatTheyAre) {
    const double patience = tries_all() ? 10.0 : 0.1;
    std::size_t number = 0, runs = 0;
    for (const PaperCase name : {PaperCase::squeal, PaperCase::squeak, PaperCase::creak, PaperCase::quiet})
        for (const DriveKind drive :
             {DriveKind::sinusoidal, DriveKind::constant, DriveKind::sampled, DriveKind::trapezoidal})
            for (const Engine engine : {Engine::exact, Engine::beta_2})
                for (const Field& field : fields()) {
                    const auto* quantity = std::get_if<Quantity>(&field.kind);
                    if (quantity == nullptr) continue;
                    for (const double value : extremes(quantity->range)) {
                        constexpr std::size_t every = support::effort<std::size_t>(5, 29);
                        if (!tries_all() && number++ % every != 0) continue;
                        Case c = with_engine(with_drive(paper_case(name), drive), engine);
                        c.run.duration = c.run.window = 0.4;
                        if (field.name == "restitution") c.contact().impact = ImpactKind::restitution;
                        if (field.name == "perturbation") c.run.initial = Initial::sliding;
                        try {
                            set_quantity(c, field, value);
                        } catch (const Error&) {
                            continue;  // out of the field's range
                        }
                        // a coefficient alone contradicts the other one
                        if (field.name == "kinetic_friction")
                            c.contact().static_friction = std::max(value, c.contact().static_friction);
                        if (field.name == "static_friction")
                            c.contact().kinetic_friction = std::min(value, c.contact().kinetic_friction);
                        if (field.name == "duration") c.run.window = std::min(c.run.window, value);
                        ++runs;
                        EXPECT_EQ(complaint(c, patience), "") << support::command_of(c);
                    }
                }
    EXPECT_GT(runs, 100U);
}

TEST(Extremes, TakeLittleMemory) {
    constexpr long most = support::effort(200L, 1024L) * 1024;  // [kB] sanitizers keep what was freed
    Case c = paper_case(PaperCase::squeal);
    c.drive.frequency = 1e5;
    c.run.duration = c.run.window = 1.0;
    ASSERT_TRUE(findings(c).empty());
    support::Patience patience(0.1);
    (void)integration::simulate(c, {}, patience.token());
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    EXPECT_LT(used.ru_maxrss, most) << "kB, of this program with all its tests";
}

}  // namespace
}  // namespace stridor
