#include "stridor/sound/tracks.hpp"

#include "stridor/base/elementary.hpp"

#include <algorithm>
#include <cmath>

namespace stridor::sound {

namespace {

constexpr double heard_depth = 20.0;  // [dB] below the greatest level, as in `Onsets::sounding`

bool is_heard(const signal::LevelHistory& level, double time) {
    if (level.decibels.empty()) return true;
    const std::size_t place = base::whole_below(time / level.interval, level.decibels.size() - 1);
    return level.decibels[place] >= level.greatest - heard_depth;
}

// which of `most` equal moments an instant lies in
std::size_t moment_of(double time, double duration, std::size_t most) {
    return base::whole_below(time / duration * static_cast<double>(most), most - 1);
}

}  // namespace

std::vector<TonePoint> pitch_track(const SoundAnalysis& channel, std::size_t most) {
    std::vector<TonePoint> all;
    for (const Passage& passage : channel.passages)
        for (const TonePoint& point : passage.tones.pitch)
            if (is_heard(channel.level, point.time)) all.push_back(point);
    if (all.size() <= most) return all;
    std::vector<TonePoint> kept;
    for (auto first = all.begin(); first != all.end();) {
        const std::size_t moment = moment_of(first->time, channel.duration, most);
        const auto last = std::find_if(
            first, all.end(), [&](const TonePoint& p) { return moment_of(p.time, channel.duration, most) != moment; });
        const auto middle = first + (last - first) / 2;
        std::nth_element(first, middle, last,
                         [](const TonePoint& a, const TonePoint& b) { return a.frequency < b.frequency; });
        kept.push_back(*middle);
        first = last;
    }
    return kept;
}

std::vector<double> onset_track(const SoundAnalysis& channel, std::size_t most) {
    std::vector<double> all;
    for (const Passage& passage : channel.passages)
        all.insert(all.end(), passage.onsets.instants.begin(), passage.onsets.instants.end());
    if (all.size() <= most) return all;
    std::vector<double> kept;
    for (const double instant : all)
        if (kept.empty() ||
            moment_of(instant, channel.duration, most) != moment_of(kept.back(), channel.duration, most))
            kept.push_back(instant);
    return kept;
}

}  // namespace stridor::sound
