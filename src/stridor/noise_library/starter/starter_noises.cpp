// The table of the starter library: a system each, with the joint, the plate and the drive it is made of, and below it
// a row per noise. Which of them are heard, and as what, is the program's to say.

#include "stridor/noise_library/starter/starter_noises.hpp"

#include "stridor/sweep/ready_charts.hpp"

#include <initializer_list>

namespace stridor::noise_library {

namespace {

using parameters::Case;
using parameters::Contact;
using parameters::Joint;
using parameters::Plate;

struct System {
    std::string_view name;
    std::string_view parts;
    std::string_view materials;
    Case base;  // joint, plate, drive and duration; each row has its own contact
};

/// What differs from noise to noise.
struct Row {
    double preload = 0.0;           // [N]
    double velocity = 0.0;          // [m/s] of a constant drive; of one to and fro the case's counts
    double static_friction = 0.0;   // [1]
    double kinetic_friction = 0.0;  // [1]
    double temperature = 23.0;      // [degC]
    double humidity = 50.0;         // [%]
    std::string_view operation;
};

using Noises = std::vector<StarterNoise>;

void add(Noises& noises, const System& system, std::initializer_list<Row> rows) {
    for (const Row& row : rows) {
        StarterNoise noise{system.name,     system.parts, system.materials, row.operation,
                           row.temperature, row.humidity, system.base};
        noise.c.title = std::string(system.name) + ": " + std::string(row.operation);
        noise.c.contact = Contact{
            .preload = row.preload, .static_friction = row.static_friction, .kinetic_friction = row.kinetic_friction};
        noise.c.drive.velocity = row.velocity;
        noises.push_back(std::move(noise));
    }
}

// a second half is judged, as of the soft parts; both are heard
Case sliding(const Joint& joint, const Plate& plate, double duration) {
    Case c;
    c.joint = joint;
    c.plate = plate;
    c.drive.kind = parameters::DriveKind::constant;
    c.run.duration = duration;
    c.run.window = 0.5 * duration;
    return c;
}

Case to_and_fro(const Joint& joint, const Plate& plate, double amplitude, double frequency) {
    Case c;
    c.joint = joint;
    c.plate = plate;
    c.drive.amplitude = amplitude;
    c.drive.frequency = frequency;
    c.run.duration = 2.0;
    c.run.window = 2.0;
    return c;
}

Case soft(sweep::SoftPart part) {
    return sweep::soft_part(part).base;
}

Case table_1_sliding(double duration) {
    return sliding(Joint{}, Plate{}, duration);
}

// --- around the doors and windows

void add_seals(Noises& noises) {
    // one seal under six preloads: a trend for `rig sensitivity`
    add(noises, {"seal", "door seal / painted door", "EPDM / paint", soft(sweep::SoftPart::weatherstrip)},
        {{1.0, -0.05, 0.9, 0.6, 23.0, 50.0, "door twists, lip hardly touches"},
         {2.0, -0.05, 0.9, 0.6, 23.0, 50.0, "door twists, lip touches"},
         {4.0, -0.05, 0.9, 0.6, 23.0, 50.0, "door twists, gap wide"},
         {8.0, -0.05, 0.9, 0.6, 23.0, 50.0, "door twists, gap as drawn"},
         {12.0, -0.05, 0.9, 0.6, 23.0, 50.0, "door twists, gap narrow"},
         {20.0, -0.05, 0.9, 0.6, 23.0, 50.0, "door twists, lip squeezed"}});
    // the drier the glass, the more it holds
    add(noises, {"wiper", "wiper blade / windscreen", "rubber / glass", soft(sweep::SoftPart::wiper)},
        {{10.0, 0.8, 1.3, 0.8, 20.0, 20.0, "glass nearly dry, outward"},
         {10.0, 0.8, 0.9, 0.5, 20.0, 60.0, "glass damp, outward"},
         {10.0, 0.8, 0.5, 0.3, 20.0, 95.0, "glass wet, outward"},
         {10.0, -0.8, 1.3, 0.8, 20.0, 20.0, "glass nearly dry, back"},
         {10.0, 0.1, 1.3, 0.8, 20.0, 20.0, "glass nearly dry, about to stop"}});
    add(noises, {"window lift", "glass run / side window", "EPDM / glass", soft(sweep::SoftPart::glass_run)},
        {{10.0, 0.12, 1.0, 0.4, 5.0, 80.0, "window up, cold and damp"},
         {10.0, -0.12, 0.8, 0.5, 23.0, 50.0, "window down"},
         {10.0, 0.12, 0.5, 0.35, 23.0, 50.0, "window up, flock as new"}});
    // Table 1's squeal; the last one with a friction coefficient as of a coating
    add(noises, {"sunroof", "sunroof seal / glass", "EPDM / glass", table_1_sliding(1.0)},
        {{20.0, 0.1, 0.8, 0.6, 23.0, 50.0, "closing"},
         {80.0, 0.1, 0.8, 0.6, 23.0, 50.0, "closing, seal swollen"},
         {20.0, 0.1, 0.8, 0.2, 23.0, 50.0, "closing, seal greased"}});
    add(noises,
        {"convertible top", "roof seal / frame", "EPDM / paint",
         sliding(Joint{8e-3, 3e4, 2e3, 1.0, 0.3, 50.0}, Plate{0.5, 1e5, 6.0}, 2.0)},
        {{5.0, -0.1, 1.0, 0.5, 23.0, 50.0, "opening"}, {5.0, 0.1, 1.0, 0.5, 23.0, 50.0, "closing, the lip digs in"}});
}

// --- what opens and shuts

void add_doors(Noises& noises) {
    add(noises, {"door hinge", "pin / bushing", "steel / steel", to_and_fro(Joint{}, Plate{}, 10e-3, 2.0)},
        {{100.0, 0.0, 0.8, 0.2, 23.0, 50.0, "door moved by hand"},
         {200.0, 0.0, 0.8, 0.2, -10.0, 30.0, "door moved by hand, frost"}});
    // Table 1's creak; with less preload it slips more often
    add(noises, {"latch", "latch / striker", "steel / polyamide", table_1_sliding(2.0)},
        {{2000.0, 0.01, 0.8, 0.2, 23.0, 50.0, "body twists, door pulled tight"},
         {1000.0, 0.01, 0.8, 0.2, 23.0, 50.0, "body twists"},
         {500.0, 0.05, 0.8, 0.2, 23.0, 50.0, "body twists quickly, door loose"}});
    add(noises,
        {"trunk lid", "hinge arm / bearing", "steel / bronze",
         to_and_fro(Joint{0.15, 6e6, 8e5, 2.0, 2.0, 68.0}, Plate{0.6, 8e5, 4.0}, 6e-3, 3.0)},
        {{150.0, 0.0, 0.8, 0.25, 23.0, 50.0, "lid rocked"},
         {60.0, 0.0, 0.8, 0.5, 5.0, 80.0, "lid rocked, grease lost"}});
    add(noises,
        {"glove box", "lid / frame", "ABS / ABS",
         sliding(Joint{12e-3, 2e5, 4e4, 1.5, 0.8, 70.0}, Plate{0.6, 1e5, 6.0}, 2.0)},
        {{8.0, 0.05, 0.45, 0.3, 23.0, 50.0, "lid opened"},
         {30.0, 0.01, 0.45, 0.3, 40.0, 30.0, "shut, on a rough road"}});
}

// --- the interior

void add_interior(Noises& noises) {
    add(noises,
        {"seat", "cover / backrest shell", "leather / polypropylene",
         sliding(Joint{20e-3, 4e4, 6e3, 3.0, 0.8, 55.0}, Plate{1.2, 2e5, 12.0}, 2.0)},
        {{80.0, -0.02, 0.8, 0.5, 23.0, 50.0, "driver leans back"},
         {40.0, -0.08, 0.9, 0.7, 35.0, 70.0, "driver turns, warm"}});
    add(noises,
        {"dashboard", "panel / support", "PC-ABS / ABS",
         sliding(Joint{8e-3, 4e5, 9e4, 2.0, 1.0, 60.0}, Plate{0.3, 4e5, 8.0}, 2.0)},
        {{15.0, 2e-3, 0.5, 0.25, 40.0, 20.0, "body twists slowly, sun on it"},
         {5.0, 0.02, 0.35, 0.3, 10.0, 50.0, "felt tape between, cool"}});
    add(noises, {"trim", "clip / sheet", "polyamide / steel", soft(sweep::SoftPart::clip)},
        {{5.0, 4e-3, 0.5, 0.3, 23.0, 50.0, "clip worn"},
         {20.0, 4e-3, 0.5, 0.3, 23.0, 50.0, "clip as new"},
         {60.0, 4e-3, 0.5, 0.3, 23.0, 50.0, "panel strained"}});
    add(noises,
        {"center console", "side panel / tunnel", "ABS / ABS",
         sliding(Joint{10e-3, 5e5, 1e5, 3.0, 1.5, 68.0}, Plate{0.4, 2e5, 8.0}, 2.0)},
        {{40.0, 1e-3, 0.45, 0.3, 23.0, 50.0, "knee leans on it"},
         {10.0, 0.04, 0.45, 0.35, 23.0, 50.0, "pushed by hand"}});
    add(noises,
        {"armrest", "cushion / frame", "foam cover / ABS",
         to_and_fro(Joint{6e-3, 6e4, 5e3, 1.0, 0.3, 60.0}, Plate{0.4, 3e5, 6.0}, 2e-3, 5.0)},
        {{0.5, 0.0, 0.8, 0.5, 23.0, 50.0, "elbow moves"},
         {3.0, 0.0, 0.5, 0.45, 23.0, 50.0, "elbow moves, cover waxed"}});
    add(noises,
        {"cup holder", "ring / bottle", "rubber / PET",
         sliding(Joint{3e-3, 1e5, 2e4, 0.5, 0.2, 55.0}, Plate{0.1, 1e5, 2.0}, 2.0)},
        {{3.0, 0.03, 0.6, 0.4, 23.0, 50.0, "bottle turned"}, {3.0, -0.03, 0.6, 0.4, 23.0, 50.0, "bottle turned back"}});
    add(noises,
        {"sun visor", "arm / socket", "polyamide / POM",
         sliding(Joint{6e-3, 8e4, 1e4, 0.6, 0.3, 62.0}, Plate{0.2, 5e4, 3.0}, 2.0)},
        {{12.0, 0.06, 0.7, 0.4, 40.0, 20.0, "folded down, hot"},
         {4.0, 0.06, 0.3, 0.25, 23.0, 50.0, "folded down, greased"}});
}

// --- what drives, stops and steers

void add_chassis(Noises& noises) {
    add(noises, {"brake", "pad / disc", "friction material / cast iron", soft(sweep::SoftPart::brake_pad)},
        {{1000.0, 0.02, 0.5, 0.4, 20.0, 60.0, "let go slowly on a hill"},
         {1000.0, 0.2, 0.5, 0.4, 20.0, 60.0, "rolling to a stop"},
         {1000.0, -0.02, 0.5, 0.4, 20.0, 60.0, "let go slowly, backwards"}});
    add(noises,
        {"clutch", "lining / flywheel", "friction material / cast iron",
         sliding(Joint{0.3, 3e7, 3e6, 5.0, 5.0, 70.0}, Plate{1.2, 3e6, 5.0}, 1.0)},
        {{400.0, 0.3, 0.5, 0.45, 120.0, 20.0, "engaging, hot"}, {400.0, 0.3, 0.35, 0.3, 40.0, 50.0, "engaging, cold"}});
    add(noises,
        {"belt", "belt / tensioner pulley", "EPDM / steel",
         sliding(Joint{0.05, 2e6, 3e5, 2.0, 2.0, 65.0}, Plate{0.3, 8e5, 4.0}, 1.0)},
        {{150.0, 0.5, 0.9, 0.7, 5.0, 90.0, "cold start, damp"}, {150.0, -0.5, 0.9, 0.7, 80.0, 40.0, "running warm"}});
    add(noises,
        {"pedal", "pedal arm / bush", "steel / polyamide",
         to_and_fro(Joint{0.2, 4e6, 5e5, 3.0, 3.0, 60.0}, Plate{0.5, 2e6, 5.0}, 20e-3, 1.0)},
        {{1200.0, 0.0, 0.6, 0.2, 23.0, 50.0, "pressed and let go, dry"},
         {60.0, 0.0, 0.25, 0.2, 23.0, 50.0, "greased"}});
    add(noises,
        {"suspension", "control arm bushing / sleeve", "natural rubber / steel",
         sliding(Joint{0.1, 1e6, 2e5, 20.0, 6.0, 60.0}, Plate{4.0, 5e6, 100.0}, 2.0)},
        {{800.0, -0.02, 0.9, 0.6, -10.0, 40.0, "over a kerb, frost"},
         {800.0, 0.02, 0.9, 0.6, 23.0, 50.0, "over a kerb"}});
    add(noises,
        {"steering gear", "rack / yoke", "steel / PTFE liner",
         sliding(Joint{0.08, 3e6, 5e5, 3.0, 2.0, 70.0}, Plate{0.8, 1e6, 8.0}, 1.0)},
        {{30.0, 0.2, 0.6, 0.5, 23.0, 50.0, "turned at rest, liner worn"},
         {80.0, 0.05, 0.5, 0.3, 23.0, 50.0, "turned slowly at rest"}});
}

}  // namespace

std::vector<StarterNoise> starter_noises() {
    Noises noises;
    add_seals(noises);
    add_doors(noises);
    add_interior(noises);
    add_chassis(noises);
    return noises;
}

}  // namespace stridor::noise_library
