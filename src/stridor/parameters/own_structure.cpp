#include "stridor/parameters/own_structure.hpp"

#include "stridor/base/hash.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/fields/contact_field.hpp"
#include "stridor/parameters/fields/spring_field.hpp"

#include <algorithm>
#include <utility>
#include <variant>

namespace stridor::parameters {

namespace {

void put(std::string& text, const std::vector<double>& numbers) {
    text += std::to_string(numbers.size()) + ":";
    for (const double number : numbers)
        text += base::shortest(number) + " ";
    text += "\n";
}

void put(std::string& text, const std::optional<double>& number) {
    text += (number ? base::shortest(*number) : "-") + "\n";
}

// a field that came later
template <typename Field, typename Value>
void put(std::string& text, const Field& field, const Value& value) {
    text += std::string(field.key) + "=";
    if (const auto* words = std::get_if<std::string>(&value)) text += *words + ";";
    if (const auto* number = std::get_if<double>(&value)) put(text, std::optional(*number));
    if (const auto* numbers = std::get_if<std::vector<double>>(&value)) put(text, *numbers);
}

}  // namespace

std::optional<std::size_t> massless_row(const OwnStructure& structure) {
    for (std::size_t row = 0; row < structure.row.size(); ++row)
        if (structure.mass[row * (structure.row.size() + 1)] == 0.0) return row;
    return std::nullopt;
}

const double* recipe_number(const Case& c, std::string_view key) {
    if (!c.own_structure || !c.own_structure->recipe) return nullptr;
    const auto& numbers = c.own_structure->recipe->numbers;
    const auto found = numbers.find(key);
    return found == numbers.end() ? nullptr : &found->second;
}

bool has_given_velocity(const OwnStructure& own) {
    return own.recipe && own.initial_velocity != own.recipe->build(*own.recipe).initial_velocity;
}

void rebuild(Case& c, std::string_view key, double value) {
    if (recipe_number(c, key) == nullptr) return;
    Recipe recipe = *c.own_structure->recipe;
    recipe.numbers.find(key)->second = value;
    OwnStructure anew = recipe.build(recipe);
    // what a case file adds to what is built
    anew.force = c.own_structure->force;
    anew.initial_displacement = c.own_structure->initial_displacement;
    if (has_given_velocity(*c.own_structure)) anew.initial_velocity = c.own_structure->initial_velocity;
    anew.outputs = c.own_structure->outputs;
    anew.springs = c.own_structure->springs;
    for (std::size_t k = 0; k < std::min(anew.contacts.size(), c.own_structure->contacts.size()); ++k)
        anew.contacts[k].rested = c.own_structure->contacts[k].rested;
    c.own_structure = std::make_shared<const OwnStructure>(std::move(anew));
}

std::string content_hash(const OwnStructure& structure) {
    std::string text;
    for (const auto& numbers : {structure.mass, structure.stiffness, structure.damping, structure.load,
                                structure.initial_displacement, structure.initial_velocity})
        put(text, numbers);
    if (!structure.force.empty()) put(text, structure.force);
    const FollowingDamping& following = structure.following;
    put(text, {following.ratio, following.loss_factor, following.rayleigh_mass, following.rayleigh_stiffness});
    if (structure.left_out_above > 0.0) put(text, std::optional(structure.left_out_above));
    for (const OwnContact& contact : structure.contacts) {
        put(text, contact.normal);
        put(text, contact.tangent);
        if (!contact.second_tangent.empty()) {
            put(text, contact.second_tangent);
            put(text, std::optional(contact.second_drive_share));
        }
        put(text, {contact.initial_gap, contact.preload_share, contact.drive_share});
        text += contact.interface + ";";
        put(text, contact.static_friction);
        put(text, contact.kinetic_friction);
        for (const ContactField& field : contact_fields().subspan(first_contact_fields))
            if (!is_usual(contact, field)) put(text, field, value_of(contact, field));
    }
    for (const OwnSpring& spring : structure.springs)
        for (const SpringField& field : spring_fields())
            if (field.key != "name" && !is_usual(spring, field)) put(text, field, value_of(spring, field));
    return base::hash_text(text);
}

std::vector<int> interface_numbers(const OwnStructure& structure) {
    std::vector<std::string_view> names;
    std::vector<int> numbers;
    for (const OwnContact& contact : structure.contacts) {
        const auto found = std::find(names.begin(), names.end(), contact.interface);
        numbers.push_back(static_cast<int>(found - names.begin()));
        if (found == names.end()) names.emplace_back(contact.interface);
    }
    return numbers;
}

std::vector<double> places_along_line(const OwnStructure& structure) {
    std::array<double, 3> least{}, most{};
    for (const OwnContact& contact : structure.contacts) {
        if (!contact.position) return {};
        const std::array<double, 3>& at = *contact.position;
        const bool is_first = &contact == structure.contacts.data();
        for (std::size_t axis = 0; axis < at.size(); ++axis) {
            least.at(axis) = is_first ? at.at(axis) : std::min(least.at(axis), at.at(axis));
            most.at(axis) = is_first ? at.at(axis) : std::max(most.at(axis), at.at(axis));
        }
    }
    std::size_t longest = 0;
    for (std::size_t axis = 1; axis < least.size(); ++axis)
        if (most.at(axis) - least.at(axis) > most.at(longest) - least.at(longest)) longest = axis;
    if (!(most.at(longest) > least.at(longest))) return {};
    std::vector<double> places;
    for (const OwnContact& contact : structure.contacts)
        places.push_back(contact.position->at(longest) - least.at(longest));
    return places;
}

bool has_given_structure(const Case& c) {
    return c.own_structure && !c.own_structure->recipe;
}

}  // namespace stridor::parameters
