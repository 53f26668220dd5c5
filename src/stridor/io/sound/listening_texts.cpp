#include "stridor/io/sound/listening_texts.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/escapes.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/base/version.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/io/json_parts.hpp"
#include "stridor/record/schedule.hpp"
#include "stridor/recordings/audio/wav.hpp"
#include "stridor/sweep/cell_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace stridor::io {

namespace {

using parameters::Direction;
using parameters::direction_names;
using signal::MotionQuantity;

constexpr double normal_peak = -1.0;  // [dBFS] where the largest sample of a normalised sound lies
// full scale of an absolute sound: the loudest of Table 1 peaks at a third of it
constexpr double velocity_full_scale = 10.0;       // [m/s]
constexpr double acceleration_full_scale = 100e3;  // [m/s^2]

std::optional<Direction> direction_of(const ListeningTexts& texts) {
    if (texts.direction.empty()) return std::nullopt;
    return texts.direction == "going" ? Direction::going : Direction::coming;
}

// --- which motion

// nothing where the whole run is heard
std::optional<double> seconds_of(const ListeningTexts& texts) {
    if (texts.seconds.empty()) return std::nullopt;
    const double seconds = base::parse_quantity(texts.seconds, "s");
    if (!(seconds > 0.0))
        base::refuse("--seconds " + texts.seconds + " is no time to listen", "it must be positive", "");
    return seconds;
}

// a longer run, put over the file's as any other key; of one that lasts longer the beginning is heard
void set_duration(TomlSource& source, const parameters::Case& c, const std::optional<double>& seconds) {
    if (!seconds || *seconds <= c.run.duration) return;
    const bool is_whole = c.run.window == c.run.duration;
    source.overrides.push_back("run.duration=" + base::shortest(*seconds));
    if (is_whole) source.overrides.push_back("run.window=" + base::shortest(*seconds));
}

ListeningChoice chosen_cell(const ListeningTexts& texts, TomlSource source) {
    set_duration(source, read_study(source).base, seconds_of(texts));
    const sweep::Study study = read_study(source);
    sweep::CellChoice cell = sweep::parse_cell(texts.cell);
    if (const std::optional<Direction> direction = direction_of(texts)) cell.direction = direction;
    const sweep::CellPlace place = sweep::nearest_cell(study, cell);
    ListeningChoice choice{sweep::case_at(study, place), {}};
    choice.cell = sweep::cell_words(study, place);
    return choice;
}

// --- what of it

MotionQuantity quantity_in(const ListeningTexts& texts) {
    return texts.quantity == "velocity" ? MotionQuantity::velocity : MotionQuantity::acceleration;
}

// the part of the motion that is heard; all of it if no direction is named
std::vector<sound::Stretch> stretches_in(const ListeningTexts& texts, const parameters::Case& c) {
    const std::optional<Direction> direction = direction_of(texts);
    const bool has_one_phase = parameters::has_one_phase(c.drive);
    if (parameters::is_by_force(c.drive) && direction)
        base::refuse("this drive has no " + texts.direction + " phase", "a force shakes the structure",
                     "Leave out --direction.");
    if (has_one_phase && direction && texts.cell.empty() && *direction != parameters::steady_direction(c.drive))
        base::refuse("this drive has no " + texts.direction + " phase", "its velocity is constant",
                     "Change its sign: --set drive.velocity=" + base::shortest(-c.drive.velocity));
    if (!texts.is_judged && (has_one_phase || !direction)) return {{0.0, c.run.duration}};
    if (!has_one_phase && !direction)
        base::refuse("--judged needs a direction", "going and coming phases are judged by themselves",
                     "Add --direction going or coming.");
    const record::Phase phase = has_one_phase                    ? record::Phase::all
                                : *direction == Direction::going ? record::Phase::going
                                                                 : record::Phase::coming;
    std::vector<sound::Stretch> found =
        sound::stretches_of(record::schedule(c), phase, texts.is_judged ? record::Use::judged : record::Use::counted);
    if (found.empty())
        base::refuse("no " + texts.direction + " phase lies in the window of " + base::shortest(c.run.window) + " s",
                     texts.is_judged ? "only whole phases are judged" : "the drive does not move that way",
                     "Ask for more --seconds.");
    return found;
}

constexpr double loudest = 0.89125094;  // [1] of full scale: -1 dB

}  // namespace

std::string listen_json(const parameters::Case& c, const SoundInfo& sound) {
    base::Json document = json_parts::opening("listen", c);
    document["sound"] = {{"file", base::text_or_null(sound.file)},
                         {"player", base::text_or_null(sound.player)},
                         {"cell", base::text_or_null(sound.cell)},
                         {"origin", "simulation"},
                         {"of", sound.of},
                         {"component", base::text_or_null(sound.component)},
                         {"quantity", sound.quantity},
                         {"direction", sound.direction},
                         {"part", sound.part},
                         {"rate", sound.rate},
                         {"duration", sound.duration},
                         {"high_pass", sound.high_pass},
                         {"level", sound.level},
                         {"peak", sound.peak},
                         {"rms", sound.rms},
                         {"full_scale", sound.full_scale}};
    base::Json units = json_parts::case_units(c);
    for (const char* key : {"peak", "rms", "full_scale"})
        units[std::string("sound.") + key] = sound.unit;
    units["sound.rate"] = units["sound.high_pass"] = "Hz";
    units["sound.duration"] = "s";
    document["units"] = units;
    return base::text_of(document);
}

