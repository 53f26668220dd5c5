#include "stridor/io/sound/json_listen.hpp"

#include "stridor/io/json_parts.hpp"

namespace stridor::io {

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

}  // namespace stridor::io
