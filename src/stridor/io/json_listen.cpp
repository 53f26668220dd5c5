#include "stridor/io/json_listen.hpp"

#include "stridor/io/json_parts.hpp"

namespace stridor::io {

std::string listen_json(const parameters::Case& c, const SoundInfo& sound) {
    json_parts::Json document = json_parts::opening("listen", c);
    document["sound"] = {{"file", json_parts::text_or_null(sound.file)},
                         {"player", json_parts::text_or_null(sound.player)},
                         {"cell", json_parts::text_or_null(sound.cell)},
                         {"origin", "simulation"},
                         {"of", sound.of},
                         {"component", sound.component},
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
    json_parts::Json units = json_parts::case_units(c);
    for (const char* key : {"peak", "rms", "full_scale"})
        units[std::string("sound.") + key] = sound.unit;
    units["sound.rate"] = units["sound.high_pass"] = "Hz";
    units["sound.duration"] = "s";
    document["units"] = units;
    return json_parts::text_of(document);
}

}  // namespace stridor::io
