#include "stridor/sweep/paper_charts.hpp"

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
    study.base.joint.incidence_angle = incidence_angle;
    study.x = {"drive.velocity", 0.01, 1.0, 30, Scale::logarithmic};
    study.y = {"contact.preload", 2.0, 4000.0, 30, Scale::logarithmic};
    study.directions = {parameters::Direction::going};
    study.quantities = {"slip", "stick", "separation"};
    return study;
}

}  // namespace stridor::sweep
