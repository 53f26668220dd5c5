#include "stridor/parameters/fields/contact_field.hpp"

#include "stridor/base/check.hpp"
#include "stridor/parameters/fields/field_ranges.hpp"

#include <algorithm>

namespace stridor::parameters {

namespace {

using Need = ContactField::Need;

constexpr std::array contact_table{
    ContactField{"name", "", "what results call it", &OwnContact::name},
    ContactField{"normal", "1", "the gap opens along it", &OwnContact::normal, any, Need::required},
    ContactField{"tangent", "1", "the direction of slip", &OwnContact::tangent, any, Need::required},
    ContactField{"second_tangent", "1", "the other direction of slip, at right angles to both",
                 &OwnContact::second_tangent},
    ContactField{"initial_gap", "m", "gap without load; negative: pressed together so far", &OwnContact::initial_gap},
    ContactField{"static_friction", "1", "its own mu_s", &OwnContact::static_friction, not_negative, Need::optional,
                 &Contact::static_friction},
    ContactField{"kinetic_friction", "1", "its own mu_d", &OwnContact::kinetic_friction, not_negative, Need::optional,
                 &Contact::kinetic_friction},
    ContactField{"drive_share", "1", "part of V that the surface has along the tangent", &OwnContact::drive_share},
    ContactField{"preload_share", "1", "part of contact.preload; the parts are taken over their sum",
                 &OwnContact::preload_share, not_negative},
    ContactField{"second_drive_share", "1", "part of V that the surface has along the second tangent",
                 &OwnContact::second_drive_share, any, Need::optional, nullptr, "second_tangent"},
    ContactField{"interface", "", "contacts of one name are judged as a whole", &OwnContact::interface},
    ContactField{"position", "m", "where it is, for drawings; it changes no result", &OwnContact::position},
    ContactField{"initial_rest", "s", "for which it has stuck at the start", &OwnContact::rested, not_negative,
                 Need::optional, &Contact::rested},
    ContactField{"initial_friction_state", "1", "friction state at the start: what bristles bear, or psi",
                 &OwnContact::initial_friction_state},
};

}  // namespace

std::span<const ContactField> contact_fields() {
    return contact_table;
}

const ContactField& contact_field(std::string_view key) {
    const auto found = std::find_if(contact_table.begin(), contact_table.end(),
                                    [&](const ContactField& field) { return field.key == key; });
    STRIDOR_EXPECT(found != contact_table.end());
    return *found;
}

bool is_shown(const ContactField& field) {
    return !std::holds_alternative<std::vector<double> OwnContact::*>(field.member) && field.only_beside.empty();
}

bool is_usual(const OwnContact& contact, const ContactField& field) {
    static const OwnContact usual;
    return std::visit([&](auto member) { return contact.*member == usual.*member; }, field.member);
}

namespace {

ContactValue value(const std::optional<double>& number) {
    return number ? ContactValue(*number) : ContactValue();
}

ContactValue value(const std::optional<std::array<double, 3>>& place) {
    return place ? ContactValue(std::vector<double>(place->begin(), place->end())) : ContactValue();
}

template <typename Other>
ContactValue value(const Other& other) {
    return other;
}

}  // namespace

ContactValue value_of(const OwnContact& contact, const ContactField& field) {
    return std::visit([&](auto member) { return value(contact.*member); }, field.member);
}

}  // namespace stridor::parameters
