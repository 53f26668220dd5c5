#include "stridor/parameters/fields/spring_field.hpp"

#include "stridor/base/check.hpp"
#include "stridor/parameters/fields/field_ranges.hpp"
#include "stridor/parameters/tables/force_table.hpp"

#include <algorithm>
#include <array>

namespace stridor::parameters {

namespace {

constexpr std::array spring_table{
    SpringField{"name", "", "what results call it", &OwnSpring::name},
    SpringField{"direction", "1", "its deflection is direction.u", &OwnSpring::direction},
    SpringField{"stiffness", "N/m", "linear part of its force, which joins the stiffness", &OwnSpring::stiffness,
                not_negative},
    SpringField{"cubic", "N/m^3", "k3: the force grows with the cube of the deflection; below 0 it softens",
                &OwnSpring::cubic},
    SpringField{"force", "N", "with a power of the deflection: the force at `deflection` beyond the gap",
                &OwnSpring::force, not_negative},
    SpringField{"deflection", "m", "beyond the gap, at which it pushes with `force`", &OwnSpring::deflection,
                not_negative},
    SpringField{"exponent", "1", "power of the deflection: 1.5 is Hertz' contact, 1 a linear stop",
                &OwnSpring::exponent, Range{1.0, 3.0}},
    SpringField{"gap", "m", "deflection at which it begins to push; negative: it pushes already", &OwnSpring::gap},
    SpringField{"table", "", "rows of deflection and force, \"0: 0, 1 mm: 2 N\", or their CSV file", &OwnSpring::table},
    SpringField{"interpolation", "", "between the rows: monotone cubic or linear", &OwnSpring::interpolation},
    SpringField{"preload_share", "1", "part of contact.preload that it bears at rest", &OwnSpring::preload_share,
                not_negative},
};

SpringValue spring_value(const ForceTable& table) {
    return force_table_text(table);
}

SpringValue spring_value(Interpolation interpolation) {
    return std::string(interpolation_names.at(static_cast<std::size_t>(interpolation)));
}

template <typename Other>
SpringValue spring_value(const Other& other) {
    return other;
}

}  // namespace

std::span<const SpringField> spring_fields() {
    return spring_table;
}

const SpringField& spring_field(std::string_view key) {
    const auto found = std::find_if(spring_table.begin(), spring_table.end(),
                                    [&](const SpringField& field) { return field.key == key; });
    STRIDOR_EXPECT(found != spring_table.end());
    return *found;
}

bool is_usual(const OwnSpring& spring, const SpringField& field) {
    static const OwnSpring usual;
    return std::visit([&](auto member) { return spring.*member == usual.*member; }, field.member);
}

SpringValue value_of(const OwnSpring& spring, const SpringField& field) {
    return std::visit([&](auto member) { return spring_value(spring.*member); }, field.member);
}

}  // namespace stridor::parameters
