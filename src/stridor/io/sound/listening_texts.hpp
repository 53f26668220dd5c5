#pragma once

#include "stridor/hearing/heard_motion.hpp"
#include "stridor/hearing/rendered_sound.hpp"
#include "stridor/hearing/sound_comparison.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/sound/auralisation.hpp"

#include <optional>
#include <stop_token>
#include <string>

/// Which motion is made audible, and how loud, as a command line says it.
namespace stridor::io {

/// A sound that was made of a simulated motion.
struct SoundInfo {
    std::string file;         // empty: it was played
    std::string player;       // the program that plays it; empty: it was written
    std::string cell;         // of which chart's cell, in words; empty: of a case
    std::string of;           // "joint", "plate", or a name
    std::string component;    // "x": along, "y": across the contact; empty: of a row
    std::string quantity;     // "velocity", "acceleration"
    std::string direction;    // "whole", "going", "coming"
    std::string part;         // "all", "judged"
    std::string level;        // "normalised", "absolute"
    std::string unit;         // of peak, rms and full_scale
    double rate = 0.0;        // [Hz]
    double duration = 0.0;    // [s]
    double high_pass = 0.0;   // [Hz]
    double peak = 0.0;        // [unit]
    double rms = 0.0;         // [unit]
    double full_scale = 1.0;  // [unit] the largest number of the file
};

/// Returns "stridor.listen/1": the case and what was made of it.
std::string listen_json(const parameters::Case& c, const SoundInfo& sound);

/// The texts of `stridor listen`; quantities carry their units.
struct ListeningTexts {
    std::string cell{};        // "x=20 N,y=0.6"; empty: the case itself
    std::string direction{};   // "going", "coming"; empty: the whole motion
    bool is_judged = false;    // only the steady part the verdict is made from
    std::string of = "joint";  // as `hearing::AskedMotion` has it
    std::string quantity = "velocity";
    std::string component{};  // empty: x of the joint or contact, y of the plate
    std::string rate = "48000 Hz";
    std::string seconds{};  // empty: the whole run
    std::string level = "normalised";
    std::string full_scale{};
    std::string high_pass = "20 Hz";
    std::string fade = "5 ms";
};

/// The case that is heard.
struct ListeningChoice {
    parameters::Case c;
    std::string cell{};  // of which chart's cell, in words; empty: of a case
};

/// Reads the case, or the chart whose cell is asked for; more seconds than it lasts make it a longer run. The direction
/// that a cell names is that of the texts unless they have their own. Throws `Error` (input).
ListeningChoice chosen_case(ListeningTexts& texts, TomlSource source);

/// Returns which motion the texts ask for.
hearing::AskedMotion asked_motion(const ListeningTexts& texts);

/// Returns how that motion of the case becomes a sound. Throws `Error` (input) for what is no sound, or none of this
/// motion.
sound::AuralisationSettings listening_settings(const ListeningTexts& texts, const parameters::Case& c,
                                               const hearing::HeardMotion& motion);

/// Returns what the largest number of the file stands for [m/s or m/s^2]: normalised, the loudest sample lies at -1
/// dBFS; absolute, it is 10 m/s or 100 km/s^2, or as the texts say. Throws `Error` (input) where the sound would be
/// clipped.
double listening_full_scale(const ListeningTexts& texts, const hearing::RenderedSound& sound);

/// Returns what was made of which motion; file and player are left to the caller. Throws as `listening_full_scale`
/// does.
SoundInfo sound_info(const ListeningTexts& texts, const ListeningChoice& choice, const hearing::HeardMotion& motion,
                     const sound::AuralisationSettings& settings, const hearing::RenderedSound& sound);

/// Returns whose motion was made audible: "joint velocity along x".
std::string motion_words(const SoundInfo& info);

/// Returns what a file of it says in its description.
std::string sound_description(const SoundInfo& info, const parameters::Case& c);

/// Writes the heard stretches of a simulated motion as WAV of 24 bits, `rate` samples a second [Hz], the loudest at -1
/// dB of full scale; the file says what its full scale stands for.
///
/// Throws what `hearing::heard_motion` and `hearing::render` throw, and `Error` (io).
void write_simulated_wav(const std::string& file, const hearing::SimulatedSound& simulated, double rate,
                         const hearing::AskedMotion& motion, const std::stop_token& stop);

}  // namespace stridor::io
