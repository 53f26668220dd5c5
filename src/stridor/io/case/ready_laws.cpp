#include "stridor/io/case/ready_laws.hpp"

#include "stridor/io/case/own_structure/toml_structure.hpp"
#include "stridor/sweep/ready_charts.hpp"

#include <array>
#include <utility>

namespace stridor::io {

namespace {

constexpr std::string_view wiper_source =
    "Friction of rubber on wet glass falls with the slip velocity, from solid contact to a film of water:\n"
    "F. Deleau, D. Mazuyer, A. Koenen, Tribology International 42 (2009) 149. The exponential is that of\n"
    "J. Le Rouzic, A. Le Bot, J. Perret-Liaudet and others, Tribology Letters 49 (2013) 563, who have from\n"
    "it when a blade squeals. We read the abstracts, no table: 0.9, 0.2 and 0.1 m/s are estimates of wet\n"
    "rubber. Replace them by what you measured. The rest is `stridor init wiper`.";

constexpr std::string_view seal_source =
    "Friction that falls with the slip velocity marks the pairs of materials that make noise:\n"
    "N. S. Eiss, E. Lee, M. Trapp, SAE 972056 (1997). We found no open slope of rubber on paint: 0.9 and\n"
    "1.5 s/m are estimates. Replace them by what you measured. The lip is that of `stridor init weatherstrip`;\n"
    "it trails, since a leading one locks.";

constexpr std::string_view lip_source =
    "The lip of a seal stiffens as it is pressed, since ever more of it touches. We found no open table of one\n"
    "lip's force, nor of its mass: the rows of the table, the masses, the strip and its spring are judgement.\n"
    "Put in what you measured: a CSV of deflection and force, table = \"lip.csv\". Both coefficients of friction\n"
    "are alike, so that what squeals is the coupling of two modes: pressed lightly the lip is too soft for it,\n"
    "pressed hard too stiff.";

sweep::Study over_velocity_and_preload(sweep::Study study, sweep::Axis velocity, sweep::Axis preload) {
    study.x = std::move(velocity);
    study.y = std::move(preload);
    study.directions = {parameters::Direction::going};
    return study;
}

sweep::Study wet_wiper() {
    sweep::Study study = sweep::soft_part(sweep::SoftPart::wiper);
    study.base.title = "wiper on wet glass: friction falls with the slip velocity";
    study.base.drive.velocity = 0.05;
    parameters::Contact& contact = study.base.contact();
    contact.friction = parameters::FrictionKind::stribeck;
    contact.static_friction = 0.9;
    contact.kinetic_friction = 0.2;
    contact.stribeck_velocity = 0.1;
    return over_velocity_and_preload(std::move(study), {"drive.velocity", 0.02, 1.0, 20, sweep::Scale::logarithmic},
                                     {"contact.preload", 2.0, 40.0, 14, sweep::Scale::logarithmic});
}

sweep::Study falling_weatherstrip() {
    sweep::Study study = sweep::soft_part(sweep::SoftPart::weatherstrip);
    study.base.title = "weatherstrip that trails: friction falls with the slip velocity";
    study.base.drive.velocity = -0.05;
    parameters::Contact& contact = study.base.contact();
    contact.friction = parameters::FrictionKind::linear;
    contact.static_friction = 0.9;
    contact.kinetic_friction = 0.9;
    contact.friction_slope = 1.5;
    study = over_velocity_and_preload(std::move(study), {"drive.velocity", 5e-3, 0.5, 20, sweep::Scale::logarithmic},
                                      {"contact.preload", 1.0, 40.0, 14, sweep::Scale::logarithmic});
    study.directions = {parameters::Direction::coming};
    return study;
}

// 4 N/mm across the lip's axis, which stands at 52 degrees, and 0.5 N/mm along it beside the spring
sweep::Study stiffening_lip() {
    sweep::Study study;
    parameters::Case& c = study.base;
    c.own_structure = read_own_structure(parse_toml({R"([structure]
rows = ["x", "y", "strip"]
mass = [[0.005, 0, 0], [0, 0.005, 0], [0, 0, 0.037]]
stiffness = [[2670, -1700, 0], [-1700, 1830, 0], [0, 0, 23000]]
damping = [[0.17, 0, 0], [0, 0.17, 0], [0, 0, 0.6]]
[[structure.contact]]
name = "lip"
normal = "y -strip"
tangent = "x"
[[structure.spring]]
name = "lip"
direction = [0.6157, 0.788, 0]
table = "-1 mm: 0, 0: 0, 0.5 mm: 2, 1 mm: 5, 1.5 mm: 10, 2 mm: 18, 2.5 mm: 32, 3 mm: 60"
preload_share = 0.8
)",
                                                     "ready structure",
                                                     {}}));
    c.title = "lip of a seal on a strip of trim: it stiffens as it is pressed";
    c.contact().preload = 6.0;
    c.contact().static_friction = 0.82;
    c.contact().kinetic_friction = 0.82;
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = 0.1;
    c.run.duration = 2.0;
    c.run.window = 1.0;
    study.x = {"contact.preload", 1.0, 40.0, 20, sweep::Scale::logarithmic};
    study.y = {"structure.spring_scale", 0.5, 2.0, 14, sweep::Scale::logarithmic};
    study.directions = {parameters::Direction::going};
    return study;
}

constexpr std::array<ReadyLaw, 3> all_laws{{{"wiper-wet", wiper_source, wet_wiper},
                                            {"weatherstrip-falling", seal_source, falling_weatherstrip},
                                            {"seal-lip", lip_source, stiffening_lip}}};

}  // namespace

std::span<const ReadyLaw> ready_laws() {
    return all_laws;
}

}  // namespace stridor::io
