#include "stridor/sound/quality.hpp"

#include "stridor/signal/resample.hpp"
#include "stridor/sound/roughness.hpp"

#include <optional>
#include <vector>

namespace stridor::sound {

namespace {

constexpr double reference_power = 4e-10;  // [Pa²] (20 uPa)²
constexpr double least_power = 1e-12;      // [Pa²] added to what is smoothed (ISO 532-1, 6.3)

signal::ThirdOctaves ratios_of(const signal::ThirdOctaves& powers, double added) {
    signal::ThirdOctaves ratios{};
    for (std::size_t k = 0; k < powers.size(); ++k)
        ratios[k] = (powers[k] + added) / reference_power;
    return ratios;
}

}  // namespace

struct SoundQualityMeter::State {
    State(double the_rate, SoundField the_field) : rate(the_rate), field(the_field), over_time(the_field) {
        if (rate != signal::third_octave_rate) resampler.emplace(signal::rate_ratio(rate, signal::third_octave_rate));
    }

    void take(std::span<const double> pressures) {
        filters.push(pressures,
                     [this](const signal::ThirdOctaves& powers) { over_time.push(ratios_of(powers, least_power)); });
        roughness.push(pressures);
    }

    double rate;
    SoundField field;
    std::optional<signal::Resampler> resampler{};
    signal::ThirdOctaveFilters filters{};
    LoudnessOverTime over_time;
    RoughnessMeter roughness{};
};

SoundQualityMeter::SoundQualityMeter(double rate, SoundField field) : state_(std::make_unique<State>(rate, field)) {}
SoundQualityMeter::~SoundQualityMeter() = default;
SoundQualityMeter::SoundQualityMeter(SoundQualityMeter&&) noexcept = default;
SoundQualityMeter& SoundQualityMeter::operator=(SoundQualityMeter&&) noexcept = default;

void SoundQualityMeter::push(std::span<const double> pressures) {
    if (state_->resampler)
        state_->take(state_->resampler->push(pressures));
    else
        state_->take(pressures);
}

SoundQuality SoundQualityMeter::finish() {
    State& s = *state_;
    if (s.resampler) s.take(s.resampler->finish());
    s.over_time.finish();
    SoundQuality quality;
    quality.field = s.field;
    quality.third_octaves = s.filters.mean_squares();
    for (std::size_t band = 0; band < signal::third_octave_count; ++band)
        if (!holds_third_octave(s.rate, band)) quality.third_octaves[band] = 0.0;
    SpecificLoudness specific{};
    quality.loudness = total_loudness(core_loudness(ratios_of(quality.third_octaves, 0.0), s.field), &specific);
    quality.sharpness = sharpness(specific);
    quality.greatest_loudness = s.over_time.greatest();
    quality.loudness_5 = s.over_time.exceeded(0.05);
    quality.loudness_10 = s.over_time.exceeded(0.10);
    quality.roughness = s.roughness.mean();
    quality.roughness_5 = s.roughness.exceeded(0.05);
    return quality;
}

bool holds_third_octave(double rate, std::size_t band) {
    constexpr double half_band = 1.122018454301963;  // [1] 10^0.05, from the centre to the upper edge
    return signal::third_octave_names[band] * half_band <= 0.5 * rate;
}

}  // namespace stridor::sound
