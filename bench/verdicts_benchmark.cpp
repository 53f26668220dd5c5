// What a margin is worth: how many verdicts of random cases turn where they must not, by a change of 1e-9, by a shift
// of the window and by another engine, and how many of those were told undecided.
//
//     verdicts_benchmark [cases = 1000] [file.csv]
//
// The file has a row per phase and change that gave another category.

#include "stridor/classification/contact_rules.hpp"
#include "stridor/integration/run/motion.hpp"
#include "stridor/integration/simulate.hpp"
#include "support/counter_random.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cstring>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace stridor {
namespace {

using classification::Category;
using classification::Verdict;
using parameters::Case;

// around Table 1: every angle, friction and preload at which something happens
Case random_case(std::uint64_t number) {
    support::CounterRandom random(number);
    Case c;
    c.joint().mass *= random.decades(0.5, 2.0);
    c.joint().axial_stiffness *= random.decades(0.3, 3.0);
    c.joint().flexural_stiffness *= random.decades(0.3, 3.0);
    c.joint().axial_damping *= random.decades(0.3, 3.0);
    c.joint().flexural_damping *= random.decades(0.3, 3.0);
    c.joint().incidence_angle = random.between(30.0, 150.0);
    c.plate.mass *= random.decades(0.5, 2.0);
    c.plate.stiffness *= random.decades(0.3, 3.0);
    c.contact().preload = random.decades(2.0, 2000.0);
    c.contact().static_friction = random.between(0.1, 1.2);
    c.contact().kinetic_friction = c.contact().static_friction * random.between(0.2, 1.0);
    if (random.one_in(2)) {
        c.drive.kind = parameters::DriveKind::constant;
        c.drive.velocity = random.decades(0.02, 0.5) * (random.one_in(2) ? 1.0 : -1.0);
        c.run.duration = 1.0;
        c.run.window = 0.5;
    } else {
        c.drive.kind = parameters::DriveKind::sinusoidal;
        c.drive.amplitude = random.decades(1e-3, 8e-3);
        c.drive.frequency = random.between(2.0, 10.0);
        c.run.duration = 4.0 / c.drive.frequency;
        c.run.window = 2.0 / c.drive.frequency;
    }
    return c;
}

// what must not change a verdict
struct Change {
    std::string_view name;
    std::uint64_t every;  // one case in so many
    void (*make)(Case&);
};

constexpr double shift = 0.03;  // [1] of a window of a constant drive, which knows no period

constexpr std::array changes{
    Change{"preload by 1e-9", 1, [](Case& c) { c.contact().preload *= 1.0 + 1e-9; }},
    Change{"stiffness by 1e-9", 1, [](Case& c) { c.joint().flexural_stiffness *= 1.0 + 1e-9; }},
    Change{"window", 1,
           [](Case& c) {
               const bool has_period = c.drive.kind == parameters::DriveKind::sinusoidal;
               c.run.duration += has_period ? 1.0 / c.drive.frequency : shift * c.run.window;
           }},
    Change{"beta_2, 1e-6 s", 1,
           [](Case& c) {
               c.run.engine = parameters::Engine::beta_2;
               c.run.step = 1e-6;
           }},
    Change{"moreau, 1e-6 s", 5,
           [](Case& c) {
               c.run.engine = parameters::Engine::moreau;
               c.run.step = 1e-6;
           }},
};

struct Count {
    long phases = 0;
    long turned = 0;  // another category, whatever the errors of its figures are: `least_distance` = 0
    long silent = 0;  // another category, and none of the two is undecided
};

struct Judged {
    std::vector<record::Tally> phases;
    std::vector<Verdict> verdicts;
    std::vector<Verdict> bold;  // without any distance
};

Judged judged(const Case& c) {
    const integration::Motion motion = integration::simulate(c);
    if (!integration::has_result(motion.outcome)) return {};
    parameters::Thresholds bold = c.verdict;
    bold.least_distance = 0.0;
    return {motion.record.phases, classification::classify_phases(motion.record.phases, c.verdict),
            classification::classify_phases(motion.record.phases, bold)};
}

std::string margins_text(const Verdict& verdict) {
    std::string text(classification::name(verdict.category));
    for (const classification::Margin& margin : verdict.margins)
        text += fmt::format(",{:.6g},{:.3g}", margin.figure, margin.error.value_or(0.0));
    return text;
}

void compare(const Judged& before, const Judged& after, Count& count, const std::string& key, std::ostream& rows) {
    for (std::size_t k = 0; k < std::min(before.verdicts.size(), after.verdicts.size()); ++k) {
        const Category one = before.verdicts[k].category, other = after.verdicts[k].category;
        const bool is_told = one == Category::undecided || other == Category::undecided;
        ++count.phases;
        if (before.bold[k].category != after.bold[k].category) ++count.turned;
        if (one != other && !is_told) ++count.silent;
        if (one != other || before.bold[k].category != after.bold[k].category)
            rows << fmt::format("{},{},{},{}\n", key, k, margins_text(before.verdicts[k]),
                                margins_text(after.verdicts[k]));
    }
}

long undecided(const std::vector<Verdict>& verdicts) {
    long count = 0;
    for (const Verdict& verdict : verdicts)
        count += verdict.category == Category::undecided ? 1 : 0;
    return count;
}

void run(std::uint64_t cases, std::ostream& rows) {
    std::array<Count, changes.size()> counts{};
    std::array<long, classification::category_names.size()> categories{};
    long phases = 0, thin = 0;
    for (std::uint64_t number = 0; number < cases; ++number) {
        const Case c = random_case(number);
        const Judged before = judged(c);
        phases += static_cast<long>(before.verdicts.size());
        thin += undecided(before.bold);
        for (const Verdict& verdict : before.verdicts)
            ++categories[static_cast<std::size_t>(verdict.category)];
        for (std::size_t k = 0; k < changes.size(); ++k) {
            if (number % changes[k].every != 0) continue;
            Case changed = c;
            changes[k].make(changed);
            compare(before, judged(changed), counts[k], fmt::format("{},{}", number, changes[k].name), rows);
        }
    }
    fmt::print("{} cases, {} phases:", cases, phases);
    for (std::size_t k = 0; k < categories.size(); ++k)
        fmt::print(" {} {}", classification::category_names[k], categories[k]);
    fmt::print("\nundecided without a distance (too few beats, one release): {}\n\n", thin);
    fmt::print("{:<20}{:>8}{:>8}{:>12}\n", "changed", "phases", "turn", "silently");
    for (std::size_t k = 0; k < changes.size(); ++k)
        fmt::print("{:<20}{:>8}{:>8}{:>12}\n", changes[k].name, counts[k].phases, counts[k].turned, counts[k].silent);
}

}  // namespace
}  // namespace stridor

int main(int argc, char** argv) {
    std::uint64_t cases = 1000;
    if (argc > 1) std::from_chars(argv[1], argv[1] + std::strlen(argv[1]), cases);
    std::ofstream rows;
    if (argc > 2) rows.open(argv[2]);
    stridor::run(cases, rows);
    return 0;
}
