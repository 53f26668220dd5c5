#include "stridor/console/results/listening_text.hpp"

#include "stridor/console/terminal.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/io/sound/listening_texts.hpp"

#include <fmt/format.h>

namespace stridor::console {

std::string listening_text(const io::SoundInfo& info) {
    const double loudest = info.peak < hearing::least_motion ? 0.0 : info.peak;
    std::string text = fmt::format("{}, {:g} s at {:g} Hz", io::motion_words(info), info.duration, info.rate);
    if (!info.cell.empty()) text += "; cell " + info.cell;
    text += fmt::format("\npeak {:.4g} {}, rms {:.4g} {}; full scale {:.4g} {} ({})\n", loudest, info.unit, info.rms,
                        info.unit, info.full_scale, info.unit, info.level);
    if (loudest == 0.0) text += "nothing vibrates in this part of the motion: the sound is silence\n";
    if (!info.file.empty()) text += info.file + "\n";
    return text;
}

}  // namespace stridor::console
