#include "interrupt.hpp"
#include "library/library.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/console/progress.hpp"
#include "stridor/console/results/library_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/library/json_library.hpp"
#include "stridor/io/library/recording_probe.hpp"
#include "stridor/noise_library/entry_filler.hpp"
#include "stridor/noise_library/recording.hpp"
#include "stridor/noise_library/starter_noises.hpp"
#include "stridor/recordings/audio/wav.hpp"
#include "stridor/storage/temporary.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>

namespace stridor::app {

namespace {

using noise_library::Access;
using noise_library::Entry;
using parameters::Direction;

struct StarterOptions {
    LibraryOption library;
    bool json = false;
};

/// A noise as it comes into the library.
struct MadeNoise {
    signal::Signal sound;
    std::string contact;  // its verdict by contact states: "going squeal, coming none"
};

std::string contact_verdict(const parameters::Case& c, const sweep::Attempt& attempt) {
    const auto category = [&](Direction direction) {
        return std::string(classification::name(sweep::cell_of(c, direction, attempt).category));
    };
    if (c.drive.kind == parameters::DriveKind::constant)
        return category(c.drive.velocity > 0.0 ? Direction::going : Direction::coming);
    return "going " + category(Direction::going) + ", coming " + category(Direction::coming);
}

MadeNoise made(const parameters::Case& c, const std::stop_token& stop, integration::Workspace& workspace) {
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
    constexpr double bits_of_1_dB = 1.0 / 6.020599913279624;  // [1] log2 of the factor
    const double peak = sound::peak(sound.samples);
    return peak > 0.0 ? peak * base::power_of_2(bits_of_1_dB) : 1.0;
}

std::string case_text(const parameters::Case& c) {
    return io::case_toml(c, {io::Comments::none, ""});
}

void write(const std::string& file, const signal::Signal& sound, const parameters::Case& c) {
    recordings::WavOptions options;
    options.full_scales = {{full_scale_of(sound), sound.unit}};
    // no version of the program: the same noise is the same file for the next one, too
    options.description = "simulated by stridor: joint velocity along x; " + c.title;
    options.history = recordings::case_mark + case_text(c);
    recordings::write_wav(file, *signal::source_of({sound}), options);
}

Entry given(const noise_library::StarterNoise& noise, const std::string& contact) {
    const parameters::Drive& drive = noise.c.drive;
    Entry entry;
    entry.system = noise.system;
    entry.parts = noise.parts;
    entry.materials = noise.materials;
    entry.operation = noise.operation;
    entry.recorded = "simulation";
    entry.preload = noise.c.contact.preload;
    entry.velocity = noise_library::peak_velocity(drive);
    entry.velocity_profile =
        drive.kind == parameters::DriveKind::constant ? "constant" : fmt::format("sinusoidal {:g} Hz", drive.frequency);
    entry.temperature = noise.temperature;
    entry.humidity = noise.humidity;
    entry.sensor = "none: the joint's velocity along the contact";
    entry.case_text = case_text(noise.c);
    entry.author = "stridor library starter";
    entry.notes = "Simulated; its parameters are judgement. By contact states: " + contact + ".";
    return entry;
}

/// Makes the noises one after the other; those the library has stay what they are.
class Starter {
public:
    Starter(const StarterOptions& options, const std::stop_token& stop)
        : options_(options),
          stop_(stop),
          noises_(noise_library::starter_noises()),
          library_(open_library(options.library, Access::fill)) {}

    void run() {
        arrivals_.left = noises_.size();
        std::map<std::string_view, int> numbers;
        for (const noise_library::StarterNoise& noise : noises_) {
            std::string name = fmt::format("{}-{}.wav", noise.system, ++numbers[noise.system]);
            std::replace(name.begin(), name.end(), ' ', '-');
            add(noise, name);
            --arrivals_.left;
            display_.show(1.0 - static_cast<double>(arrivals_.left) / static_cast<double>(noises_.size()), name);
        }
    }

    void tell() {
        display_.clear();
        if (options_.json) console::print(io::arrivals_json(library_.file(), entries_, arrivals_) + "\n");
        console::say(console::summary_text(arrivals_));
    }

private:
    // those that were made before, by name and case, need not be made again to be known
    std::optional<std::int64_t> made_before(const noise_library::StarterNoise& noise, const std::string& name) {
        noise_library::Query query;
        query.conditions = {{"file", noise_library::Comparison::equal, name},
                            {"recorded", noise_library::Comparison::equal, "simulation"}};
        query.extent = noise_library::EntryExtent::whole;
        for (const Entry& entry : library_.find(query))
            if (entry.case_text == case_text(noise.c)) return entry.id;
        return std::nullopt;
    }

    void add(const noise_library::StarterNoise& noise, const std::string& name) {
        if (const auto twin = made_before(noise, name)) return arrivals_.known.push_back({name, *twin});
        const MadeNoise made_noise = made(noise.c, stop_, workspace_);
        const std::filesystem::path file = folder_.path() / name;
        write(file.string(), made_noise.sound, noise.c);
        if (const auto twin = library_.entry_with(noise_library::audio_hash(file)))
            return arrivals_.known.push_back({name, *twin});
        const Entry entry = noise_library::add_recording(library_, {file, given(noise, made_noise.contact)},
                                                         io::probe_of(hearing_, {}));
        arrivals_.added.push_back(entry.id);
        display_.clear();
        if (options_.json)
            entries_.push_back(entry);
        else
            console::print(console::judged_line(entry));
    }

    const StarterOptions& options_;
    std::stop_token stop_;
    std::vector<noise_library::StarterNoise> noises_;
    noise_library::Library library_;
    storage::PrivateFolder folder_{};
    integration::Workspace workspace_{};
    console::ShareDisplay display_{"made"};
    noise_library::Arrivals arrivals_{};
    io::HearingOptions hearing_{io::Judging::by_ear, {}, {}, console::say_note};
    std::vector<Entry> entries_{};  // for JSON alone
};

void fill(const StarterOptions& options) {
    const Interrupt interrupt;
    Starter starter(options, interrupt.token());
    run_and_tell(starter);
}

}  // namespace

void add_library_starter(CLI::App& library) {
    auto options = std::make_shared<StarterOptions>();
    CLI::App* command = library.add_subcommand(
        "starter", "Fill a library with simulated noises of many systems, to try it before there are recordings.");
    add_library_option(*command, options->library);
    command->add_option("library", options->library.file, "the same as --library FILE")
        ->type_name("LIBRARY")
        ->excludes("--library");
    command->add_flag("--json", options->json,
                      "print the new entries and a summary as one JSON document (schema stridor.library/1)");
    command->footer(
        "The noises are simulated on the spot, the same on every machine. What the library has already is not added "
        "again.\n"
        "Examples:\n  stridor library starter try.sqlite\n"
        "  stridor rig sensitivity --library try.sqlite --where \"system = seal\" --over preload");
    command->callback([options] { fill(*options); });
}

}  // namespace stridor::app
