#include "stridor/sweep/ready_charts.hpp"

#include "stridor/base/check.hpp"
#include "stridor/parameters/fields/usual_range.hpp"

#include <optional>

namespace stridor::sweep {

namespace {

parameters::Case constant_drive() {
    parameters::Case c;
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = 0.1;
    c.run.duration = 1.0;
    c.run.window = 0.5;
    c.run.step = 1e-6;
    return c;
}

using parameters::Case;
using parameters::Contact;
using parameters::Joint;
using parameters::Plate;

constexpr int soft_columns = 20;
constexpr int soft_rows = 14;

// judged by its second half, as the paper's planes are
Case at_constant_velocity(double velocity, double duration) {
    Case c;
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = velocity;
    c.run.duration = duration;
    c.run.window = 0.5 * duration;
    return c;
}

Study soft_plane(Case base, Axis x, Axis y) {
    Study study;
    study.base = std::move(base);
    study.x = std::move(x);
    study.y = std::move(y);
    return study;
}

Axis rising_by_factors(std::string_view parameter, double from, double to) {
    return {std::string(parameter), from, to, soft_columns, Scale::logarithmic};
}

Axis rising_evenly(std::string_view parameter, double from, double to) {
    return {std::string(parameter), from, to, soft_rows, Scale::linear};
}

// 50 mm of a lip, which bends 16 times as easily as it is compressed, on a door's outer panel
void make_lip(Case& c) {
    c.joint() = Joint{4e-3, 2.5e4, 1.5e3, 1.5, 0.4, 60.0};
    c.plate = Plate{0.35, 4e5, 5.0};
}

Study weatherstrip() {
    Case c = at_constant_velocity(0.05, 1.0);
    c.title = "weatherstrip: a seal's lip on paint";
    make_lip(c);
    c.contact() = Contact{.preload = 8.0, .static_friction = 1.2, .kinetic_friction = 0.9};
    return soft_plane(c, rising_by_factors("contact.preload", 1.0, 40.0),
                      rising_evenly("contact.kinetic_friction", 0.2, 1.2));
}

// two seconds: twelve strokes each way are judged after twelve in which the lip may creep to where it sticks for ever
Study weatherstrip_shaken() {
    Case c;
    c.title = "weatherstrip, shaken: a coated lip under the small motions of a body that twists";
    c.drive.amplitude = 5e-4;
    c.drive.frequency = 12.0;
    c.run.duration = 2.0;
    make_lip(c);
    c.contact() = Contact{.preload = 0.42, .static_friction = 0.7, .kinetic_friction = 0.6};
    return soft_plane(c, rising_by_factors("contact.preload", 0.1, 2.0),
                      rising_evenly("contact.kinetic_friction", 0.1, 0.7));
}

// a guiding lip on a side window that is held by its seals at 82 Hz
Study glass_run() {
    Case c = at_constant_velocity(0.12, 2.0);
    c.title = "glass run: a guiding lip on a side window";
    c.joint() = Joint{3e-3, 4e4, 4e3, 1.0, 0.5, 50.0};
    c.plate = Plate{1.5, 4e5, 30.0};
    c.contact() = Contact{.preload = 10.0, .static_friction = 1.0, .kinetic_friction = 0.4};
    return soft_plane(c, rising_by_factors("drive.velocity", 5e-3, 0.3),
                      rising_evenly("contact.static_friction", 0.4, 1.4));
}

// a leg of a clip in a sheet, at the velocity and around the forces of VDA 230-206
Study clip() {
    Case c = at_constant_velocity(4e-3, 2.0);
    c.title = "clip: a plastic retainer in its hole";
    c.joint() = Joint{5e-3, 2.5e5, 6e4, 2.0, 1.0, 65.0};
    c.plate = Plate{0.25, 3e5, 8.0};
    c.contact() = Contact{.preload = 20.0, .static_friction = 0.5, .kinetic_friction = 0.3};
    return soft_plane(c, rising_by_factors("contact.preload", 2.0, 80.0),
                      rising_evenly("contact.kinetic_friction", 0.1, 0.5));
}

// 0.6 m of a lip; across the glass it is carried by its arm, at 76 Hz
Study wiper() {
    Case c = at_constant_velocity(0.8, 1.0);
    c.title = "wiper: a blade's lip on glass";
    c.joint() = Joint{6e-3, 2.4e5, 1.2e4, 1.5, 1.2, 75.0};
    c.plate = Plate{0.35, 8e4, 10.0};
    c.contact() = Contact{.preload = 10.0, .static_friction = 1.3, .kinetic_friction = 0.8};
    return soft_plane(c, rising_by_factors("drive.velocity", 0.05, 1.5),
                      rising_evenly("contact.kinetic_friction", 0.1, 1.3));
}

// the pad moves along the disc with its caliper, on the suspension, at 80 Hz
Study brake_pad() {
    Case c = at_constant_velocity(0.02, 3.0);
    c.title = "brake pad: pad and caliper on a disc that creeps";
    c.joint() = Joint{4.0, 3.2e7, 1e6, 400.0, 60.0, 86.0};
    c.plate = Plate{6.0, 2.4e8, 600.0};
    c.contact() = Contact{.preload = 1000.0, .static_friction = 0.5, .kinetic_friction = 0.4};
    return soft_plane(c, rising_by_factors("drive.velocity", 2e-3, 0.3),
                      rising_evenly("contact.kinetic_friction", 0.2, 0.5));
}

}  // namespace

Study figure_8() {
    Study study;
    study.base = constant_drive();
    study.base.title = "noise charts over preload and kinetic friction (Figure 8)";
    study.x = {"contact.preload", 2.0, 4000.0, 40, Scale::logarithmic};
    study.y = {"contact.kinetic_friction", 0.0, 0.8, 40, Scale::linear};
    return study;
}

Study figure_6(double incidence_angle) {
    Study study;
    study.base = constant_drive();
    study.base.title = "contact-state rates over velocity and preload (Figure 6)";
    study.base.joint().incidence_angle = incidence_angle;
    study.x = {"drive.velocity", 0.01, 1.0, 30, Scale::logarithmic};
    study.y = {"contact.preload", 2.0, 4000.0, 30, Scale::logarithmic};
    study.directions = {parameters::Direction::going};
    study.quantities = {"slip", "stick", "separation"};
    return study;
}

Study soft_part(SoftPart part) {
    switch (part) {
        case SoftPart::weatherstrip:
            return weatherstrip();
        case SoftPart::weatherstrip_shaken:
            return weatherstrip_shaken();
        case SoftPart::glass_run:
            return glass_run();
        case SoftPart::clip:
            return clip();
        case SoftPart::wiper:
            return wiper();
        case SoftPart::brake_pad:
            break;
    }
    return brake_pad();
}

std::vector<ReadyChart> ready_charts() {
    constexpr double paper_angle = 70.0;  // [deg]
    std::vector<ReadyChart> charts{{"noise-chart", PlaneSet::paper, figure_8()},
                                   {"rate-map", PlaneSet::paper, figure_6(paper_angle)}};
    for (std::size_t k = 0; k < soft_part_names.size(); ++k)
        charts.push_back({std::string(soft_part_names[k].name), PlaneSet::soft, soft_part(static_cast<SoftPart>(k))});
    return charts;
}

Axis usual_axis(const parameters::Case& c, std::string_view key, int points) {
    const std::optional<parameters::UsualRange> range = parameters::usual_range(c, key);
    STRIDOR_EXPECT(range.has_value());
    Axis axis{std::string(key), range->from, range->to, points, range->scale};
    if (key == "contact.kinetic_friction") axis.to = c.contact().static_friction;
    if (axis.to < 0.0) axis = {axis.parameter, -axis.to, -axis.from, points, axis.scale};
    return axis;
}

std::pair<Axis, Axis> usual_axes(const parameters::Case& c, int points) {
    constexpr std::array<std::string_view, 7> wanted{
        "contact.preload", "structure.stiffness_scale", "contact.kinetic_friction", "temperature.value",
        "drive.velocity",  "structure.damping_scale",   "joint.incidence_angle"};
    std::vector<Axis> axes;
    for (const std::string_view key : wanted) {
        const bool is_taken = key == "structure.stiffness_scale" && !axes.empty();
        const bool has_width = key != "contact.kinetic_friction" || c.contact().static_friction > 0.0;
        if (axes.size() < 2 && !is_taken && has_width && parameters::usual_range(c, key))
            axes.push_back(usual_axis(c, key, points));
    }
    // a joint has a preload and an angle, an own structure both scales or a preload in place of one
    return {axes[0], axes[1]};
}

}  // namespace stridor::sweep
