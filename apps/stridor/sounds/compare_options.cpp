#include "sounds/compare_options.hpp"

#include "arguments.hpp"
#include "interrupt.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/console/terminal.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace stridor::app {

namespace {

using classification::ComparedSound;
using hearing::NamedSound;

constexpr double least_detail = 1e-3;  // [s]
constexpr double most_detail = 2.0;    // [s]

double detail_of(const std::string& text) {
    const double detail = base::parse_quantity(text, "s");
    if (!(detail >= least_detail && detail <= most_detail))
        base::refuse("--detail " + text + " is too short or too long", "it goes from 1 ms to 2 s", "");
    return detail;
}

}  // namespace

void add_motion_options(CLI::App& command, MotionOptions& options) {
    command
        .add_option("--of", options.of,
                    "whose motion stands for the sound of a simulation: joint (of several contacts the strongest), "
                    "plate, or a name as for `stridor listen`")
        ->type_name("joint|plate|NAME")
        ->capture_default_str();
    command.add_option("--quantity", options.quantity, "what of it")
        ->check(one_of({"velocity", "acceleration"}))
        ->capture_default_str();
}

hearing::AskedMotion asked_motion(const MotionOptions& options) {
    const signal::MotionQuantity quantity =
        options.quantity == "velocity" ? signal::MotionQuantity::velocity : signal::MotionQuantity::acceleration;
    return {options.of, "", quantity};
}

void add_compare_options(CLI::App& command, CompareOptions& options) {
    command.add_option("sounds", options.sounds, "2 to 8 sounds: recordings, cases, cells of charts, library:ID")
        ->required();
    command.add_option("--label", options.labels, "what a sound is called; once for each, in their order")
        ->type_name("TEXT")
        ->allow_extra_args(false);
    add_library_option(command, options.library);
    add_motion_options(command, options.motion);
}

io::SoundLookup lookup_in(const LibraryOption& library) {
    return {library.file, console::say_note, console::say_warning};
}

ComparedSound load_sound(const NamedSound& sound, const hearing::ComparisonSettings& settings) {
    if (std::holds_alternative<hearing::RecordedSound>(sound.source)) return hearing::compared(sound, settings);
    const Interrupt interrupt;
    return hearing::compared(sound, settings, interrupt.token());
}

std::vector<ComparedSound> load_sounds(const CompareOptions& options) {
    hearing::require_comparable(options.sounds.size());
    if (!options.labels.empty() && options.labels.size() != options.sounds.size())
        base::refuse(fmt::format("{} labels for {} sounds", options.labels.size(), options.sounds.size()),
                     "each sound needs its own", "");
    if (std::count(options.sounds.begin(), options.sounds.end(), "-") > 1)
        base::refuse("standard input is asked for twice", "it can be read once", "");
    hearing::ComparisonSettings settings;
    settings.detail = detail_of(options.detail);
    settings.motion = asked_motion(options.motion);
    std::vector<NamedSound> all;
    for (const std::string& text : options.sounds)
        all.push_back(io::named_sound(text, lookup_in(options.library)));
    settings.rate = hearing::common_rate(all);
    std::vector<ComparedSound> sounds;
    for (const NamedSound& each : all)
        sounds.push_back(load_sound(each, settings));
    for (std::size_t k = 0; k < options.labels.size(); ++k)
        sounds[k].label = options.labels[k];
    if (std::any_of(all.begin(), all.end(), [&](const NamedSound& each) { return is_resampled(each, settings.rate); }))
        console::say_note(fmt::format("all sounds are compared at the lowest rate, {:g} Hz", settings.rate));
    return sounds;
}

}  // namespace stridor::app
