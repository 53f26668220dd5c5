#include "stridor/noise_library/starter_noises.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/noise_library/entry_filler.hpp"
#include "stridor/recordings/audio/wav.hpp"
#include "stridor/storage/new_file.hpp"
#include "stridor/sweep/ready_charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <map>
#include <optional>

namespace stridor::noise_library {

namespace {

// The table of the starter library: a system each, with the joint, the plate and the drive it is made of, and below it
// a row per noise. Which of them are heard, and as what, is the program's to say.

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
        noise.c.contact() = Contact{
            .preload = row.preload, .static_friction = row.static_friction, .kinetic_friction = row.kinetic_friction};
        noise.c.drive.velocity = row.velocity;
        noises.push_back(std::move(noise));
    }
}

// a second half is judged, as of the soft parts; both are heard
Case sliding(const Joint& joint, const Plate& plate, double duration) {
    Case c;
    c.joint() = joint;
    c.plate = plate;
    c.drive.kind = parameters::DriveKind::constant;
    c.run.duration = duration;
    c.run.window = 0.5 * duration;
    return c;
}

Case to_and_fro(const Joint& joint, const Plate& plate, double amplitude, double frequency) {
    Case c;
    c.joint() = joint;
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

using parameters::Direction;

/// A noise as it comes into the library.
struct MadeNoise {
    signal::Signal sound;
    std::string contact;  // its verdict by contact states: "going squeal, coming none"
};

std::string contact_verdict(const parameters::Case& c, const sweep::Attempt& attempt) {
    const auto category = [&](Direction direction) {
        return std::string(classification::name(sweep::cell_of(c, direction, attempt).category));
    };
    if (parameters::is_steady(c.drive)) return category(parameters::steady_direction(c.drive));
    return "going " + category(Direction::going) + ", coming " + category(Direction::coming);
}

MadeNoise make_noise(const parameters::Case& c, const std::stop_token& stop, integration::Workspace& workspace) {
    sound::AuralisationSettings settings;
    settings.density = 8;                          // as the cells of a chart are heard (docs/methods/auralisation.md)
    settings.stretches = {{0.0, c.run.duration}};  // all of it, faded at its ends
    const std::optional<hearing::RunSound> sound = hearing::sound_of_run(c, settings, stop, workspace);
    if (!sound) throw Error(ErrorKind::interrupted, {"stopped", "what was added stays", "Run it again."});
    if (sound->attempt.status != sweep::Status::done)
        throw Error(ErrorKind::numerical, {c.title + " has no result", sound->attempt.message, ""});
    return {hearing::joined(sound->parts), contact_verdict(c, sound->attempt)};
}

// the loudest sample lies 1 dB below full scale, which the file states: levels compare
double full_scale_of(const signal::Signal& sound) {
    constexpr double bits_of_a_decibel = 1.0 / 6.020599913279624;  // [1] log2 of the factor
    const double peak = sound::peak(sound.samples);
    return peak > 0.0 ? peak * base::power_of_2(bits_of_a_decibel) : 1.0;
}

void write_noise(const std::string& file, const signal::Signal& sound, const parameters::Case& c,
                 const std::string& case_text) {
    recordings::WavOptions options;
    options.full_scales = {{full_scale_of(sound), sound.unit}};
    // no version of the program: the same noise is the same file for the next one, too
    options.description = "simulated by stridor: joint velocity along x; " + c.title;
    options.history = recordings::case_mark + case_text;
    recordings::write_wav(file, *signal::source_of({sound}), options);
}

Entry given(const StarterNoise& noise, const std::string& contact, const std::string& case_text) {
    const parameters::Drive& drive = noise.c.drive;
    Entry entry;
    entry.system = noise.system;
    entry.parts = noise.parts;
    entry.materials = noise.materials;
    entry.operation = noise.operation;
    entry.recorded = "simulation";
    entry.preload = noise.c.contact().preload;
    entry.velocity = peak_velocity(drive);
    entry.velocity_profile = profile_of(drive);
    entry.temperature = noise.temperature;
    entry.humidity = noise.humidity;
    entry.sensor = "none: the joint's velocity along the contact";
    entry.case_text = case_text;
    entry.author = "stridor library starter";
    entry.notes = "Simulated; its parameters are judgement. By contact states: " + contact + ".";
    return entry;
}

// by name and case: what was made before need not be made again to be known
std::optional<std::int64_t> made_before(Library& library, const std::string& name, const std::string& case_text) {
    Query query;
    query.conditions = {{"file", Comparison::equal, name}, {"recorded", Comparison::equal, "simulation"}};
    query.extent = EntryExtent::whole;
    for (const Entry& entry : library.find(query))
        if (entry.case_text == case_text) return entry.id;
    return std::nullopt;
}

class Starter {
public:
    Starter(Library& library, const StarterAdding& adding) : library_(library), adding_(adding) {}

    void run(Arrivals& arrivals) {
        const std::vector<StarterNoise> noises = starter_noises();
        arrivals.left = noises.size();
        std::map<std::string_view, int> numbers;
        for (const StarterNoise& noise : noises) {
            std::string name = fmt::format("{}-{}.wav", noise.system, ++numbers[noise.system]);
            std::replace(name.begin(), name.end(), ' ', '-');
            add(noise, name, arrivals);
            --arrivals.left;
            adding_.progress(1.0 - static_cast<double>(arrivals.left) / static_cast<double>(noises.size()), name);
        }
    }

private:
    void add(const StarterNoise& noise, const std::string& name, Arrivals& arrivals) {
        const std::string case_text = adding_.case_text(noise.c);
        if (const auto twin = made_before(library_, name, case_text)) return arrivals.known.push_back({name, *twin});
        const MadeNoise made = make_noise(noise.c, adding_.stop, workspace_);
        const std::filesystem::path file = folder_.path() / name;
        write_noise(file.string(), made.sound, noise.c, case_text);
        if (const auto twin = library_.entry_with(audio_hash(file))) return arrivals.known.push_back({name, *twin});
        const Entry entry = add_recording(library_, {file, given(noise, made.contact, case_text)}, adding_.probe);
        arrivals.added.push_back(entry.id);
        adding_.added(entry);
    }

    Library& library_;
    const StarterAdding& adding_;
    storage::PrivateFolder folder_{};
    integration::Workspace workspace_{};
};

}  // namespace

std::vector<StarterNoise> starter_noises() {
    Noises noises;
    add_seals(noises);
    add_doors(noises);
    add_interior(noises);
    add_chassis(noises);
    return noises;
}

Added add_starter(Library& library, const StarterAdding& adding) {
    Added result;
    try {
        Starter(library, adding).run(result.arrivals);
    } catch (const Error&) {
        result.ended_by = std::current_exception();
    }
    return result;
}

}  // namespace stridor::noise_library
