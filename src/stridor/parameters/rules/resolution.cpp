// What a double, 53 bits or eps = 1.1e-16, can hold of a case.
//
// Magnitudes. Rates are sqrt(k/m), energies F²/k, norms of the equations (k/m)²: products of at most four numbers of a
// case. They stay within 2.2e-308..1.8e308 if each number stays within 1e-75..1e75.
//
// Time. An instant is known to eps T, T the duration; a step of the exact engine is 2/Omega, Omega the fastest rate.
// The instant is known to eps T Omega/2 of a step: 6e-5 where Omega T = 1e12. That many steps also take hours.
//
// Ratios. Stiffnesses along and across the joint are added up into one matrix, masses into one total: the smaller
// summand is known to eps times the ratio, 1e-4 where that is 1e12. A normal force is known to eps F, a friction force
// mu N to eps mu F.

#include "stridor/parameters/rules/resolution.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/fields/friction_keys.hpp"
#include "stridor/parameters/rules/engines.hpp"
#include "stridor/parameters/system.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <string_view>

namespace stridor::parameters {

namespace {

using base::shortest;

constexpr double smallest_number = 1e-75;

struct Named {
    std::string_view key;
    double value = 0.0;
};

Named largest_of(std::initializer_list<Named> all) {
    return std::max(all, [](const Named& a, const Named& b) { return a.value < b.value; });
}

Named smallest_of(std::initializer_list<Named> all) {
    return std::min(all, [](const Named& a, const Named& b) { return a.value < b.value; });
}

std::string setting(CaseView at, std::string_view key) {
    return std::string(key) + " = " + value_text(at, *find_field(key));
}

void find_large_and_small(CaseView at, std::vector<Finding>& found) {
    for (const Field& field : fields()) {
        const auto* quantity = std::get_if<Quantity>(&field.kind);
        if (quantity == nullptr || !field.belongs(at)) continue;
        const double size = std::abs(quantity->get(at));
        const bool has_dimension = quantity->unit != "1" && quantity->unit != "deg";
        const bool is_small = has_dimension && size > 0.0 && size < smallest_number;
        if (size <= largest_number && !is_small) continue;
        found.push_back({key_of(field),
                         {setting(at, key_of(field)) + " is " + (is_small ? "below 1e-75" : "above 1e75"),
                          "products of such numbers leave double precision", "Check its unit."}});
    }
}

// an upper bound of the fastest rate of the motion [1/s], and the field that makes it; friction adds mu_d times the
// forces across the contact to those along it
Named fastest_rate(CaseView at, double friction) {
    const Case& c = at.c;
    const Joint& joint = at.own().joint;
    const auto vibration = [&](double stiffness, double mass) {
        return std::sqrt((1.0 + friction) * stiffness / mass);
    };
    const auto decay = [&](double damping, double mass) { return (1.0 + friction) * damping / mass; };
    return largest_of({{"joint.axial_stiffness", vibration(joint.axial_stiffness, joint.mass)},
                       {"joint.flexural_stiffness", vibration(joint.flexural_stiffness, joint.mass)},
                       {"plate.stiffness", vibration(c.plate.stiffness, c.plate.mass)},
                       {"joint.axial_damping", decay(joint.axial_damping, joint.mass)},
                       {"joint.flexural_damping", decay(joint.flexural_damping, joint.mass)},
                       {"plate.damping", decay(c.plate.damping, c.plate.mass)},
                       {"drive.frequency", base::two_pi * repetition_rate(c.drive)}});
}

void find_fast(CaseView at, std::vector<Finding>& found) {
    const Case& c = at.c;
    if (engine_of(c) != Engine::exact) return;  // the others have their step
    Named friction{friction_keys.front().kinetic};
    for (const FrictionKeys& keys : friction_keys) {
        const Field& field = *find_field(keys.kinetic);
        if (field.belongs(at) && get_quantity(at, field) > friction.value)
            friction = {keys.kinetic, get_quantity(at, field)};
    }
    const double rate = fastest_rate(at, friction.value).value;
    if (rate * c.run.duration <= most_apart) return;
    const Named frictionless = fastest_rate(at, 0.0);
    const bool is_long = rate <= most_apart;  // a second would do
    const bool is_rough = frictionless.value * c.run.duration <= most_apart;
    const std::string_view key = is_long ? "run.duration" : is_rough ? friction.key : frictionless.key;
    found.push_back({std::string(key),
                     {setting(at, key) + " makes a run of " + shortest(c.run.duration) + " s at rates of up to " +
                          shortest(rate) + " 1/s",
                      "beyond a product of 1e12 double precision cannot tell instants apart, and it would take hours",
                      is_long ? "Shorten it." : "Check its unit, or shorten run.duration."}});
}

void find_ratio(CaseView at, const Named& large, const Named& small, std::vector<Finding>& found) {
    if (large.value <= most_apart * small.value) return;
    found.push_back({std::string(large.key),
                     {setting(at, large.key) + " is more than 1e12 times " + setting(at, small.key),
                      "double precision leaves less than four digits of the smaller one beside it",
                      "A ratio of 1e6 is as good as rigid."}});
}

void find_reversals(const Case& c, std::vector<Finding>& found) {
    const double reversals = 2.0 * repetition_rate(c.drive) * c.run.duration;
    if (reversals <= most_reversals) return;
    found.push_back(
        {"drive.frequency",
         {setting(c, "drive.frequency") + " reverses " + shortest(std::ceil(reversals)) +
              " times in run.duration = " + shortest(c.run.duration) + " s",
          "each reversal is kept in memory, " + shortest(most_reversals) + " at most",
          "Shorten run.duration to at most " + shortest(0.5 * most_reversals / repetition_rate(c.drive)) + " s."}});
}

void find_short_window(const Case& c, std::vector<Finding>& found) {
    if (c.run.window * 1e9 >= c.run.duration) return;
    found.push_back(
        {"run.window",
         {setting(c, "run.window") + " is less than 1e-9 of run.duration = " + shortest(c.run.duration) + " s",
          "double precision cannot tell its ends apart well enough to judge it", "Lengthen it."}});
}

void find_in_joint(CaseView at, std::vector<Finding>& found) {
    const Case& c = at.c;
    const Joint& joint = at.own().joint;
    find_fast(at, found);
    const Named axial{"joint.axial_stiffness", joint.axial_stiffness};
    const Named flexural{"joint.flexural_stiffness", joint.flexural_stiffness};
    const Named plate{"plate.stiffness", c.plate.stiffness};
    find_ratio(at, largest_of({axial, flexural, plate}), smallest_of({axial, flexural, plate}), found);
    const Named joint_mass{"joint.mass", joint.mass};
    const Named plate_mass{"plate.mass", c.plate.mass};
    find_ratio(at, largest_of({joint_mass, plate_mass}), smallest_of({joint_mass, plate_mass}), found);
}

}  // namespace

void find_unresolvable(CaseView at, std::vector<Finding>& found) {
    const Case& c = at.c;
    const std::size_t before = found.size();
    find_large_and_small(at, found);
    if (found.size() > before) return;
    if (has_plate(c)) find_in_joint(at, found);
    for (const std::string_view key : {"contact.static_friction", "contact.static_friction_coming"}) {
        const Field& field = *find_field(key);
        if (!field.belongs(at) || get_quantity(at, field) <= most_apart) continue;
        found.push_back({std::string(key),
                         {setting(at, key) + " is above 1e12",
                          "the friction force would be known to less than four digits", "Rubber on glass has 2."}});
    }
    find_reversals(c, found);
    find_short_window(c, found);
}

}  // namespace stridor::parameters
