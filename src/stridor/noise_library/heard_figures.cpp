#include "stridor/noise_library/heard_figures.hpp"

#include "stridor/base/quantity.hpp"
#include "stridor/noise_library/field.hpp"
#include "stridor/signal/level.hpp"
#include "stridor/sound/feature_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace stridor::noise_library {

namespace {

using sound::SoundFeatures;

// six digits are more than any recording has, and print the same everywhere
double six_digits(double value) {
    return base::parse_quantity(fmt::format("{:.6g}", value), "1");
}

void add_figure(std::vector<Figure>& figures, const std::string& name, const std::string& unit, double value) {
    if (std::isfinite(value)) figures.push_back({name, unit, six_digits(value)});
}

// of a sound pressure as a whole, in a free field
void add_quality(std::vector<Figure>& figures, const sound::SoundQuality& quality) {
    add_figure(figures, "loudness_5", "sone", quality.loudness_5);
    add_figure(figures, "loudness_greatest", "sone", quality.greatest_loudness);
    add_figure(figures, "sharpness", "acum", quality.sharpness);
    add_figure(figures, "roughness", "asper", quality.roughness);
}

bool has_figure(const Entry& entry, const std::string& name) {
    return std::any_of(entry.figures.begin(), entry.figures.end(),
                       [&](const Figure& figure) { return figure.name == name; });
}

}  // namespace

std::vector<Figure> figures_of(const sound::SoundAnalysis& analysis, const classification::RecordingVerdict& verdict) {
    std::vector<Figure> figures;
    if (const auto& quality = analysis.quality) add_quality(figures, *quality);
    const classification::SoundSegment* segment = verdict.loudest();
    if (segment == nullptr) return figures;
    const std::string& unit = analysis.unit;
    add_figure(figures, level_figure, signal::level_unit(unit),
               signal::level_of(segment->mean_square, signal::reference_of(unit)));
    const SoundFeatures& found = segment->verdict.features;
    if (found.frequency > 0.0) add_figure(figures, frequency_figure, "Hz", found.frequency);
    // silence has no features
    if (!(segment->mean_square > 0.0)) return figures;
    for (const sound::SoundFeature& feature : sound::feature_table)
        if (feature.told != sound::SoundFeature::Told::in_evaluations)
            add_figure(figures, std::string(feature.name), std::string(feature.unit), found.*feature.member);
    if (segment->impulse_interval > 0.0) {
        add_figure(figures, "impulses", "1", static_cast<double>(segment->impulses.size()));
        add_figure(figures, "impulse_interval", "s", segment->impulse_interval);
        add_figure(figures, "impulse_regularity", "1", segment->impulse_regularity);
    }
    return figures;
}

std::vector<Figure> figures_of(const analysis::FrictionFigures& found) {
    std::vector<Figure> figures;
    add_figure(figures, "static_friction", "1", found.static_friction.value);
    add_figure(figures, "kinetic_friction", "1", found.kinetic_friction.value);
    add_figure(figures, "mean_friction", "1", found.mean_friction);
    add_figure(figures, "force_drops", "1", static_cast<double>(found.drops));
    add_figure(figures, "drop_rate", "1/s", found.drop_rate);
    add_figure(figures, "mean_drop", "N", found.mean_drop);
    add_figure(figures, "largest_drop", "N", found.largest_drop);
    return figures;
}

void add_missing(Entry& entry, std::span<const Figure> figures) {
    for (const Figure& figure : figures)
        if (!has_figure(entry, figure.name)) set_figure(entry, figure);
}

}  // namespace stridor::noise_library