ListeningChoice chosen_case(ListeningTexts& texts, TomlSource source) {
    if (texts.direction.empty() && !texts.cell.empty())
        if (const auto of_cell = sweep::parse_cell(texts.cell).direction)
            texts.direction = direction_names[static_cast<std::size_t>(*of_cell)];
    if (!texts.cell.empty()) return chosen_cell(texts, std::move(source));
    if (!texts.seconds.empty()) set_duration(source, read_case(source), seconds_of(texts));
    return {read_case(source)};
}

hearing::AskedMotion asked_motion(const ListeningTexts& texts) {
    return {texts.of, texts.component, quantity_in(texts)};
}

sound::AuralisationSettings listening_settings(const ListeningTexts& texts, const parameters::Case& c,
                                               const hearing::HeardMotion& motion) {
    sound::AuralisationSettings settings;
    settings.pickup = motion.pickup;
    settings.rate = base::parse_quantity(texts.rate, "Hz");
    settings.high_pass = base::parse_quantity(texts.high_pass, "Hz");
    settings.fade = base::parse_quantity(texts.fade, "s");
    if (!(settings.rate >= 8000.0 && settings.rate <= 192000.0) || settings.rate != std::floor(settings.rate))
        base::refuse("--rate " + texts.rate + " is no rate for a sound", "it is a whole number from 8 kHz to 192 kHz",
                     "Use 44100, 48000 or 51200.");
    if (!(settings.high_pass >= 0.0 && settings.high_pass <= 0.1 * settings.rate))
        base::refuse("--high-pass " + texts.high_pass + " leaves nothing to hear",
                     "it goes from 0 to a tenth of the rate", "20 Hz is the default, 0 leaves all in.");
    if (!(settings.fade >= 0.0)) base::refuse("--fade " + texts.fade + " is no time", "it must not be negative", "");
    const double end = seconds_of(texts).value_or(c.run.duration);
    for (const sound::Stretch& stretch : stretches_in(texts, c))
        if (stretch.from < end) settings.stretches.push_back({stretch.from, std::min(stretch.to, end)});
    if (settings.stretches.empty())
        base::refuse("nothing of this part lies in the first " + base::shortest(end) + " s", "",
                     "Ask for more --seconds.");
    return settings;
}

double listening_full_scale(const ListeningTexts& texts, const hearing::RenderedSound& sound) {
    const std::string unit = sound.layout().channels.front().unit;
    const bool is_absolute = texts.level == "absolute";
    if (!texts.full_scale.empty() && !is_absolute)
        base::refuse("--full-scale does not go with a normalised level",
                     "its full scale follows from the loudest sample", "Add --level absolute.");
    const double usual = unit == "m/s" ? velocity_full_scale : acceleration_full_scale;
    if (!is_absolute)
        return sound.peak() < hearing::least_motion
                   ? usual
                   : sound.peak() / base::power_of_2(normal_peak / 20.0 * 3.321928094887362);
    const double full_scale = texts.full_scale.empty() ? usual : base::parse_quantity(texts.full_scale, unit);
    if (!(full_scale > 0.0)) base::refuse("--full-scale " + texts.full_scale + " is not positive", "", "");
    if (sound.peak() > full_scale)
        base::refuse(fmt::format("the sound peaks at {:.4g} {}, above the full scale of {:g} {}", sound.peak(), unit,
                                 full_scale, unit),
                     "it would be clipped", fmt::format("Use --full-scale \"{:.1g} {}\".", 2.0 * sound.peak(), unit));
    return full_scale;
}

SoundInfo sound_info(const ListeningTexts& texts, const ListeningChoice& choice, const hearing::HeardMotion& motion,
                     const sound::AuralisationSettings& settings, const hearing::RenderedSound& sound) {
    SoundInfo info;
    info.cell = choice.cell;
    info.of = motion.of;
    info.component = motion.component;
    info.quantity = texts.quantity;
    info.direction = texts.direction.empty() ? "whole" : texts.direction;
    info.part = texts.is_judged ? "judged" : "all";
    info.unit = sound::unit_of(settings.pickup.quantity);
    info.rate = settings.rate;
    info.duration = static_cast<double>(sound.frames()) / settings.rate;
    info.high_pass = settings.high_pass;
    info.peak = sound.peak();
    info.rms = std::sqrt(sound.mean_square());
    info.level = texts.level;
    info.full_scale = listening_full_scale(texts, sound);
    return info;
}

std::string motion_words(const SoundInfo& info) {
    return info.of + " " + info.quantity + (info.component.empty() ? "" : " along " + info.component);
}

std::string sound_description(const SoundInfo& info, const parameters::Case& c) {
    return fmt::format("simulated by stridor {}: {}; {}", base::version(), motion_words(info), c.title);
}

void write_simulated_wav(const std::string& file, const hearing::SimulatedSound& simulated, double rate,
                         const hearing::AskedMotion& motion, const std::stop_token& stop) {
    const hearing::HeardMotion heard = hearing::heard_motion(simulated.c, motion, stop);
    sound::AuralisationSettings settings;
    settings.pickup = heard.pickup;
    settings.rate = rate;
    settings.stretches = simulated.stretches;
    const std::unique_ptr<hearing::RenderedSound> sound = hearing::render(simulated.c, settings, stop, [](double) {});
    const double full_scale = sound->peak() > 0.0 ? sound->peak() / loudest : 1.0;
    recordings::write_wav(file, *sound,
                          {recordings::WavSamples::pcm_24,
                           {{full_scale, sound::unit_of(settings.pickup.quantity)}},
                           "simulated by stridor: " + hearing::motion_words(heard)});
}

}  // namespace stridor::io
