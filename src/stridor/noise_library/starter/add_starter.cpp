#include "stridor/noise_library/starter/add_starter.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/noise_library/entry_filler.hpp"
#include "stridor/noise_library/starter/starter_noises.hpp"
#include "stridor/recordings/audio/wav.hpp"
#include "stridor/storage/new_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

namespace stridor::noise_library {

namespace {

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
    entry.preload = noise.c.contact.preload;
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
