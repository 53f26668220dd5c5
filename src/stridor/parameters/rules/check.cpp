#include "stridor/parameters/rules/check.hpp"

#include "stridor/base/text.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/fields/field_belongs.hpp"
#include "stridor/parameters/fields/friction_keys.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/parameters/rules/engines.hpp"
#include "stridor/parameters/rules/resolution.hpp"
#include "stridor/parameters/start.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/parameters/tables/material_pair.hpp"
#include "stridor/parameters/tables/temperature_table.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace stridor::parameters {

namespace {

using base::shortest;

// of a phase: less than this rest is not told from nothing
constexpr double most_cut = 1.0 - 1e-9;
// [m/s] of a sampled drive; above it are overloads, and energies that say nothing
constexpr double fastest_sample = 1e6;
// of an engine with steps in a stretch that is judged
constexpr double least_steps = 10.0;

void check_friction(CaseView at, const FrictionKeys& keys, std::vector<Finding>& found) {
    const double kinetic = get_quantity(at, *find_field(keys.kinetic));
    const double limit = get_quantity(at, *find_field(keys.limit));
    if (kinetic <= limit) return;
    found.push_back({std::string(keys.kinetic),
                     {std::string(keys.kinetic_symbol) + " = " + shortest(kinetic) + " exceeds " +
                          std::string(keys.limit_symbol) + " = " + shortest(limit),
                      "kinetic friction may not be larger than static", "Swap them?"},
                     {keys.limit}});
}

// [m/s] of a drive that may come from a file
double fastest_surface(const Drive& drive) {
    double most = is_of_file(drive) ? 0.0 : greatest_speed(drive);
    for (const double velocity : drive.velocities)
        if (is_of_file(drive)) most = std::max(most, std::abs(velocity));
    return most;
}

// a force as measured whose file nobody has read
void check_axial_force(CaseView at, std::vector<Finding>& found) {
    const Joint& joint = at.own().joint;
    if (!has_plate(at.c) || joint.stiffening != Stiffening::table || !joint.axial_force.deflections.empty()) return;
    const std::string why =
        joint.axial_force.file.empty() ? "" : "the file \"" + joint.axial_force.file + "\" was not read";
    found.push_back({"joint.axial_force",
                     {"joint.axial_force has no rows", why, "Give rows, or a CSV file."},
                     {"joint.stiffening"}});
}

// friction as measured: below mu_s, and over what the surface alone makes of it
void check_friction_table(CaseView at, std::vector<Finding>& found) {
    const Contact& contact = at.own().contact;
    const FrictionTable& table = contact.friction_table;
    if (contact.friction != FrictionKind::table) return;
    if (table.speeds.empty()) {
        found.push_back({"contact.friction_table",
                         {"contact.friction_table has no rows", "the file \"" + table.file + "\" was not read", ""},
                         {"contact.friction"}});
        return;
    }
    for (std::size_t k = 0; k < table.speeds.size(); ++k)
        if (table.coefficients[k] > contact.static_friction) {
            found.push_back(
                {"contact.friction_table",
                 {"row " + std::to_string(k + 1) + " of contact.friction_table, " + shortest(table.coefficients[k]) +
                      ", exceeds mu_s = " + shortest(contact.static_friction),
                  "a slip may not rub more than what ends a stick", "Raise static_friction."},
                 {"contact.static_friction"}});
            return;
        }
    if (const double fastest = fastest_surface(at.c.drive); fastest > table.speeds.back())
        found.push_back({"contact.friction_table",
                         {"contact.friction_table ends at " + shortest(table.speeds.back()) + " m/s",
                          "the surface alone moves with " + shortest(fastest) + " m/s, and nothing is known there",
                          "Measure up to there, or move it more slowly."},
                         {"drive.kind", "drive.velocity", "drive.amplitude", "drive.frequency", "drive.file"}});
}

// bristles that bear nothing bend without end
void check_bristles(CaseView at, std::vector<Finding>& found) {
    if (!has_bristles(at) || at.own().contact.kinetic_friction > 0.0) return;
    found.push_back({"contact.kinetic_friction",
                     {"contact.kinetic_friction = 0 beside friction = \"lugre\"",
                      "bristles that bear nothing have no bend", "Give it some friction."},
                     {"contact.friction"}});
}

// what a pair depends on lies within its rows
void check_pair(CaseView at, std::vector<Finding>& found) {
    const MaterialPair& pair = at.own().contact.pair;
    if (pair.source.empty()) return;
    if (pair.static_friction.empty()) {
        found.push_back({"contact.pair",
                         {"contact.pair has no coefficients", "\"" + pair.source + "\" was not read", ""},
                         {"contact.pair"}});
        return;
    }
    for (const PairColumn& column : pair_coefficients()) {
        const Field& field = *find_field(column.field);
        const std::string key(column.field);
        const bool is_of_law = column.field != "contact.static_friction" && column.field != "contact.kinetic_friction";
        if ((pair.*column.values).empty()) continue;
        if (temperature_column(at, field) != nullptr)
            found.push_back({"contact.pair",
                             {key + " follows both contact.pair and [temperature]", "it has one value",
                              "Take it out of one of the two."},
                             {"temperature.value"}});
        if (is_of_law && !field.belongs(at))
            found.push_back({"contact.pair",
                             {"contact.pair has " + std::string(column.name) + ", which means nothing for this case",
                              "it belongs to " + home_of(at, field), "Change the law, or take it out of the rows."},
                             {"contact.friction", "contact.rest"}});
    }
    if (!pair.load.empty() && !is_preloaded(at.c))
        found.push_back(
            {"contact.pair",
             {"contact.pair depends on the load, and this case has none",
              "the load is contact.preload; here others press the contacts", "Give the coefficients instead."},
             {"contact.preload"}});
    for (const std::string_view key : {"temperature.value", "contact.humidity", "contact.preload"}) {
        const Field& field = *find_field(key);
        if (pair_nodes(pair, field).empty() || !field.belongs(at)) continue;
        try {
            expect_in_range(at, field, get_quantity(at, field));
        } catch (const Error& error) {
            found.push_back({std::string(key), error.problem(), {"contact.pair"}});
        }
    }
}

// numbers of a law that this case does not have
void check_temperature(CaseView at, std::vector<Finding>& found) {
    for (const std::string_view key :
         {"contact.friction_slope", "contact.stribeck_velocity", "contact.viscous_friction"}) {
        const Field& field = *find_field(key);
        if (temperature_column(at, field) == nullptr || field.belongs(at)) continue;
        found.push_back({std::string(key),
                         {std::string(key) + " follows the temperature, and means nothing for this case",
                          "it belongs to " + home_of(at, field), "Take it out of [temperature], or change the law."},
                         {"contact.friction"}});
    }
}

// where all contacts say one of them themselves, the case's own says nothing
void check_contact(CaseView at, std::vector<Finding>& found) {
    for (const FrictionKeys& keys : friction_keys)
        if (find_field(keys.kinetic)->belongs(at) && find_field(keys.limit)->belongs(at))
            check_friction(at, keys, found);
}

// coefficients that a contact has itself stand in for those of the case
void check_own_friction(const Case& c, std::vector<Finding>& found) {
    for (std::size_t k = 0; k < contact_count(c); ++k) {
        const OwnContact& own = c.own_structure->contacts[k];
        if (!own.static_friction && !own.kinetic_friction) continue;
        const Contact laws = contact_of(c, k);
        if (has_friction_table(c) || has_no_stick(c) || has_rate_and_state(c))
            found.push_back({"contact.friction",
                             {"contact \"" + own.name + "\" has friction coefficients of its own",
                              "a table, or friction without a stick, is that of all contacts",
                              "Take them out, or use \"coulomb\"."}});
        else if (c.contact().friction == FrictionKind::directional)
            found.push_back({"contact.friction",
                             {"contact \"" + own.name + "\" has friction coefficients of its own",
                              "other ones each way are those of all contacts", "Take them out, or use \"coulomb\"."}});
        else if (laws.kinetic_friction > laws.static_friction)
            found.push_back({"contact.kinetic_friction",
                             {"contact \"" + own.name + "\" has mu_d = " + shortest(laws.kinetic_friction) +
                                  " above mu_s = " + shortest(laws.static_friction),
                              "kinetic friction may not be larger than static", "Swap them?"}});
    }
}

bool is_same(const Finding& a, const Finding& b) {
    return a.key == b.key && a.problem.what == b.problem.what;
}

// what the engine of a case cannot solve, by the table of engines; two methods may refuse in the same words
void find_unsolvable(CaseView at, std::vector<Finding>& found) {
    std::vector<Finding> refused;
    const std::string_view engine = engine_names[static_cast<std::size_t>(engine_of(at.c))];
    for (const Method method : methods_of(at.c))
        for (const Asked& asked : demands_of(at)) {
            const std::optional<base::Problem> problem = refusal(method, asked, engine);
            if (!problem) continue;
            const DemandKeys keys = keys_of(asked.demand);
            Finding finding{std::string(keys.key), *problem, keys.others};
            if (std::none_of(refused.begin(), refused.end(),
                             [&](const Finding& other) { return is_same(other, finding); }))
                refused.push_back(std::move(finding));
        }
    found.insert(found.end(), refused.begin(), refused.end());
}

void check_own_structure(const Case& c, std::vector<Finding>& found) {
    check_own_friction(c, found);
    if (const std::optional<std::size_t> row = massless_row(*c.own_structure);
        row && c.run.initial != Initial::rest && c.run.initial != Initial::given)
        found.push_back({"run.initial",
                         {"row " + c.own_structure->row[*row] + " has no mass, and no velocity at the start", "",
                          "Start with \"rest\"."}});
    if (c.run.initial == Initial::sliding)
        found.push_back({"run.initial",
                         {"a structure of one's own does not start sliding",
                          "it may have no steady sliding, or several", "Start with \"rest\" or \"stuck\"."}});
}

// V is linear between samples: it is zero from one to the next if it is so at both
void find_standstill(const Case& c, std::vector<Finding>& found) {
    long reversals = 0;
    bool moves = false;
    double last = 0.0;
    for (std::size_t k = 0; k < c.drive.times.size(); ++k) {
        const double velocity = c.drive.velocities[k];
        moves = moves || (velocity != 0.0 && (k == 0 || c.drive.times[k - 1] < c.run.duration));
        if (velocity == 0.0) continue;
        if (last != 0.0 && (velocity > 0.0) != (last > 0.0)) ++reversals;
        last = velocity;
    }
    if (!moves)
        found.push_back({"drive.file",
                         {"the sampled drive stands still for the whole run", "a contact at rest has nothing to judge",
                          "Check its column velocity."}});
    if (static_cast<double>(reversals) > most_reversals)
        found.push_back({"drive.file",
                         {"the sampled drive reverses " + std::to_string(reversals) + " times",
                          "each reversal is kept in memory, " + shortest(most_reversals) + " at most",
                          "Is its velocity noise? Smooth it, or shorten run.duration."}});
}

void check_samples(const Case& c, std::vector<Finding>& found) {
    const std::vector<double>& times = c.drive.times;
    if (times.size() < 2 || c.drive.velocities.size() != times.size()) {
        found.push_back({"drive.file",
                         {"the sampled drive has " + std::to_string(times.size()) + " samples",
                          "a velocity over time needs two at least", "Check the CSV file."}});
        return;
    }
    for (std::size_t k = 1; k < times.size(); ++k)
        if (!(times[k] > times[k - 1])) {
            found.push_back(
                {"drive.file",
                 {"the sampled times do not increase at sample " + std::to_string(k + 1),
                  shortest(times[k]) + " s follows " + shortest(times[k - 1]) + " s", "Sort the CSV file by time."}});
            return;
        }
    const auto fast = std::find_if(c.drive.velocities.begin(), c.drive.velocities.end(),
                                   [](double velocity) { return !(std::abs(velocity) <= fastest_sample); });
    if (fast != c.drive.velocities.end())
        found.push_back({"drive.file",
                         {"sample " + std::to_string(fast - c.drive.velocities.begin() + 1) +
                              " of the sampled drive is " + shortest(*fast) + " m/s",
                          "no surface moves faster than " + shortest(fastest_sample) + " m/s",
                          "Is it an overload, or a mark for no value?"}});
    if (static_cast<double>(times.size()) > most_samples)
        found.push_back({"drive.file",
                         {"the sampled drive has " + std::to_string(times.size()) + " samples",
                          "all of them are kept in memory, " + shortest(most_samples) + " at most",
                          "Resample it: V is linear in between."}});
    if (times.front() > 0.0)
        found.push_back(
            {"drive.file",
             {"the sampled drive starts at " + shortest(times.front()) + " s", "the simulation starts at 0 s", ""}});
    if (times.back() < c.run.duration)
        found.push_back({"run.duration",
                         {"run.duration = " + shortest(c.run.duration) + " s runs past the sampled drive",
                          "it ends at " + shortest(times.back()) + " s", "Shorten run.duration."}});
    find_standstill(c, found);
}

// with this share of the run, or less, a ramp is a jump: double precision does not tell its ends apart
constexpr double least_ramp = 1e-9;

void check_ramp(const Case& c, std::vector<Finding>& found) {
    const Field& field = *find_field("drive.ramp");
    if (!field.belongs(c)) return;
    const double longest = 0.25 / c.drive.frequency;
    if (!is_by_force(c.drive) && c.drive.ramp > longest * (1.0 + 1e-9))
        found.push_back({"drive.ramp",
                         {"drive.ramp = " + shortest(c.drive.ramp) + " s is longer than a quarter of the period",
                          "half a period has two ramps, one to full velocity and one back",
                          "Make it at most " + shortest(longest) + " s."},
                         {"drive.kind", "drive.frequency"}});
    if (c.drive.ramp < least_ramp * c.run.duration)
        found.push_back({"drive.ramp",
                         {"drive.ramp = " + shortest(c.drive.ramp) + " s is less than 1e-9 of run.duration",
                          "double precision cannot tell its ends apart", "Lengthen it."},
                         {"drive.kind", "run.duration"}});
}

// a value that no range refuses, because an axis may run through it
void check_zeros(CaseView at, std::vector<Finding>& found) {
    for (const Field& field : fields()) {
        const auto* quantity = std::get_if<Quantity>(&field.kind);
        if (quantity == nullptr || quantity->range.zero == Range::Zero::allowed || !field.belongs(at)) continue;
        if (quantity->get(at) == 0.0)
            found.push_back({key_of(field),
                             {key_of(field) + " = 0 is out of range", "it must not be 0", ""},
                             {field.section}});  // it stands by itself
    }
}

void check_force(const Case& c, std::vector<Finding>& found) {
    if (!is_by_force(c.drive)) return;
    if (!c.own_structure || c.own_structure->force.empty())
        found.push_back({"drive.kind",
                         {"a drive by force has nothing that it shakes",
                          "structure.force says how much of it acts on each row of a structure of one's own",
                          "Add structure.force, or let the surface move."}});
}

void check_drive(const Case& c, std::vector<Finding>& found) {
    check_force(c, found);
    if (is_of_file(c.drive)) check_samples(c, found);
    check_ramp(c, found);
    // a window of one and a half periods holds a complete going and a complete coming phase wherever it starts
    const double rate = repetition_rate(c.drive);
    const double shortest_window = rate > 0.0 ? 1.5 / rate : 0.0;
    const bool is_short = c.run.window < shortest_window * (1.0 - 1e-9);
    if (is_short)
        found.push_back(
            {"run.window",
             {"run.window = " + shortest(c.run.window) + " s is shorter than one and a half periods of the drive",
              "it may hold no complete going or coming phase",
              "Give run.window and run.duration at least " + shortest(shortest_window) + " s."},
             {"run.duration", "drive.kind", "drive.frequency"}});
}

bool starts_still(const VelocityProfile& profile) {
    return !profile.velocities.empty() && profile.velocities.front() == 0.0;
}

void check_run(const Case& c, std::vector<Finding>& found) {
    if (c.run.initial == Initial::sliding && starts_still(velocity_profile(drive_of_run(c))))
        found.push_back({"run.initial",
                         {"run.initial = \"sliding\" has no direction", "the drive stands still at the start",
                          "Start with \"rest\"."}});
    if (c.run.window > c.run.duration)
        found.push_back({"run.window",
                         {"run.window = " + shortest(c.run.window) +
                              " s is longer than run.duration = " + shortest(c.run.duration) + " s",
                          "the window is the last part of the simulated time", "Make it at most the duration."},
                         {"run.duration"}});
    if (engine_of(c) == Engine::exact) return;
    if (c.run.step > c.run.duration)
        found.push_back(
            {"run.step",
             {"run.step = " + shortest(c.run.step) + " s is longer than run.duration", "", "Use about 1 us."},
             {"run.duration", "run.engine"}});
    if (c.run.duration / c.run.step > 1e12)
        found.push_back(
            {"run.step",
             {"run.duration / run.step asks for more than 1e12 steps", "that would take hours", "Use a larger step."},
             {"run.duration", "run.engine"}});
    // of a phase the part between settling and reversal is judged
    const double rate = repetition_rate(c.drive);
    const double judged = rate > 0.0 ? 0.5 / rate * (1.0 - c.verdict.settling - c.verdict.reversal) : c.run.window;
    if (c.run.step <= c.run.duration && judged < least_steps * c.run.step)
        found.push_back({"run.step",
                         {"run.step = " + shortest(c.run.step) + " s leaves fewer than ten steps in a judged time of " +
                              shortest(std::max(0.0, judged)) + " s",
                          "its figures would come from next to nothing", "Use a smaller step."}});
}

void check_verdict(const Case& c, std::vector<Finding>& found) {
    if (has_one_phase(c.drive) || c.verdict.settling + c.verdict.reversal <= most_cut) return;
    found.push_back({"verdict.settling",
                     {"verdict.settling + verdict.reversal = " + shortest(c.verdict.settling + c.verdict.reversal) +
                          " leaves nothing to judge",
                      "together they cut the whole phase", "Make their sum less than 1."},
                     {"verdict.reversal", "drive.kind"}});
}

}  // namespace

std::vector<Finding> findings(const Case& c) {
    std::vector<Finding> found;
    for (std::size_t joint = 0; joint < c.joints.size(); ++joint)
        for (Finding& finding : findings_at({c, joint}))
            found.push_back(std::move(finding));
    return found;
}

std::vector<Finding> findings_at(CaseView at) {
    const Case& c = at.c;
    std::vector<Finding> found;
    check_zeros(at, found);
    if (c.own_structure) check_own_structure(c, found);
    find_unsolvable(at, found);
    check_contact(at, found);
    check_friction_table(at, found);
    check_axial_force(at, found);
    check_bristles(at, found);
    check_pair(at, found);
    check_temperature(at, found);
    check_drive(c, found);
    check_run(c, found);
    check_start(at, found);
    check_verdict(c, found);
    find_unresolvable(at, found);
    return found;
}

}  // namespace stridor::parameters
