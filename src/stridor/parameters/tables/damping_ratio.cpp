#include "stridor/parameters/tables/damping_ratio.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"

#include <cmath>
#include <utility>

namespace stridor::parameters {

namespace {

constexpr std::string_view ratio_words = "damping ratio ";
constexpr std::string_view loss_words = "loss factor ";

double damping(double ratio, double stiffness, double mass) {
    return 2.0 * ratio * std::sqrt(stiffness * mass);
}

}  // namespace

std::optional<double> parse_damping_ratio(std::string_view text) {
    text = base::trimmed(text);
    if (text.starts_with(ratio_words)) return base::parse_quantity(text.substr(ratio_words.size()), "1");
    if (text.starts_with(loss_words)) return 0.5 * base::parse_quantity(text.substr(loss_words.size()), "1");
    if (text.ends_with('%')) return base::parse_quantity(text, "1");
    return std::nullopt;
}

std::string damping_ratio_text(double ratio) {
    return std::string(ratio_words) + base::shortest(ratio);
}

const std::optional<double>* damping_ratio_of(CaseView at, std::string_view key) {
    if (key == "joint.axial_damping") return &at.own().axial_ratio;
    if (key == "joint.flexural_damping") return &at.own().flexural_ratio;
    if (key == "plate.damping") return &at.c.plate_damping_ratio;
    return nullptr;
}

std::optional<double>* damping_ratio_of(CaseToSet at, std::string_view key) {
    return const_cast<std::optional<double>*>(damping_ratio_of(CaseView(at), key));  // of a case that may change
}

void keep_damping_ratios(Case& c) {
    for (PlateJoint& each : c.joints) {
        Joint& joint = each.joint;
        if (each.axial_ratio) joint.axial_damping = damping(*each.axial_ratio, joint.axial_stiffness, joint.mass);
        if (each.flexural_ratio)
            joint.flexural_damping = damping(*each.flexural_ratio, joint.flexural_stiffness, joint.mass);
    }
    if (c.plate_damping_ratio) c.plate.damping = damping(*c.plate_damping_ratio, c.plate.stiffness, c.plate.mass);
}

}  // namespace stridor::parameters
