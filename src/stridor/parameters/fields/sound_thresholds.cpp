#include "stridor/parameters/fields/sound_thresholds.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/field_table.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace stridor::parameters {

namespace {

constexpr Range share_range{0.0, 1.0, Range::Low::closed};
constexpr Range level_range{-200.0, 200.0, Range::Low::closed};
constexpr Range not_negative_range{0.0, 1e6, Range::Low::closed};

constexpr std::array threshold_table{
    SoundThreshold{"least_clearness", "dB", "sound over background from which there is anything to judge", level_range,
                   &SoundThresholds::least_clearness},
    SoundThreshold{"quiet_depth", "dB", "what lies this far below the loudest stretch is background", level_range,
                   &SoundThresholds::quiet_depth, SoundJudge::both},
    SoundThreshold{"decay", "dB/s", "fall of the level from which a sound dies away by itself", not_negative_range,
                   &SoundThresholds::decay},
    SoundThreshold{"decay_straightness", "1", "largest deviation from a straight fall, as a share of the fall",
                   share_range, &SoundThresholds::decay_straightness},
    SoundThreshold{"creak_rest", "1", "share of time at rest between impulses from which a sound is creak", share_range,
                   &SoundThresholds::creak_rest},
    SoundThreshold{"creak_kurtosis", "1", "kurtosis from which a sound is creak", not_negative_range,
                   &SoundThresholds::creak_kurtosis},
    SoundThreshold{"rubbing_tonality", "1", "share of the strongest line below which a sound may be mere rubbing",
                   share_range, &SoundThresholds::rubbing_tonality},
    SoundThreshold{"rubbing_repetition", "1", "likeness of cycles below which a sound may be mere rubbing", share_range,
                   &SoundThresholds::rubbing_repetition},
    SoundThreshold{"least_frequency", "Hz", "a strongest line below it is the rumble of rubbing and no tone",
                   not_negative_range, &SoundThresholds::least_frequency},
    SoundThreshold{"creak_periodicity", "1", "likeness of the envelope's cycles from which rubbing is creak",
                   share_range, &SoundThresholds::creak_periodicity},
    SoundThreshold{"squeal_regularity", "1", "likeness of neighbouring cycles from which a tone is squeal", share_range,
                   &SoundThresholds::squeal_regularity},
    SoundThreshold{"squeal_repetition", "1",
                   "likeness of the best cycle from which it is squeal whatever its tone does", share_range,
                   &SoundThresholds::squeal_repetition},
    SoundThreshold{"squeal_movement", "1", "most movement of the strongest frequency in a squeal", share_range,
                   &SoundThresholds::squeal_movement},
    SoundThreshold{"least_impulses", "1", "fewest impulses of a creak; fewer are undecided", not_negative_range,
                   &SoundThresholds::least_impulses},
    SoundThreshold{"creak_pause", "s", "longest rest between two impulses of one creak", not_negative_range,
                   &SoundThresholds::creak_pause},
    SoundThreshold{"least_duration", "s", "shortest noise that can be judged; shorter is undecided", not_negative_range,
                   &SoundThresholds::least_duration},
    SoundThreshold{"least_band", "Hz", "half the rate of a recording, below which nothing but a squeal can be told",
                   not_negative_range, &SoundThresholds::least_band, SoundJudge::both},
    SoundThreshold{"majority", "1", "share of the energy that the category of a whole recording must have", share_range,
                   &SoundThresholds::majority},
    SoundThreshold{"least_share", "1", "share of a recording's energy from which a noise names it", share_range,
                   &SoundThresholds::least_share, SoundJudge::ear},
    SoundThreshold{"certainty", "1", "probability from which the ear decides on a recording", share_range,
                   &SoundThresholds::certainty, SoundJudge::ear},
};

// decibels have no dimension that `parse_quantity` knows: their unit is cut off first
double threshold_value(std::string_view text, std::string_view unit) {
    if (unit.starts_with("dB")) {
        std::string_view number = base::trimmed(text);
        if (number.ends_with(unit)) number.remove_suffix(unit.size());
        return base::parse_quantity(number, "1");
    }
    return base::parse_quantity(text, unit);
}

[[noreturn]] void refuse_key(std::string_view key) {
    std::vector<std::string_view> names;
    for (const SoundThreshold& threshold : threshold_table)
        names.push_back(threshold.name);
    throw Error(ErrorKind::input,
                {"no threshold is called \"" + std::string(key) + "\"", "thresholds by sound have names of their own",
                 base::did_you_mean(key, names, "See `stridor classify --help`.")},
                base::Place{"--set", 0, 0, ""});
}

}  // namespace

std::span<const SoundThreshold> sound_thresholds() {
    return threshold_table;
}

bool is_sound_threshold(std::string_view assignment) {
    return base::find_named(threshold_table, assignment.substr(0, assignment.find('='))) != nullptr;
}

void set_sound_threshold(SoundThresholds& thresholds, std::string_view assignment) {
    const base::Place place{"--set", 0, 0, std::string(assignment)};
    const auto sign = assignment.find('=');
    if (sign == std::string_view::npos)
        throw Error(ErrorKind::input,
                    {"\"" + std::string(assignment) + "\" sets nothing", "it has no =", "Write --set certainty=0.6"},
                    place);
    const std::string_view key = base::trimmed(assignment.substr(0, sign));
    const SoundThreshold* found = base::find_named(threshold_table, key);
    if (found == nullptr) refuse_key(key);
    double value = 0.0;
    try {
        value = threshold_value(assignment.substr(sign + 1), found->unit);
    } catch (const Error& error) {
        throw Error(error.kind(), error.problem(), place);
    }
    if (!(value >= found->range.low && value <= found->range.high))
        throw Error(
            ErrorKind::input,
            {std::string(key) + " = " + base::shortest(value) + " is out of range",
             "it must lie between " + base::shortest(found->range.low) + " and " + base::shortest(found->range.high),
             ""},
            place);
    thresholds.*(found->member) = value;
}

}  // namespace stridor::parameters
