#include "stridor/io/sound/simulated_wav.hpp"

#include "stridor/hearing/rendered_sound.hpp"
#include "stridor/recordings/audio/wav.hpp"
#include "stridor/sound/auralisation.hpp"

#include <memory>

namespace stridor::io {

namespace {

constexpr double loudest = 0.89125094;  // [1] of full scale: -1 dB

}  // namespace

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
