#include "stridor/io/case/ready_structures.hpp"

#include "stridor/io/case/own_structure/toml_structure.hpp"

#include <array>
#include <string>

namespace stridor::io {

namespace {

using parameters::Case;

Case case_of_structure(const std::string& lines) {
    Case c;
    c.own_structure = read_own_structure(parse_toml({"[structure]\n" + lines, "ready structure", {}}));
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = 0.1;
    return c;
}

// m = k = N = 1, mu_s = 1, mu_d = 1/2: sticks for 10 s and slips for 2 (pi - atan 5) s
Case ready_chain() {
    Case c = case_of_structure(R"(builder = "chain"
blocks = 2
mass = 1
stiffness = 1
coupling = 1.2
)");
    c.title = "two blocks on a belt, tied to each other";
    c.contact().preload = 2.0;
    c.contact().static_friction = 1.0;
    c.contact().kinetic_friction = 0.5;
    c.run.duration = c.run.window = 200.0;
    return c;
}

// Helmholtz' motion: it sticks to the bow but for about the share `position` of each period. That share is one of the
// bow's place and no sign of a creak, so the case takes the word away
Case ready_string() {
    Case c = case_of_structure(R"(builder = "string"
frequency = 200
impedance = 0.35
length = 0.5
damping_ratio = 5e-4
position = 0.13
modes = 40
start = "helmholtz"
)");
    c.title = "bowed string: it sticks for most of each period and yet has a tone, hence creak_stick = 1";
    c.contact().preload = 0.8;
    c.contact().static_friction = 0.8;
    c.contact().kinetic_friction = 0.3;
    c.run.duration = 3.0;
    c.verdict.creak_stick = 1.0;
    return c;
}

constexpr std::array<ReadyStructure, 2> all_ready{{{"chain", ready_chain}, {"string", ready_string}}};

}  // namespace

std::span<const ReadyStructure> ready_structures() {
    return all_ready;
}

}  // namespace stridor::io
