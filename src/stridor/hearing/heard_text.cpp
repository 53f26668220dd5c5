#include "stridor/hearing/heard_text.hpp"

#include "stridor/base/packed_text.hpp"
#include "stridor/sound/feature_table.hpp"

namespace stridor::hearing {

namespace {

using base::Packing;
using base::Unpacking;
using sound::SoundFeatures;

template <typename Enumeration>
void add(Packing& packing, Enumeration value) {
    packing.add(static_cast<std::uint64_t>(value));
}

// a value of an enumeration with so many names
template <typename Enumeration, typename Names>
bool read(Unpacking& unpacking, const Names& names, Enumeration& value) {
    const std::uint64_t number = unpacking.count();
    value = static_cast<Enumeration>(number);
    return number < names.size();
}

void add(Packing& packing, const SoundFeatures& features) {
    for (const double value : {features.from, features.duration, features.mean_square, features.peak})
        packing.add(value);
    for (const sound::SoundFeature& feature : sound::feature_table)
        packing.add(features.*feature.member);
    packing.add(static_cast<std::uint64_t>(features.impulses));
}

SoundFeatures features_in(Unpacking& unpacking) {
    SoundFeatures features;
    for (double* value : {&features.from, &features.duration, &features.mean_square, &features.peak})
        *value = unpacking.number();
    for (const sound::SoundFeature& feature : sound::feature_table)
        features.*feature.member = unpacking.number();
    features.impulses = unpacking.count();
    return features;
}

void add(Packing& packing, const HeardSound& sound) {
    packing.add(static_cast<std::uint64_t>(sound.index));
    add(packing, sound.cell.status);
    add(packing, sound.cell.category);
    add(packing, sound.cell.quiet);
    packing.add(sound.cell.message);
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        packing.add(figure_of(sound.cell, figure));
    add(packing, sound.heard);
    add(packing, sound.features);
    packing.add(sound.reason);
    packing.add(static_cast<std::uint64_t>(sound.perturbed.size()));
    for (const classification::Category category : sound.perturbed)
        add(packing, category);
}

bool read(Unpacking& unpacking, HeardSound& sound) {
    using classification::category_names;
    sound.index = unpacking.count();
    bool is_good = read(unpacking, sweep::status_names, sound.cell.status);
    is_good = read(unpacking, category_names, sound.cell.category) && is_good;
    is_good = read(unpacking, classification::quiet_names, sound.cell.quiet) && is_good;
    sound.cell.message = unpacking.words();
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        set_figure(sound.cell, figure, unpacking.number());
    is_good = read(unpacking, category_names, sound.heard) && is_good;
    sound.features = features_in(unpacking);
    sound.reason = unpacking.words();
    const std::uint64_t perturbed = unpacking.count();
    if (perturbed != 0 && perturbed != perturbations().size()) return false;
    sound.perturbed.resize(perturbed);
    for (classification::Category& category : sound.perturbed)
        is_good = read(unpacking, category_names, category) && is_good;
    return is_good && unpacking.is_good();
}

}  // namespace

std::string packed(const CellSound& sound) {
    Packing packing;
    packing.add(static_cast<std::uint64_t>(sound.index));
    add(packing, sound.status);
    packing.add(sound.message);
    add(packing, sound.contact);
    add(packing, sound.heard);
    add(packing, sound.profile.features);
    packing.add(sound.profile.impulse_interval);
    packing.add(sound.profile.impulse_regularity);
    return packing.take();
}

std::string packed(std::span<const HeardSound> sounds) {
    Packing packing;
    packing.add(static_cast<std::uint64_t>(sounds.size()));
    for (const HeardSound& sound : sounds)
        add(packing, sound);
    return packing.take();
}

std::optional<CellSound> unpacked_cell_sound(std::string_view text) {
    using classification::category_names;
    Unpacking unpacking(text);
    CellSound sound;
    sound.index = unpacking.count();
    bool is_good = read(unpacking, sweep::status_names, sound.status);
    sound.message = unpacking.words();
    is_good = read(unpacking, category_names, sound.contact) && is_good;
    is_good = read(unpacking, category_names, sound.heard) && is_good;
    sound.profile.features = features_in(unpacking);
    sound.profile.impulse_interval = unpacking.number();
    sound.profile.impulse_regularity = unpacking.number();
    return is_good && unpacking.is_complete() ? std::optional(std::move(sound)) : std::nullopt;
}

std::optional<std::vector<HeardSound>> unpacked_heard_sounds(std::string_view text) {
    Unpacking unpacking(text);
    const std::uint64_t number = unpacking.count();
    if (number > parameters::direction_names.size()) return std::nullopt;
    std::vector<HeardSound> sounds(number);
    for (HeardSound& sound : sounds)
        if (!read(unpacking, sound)) return std::nullopt;
    return unpacking.is_complete() ? std::optional(std::move(sounds)) : std::nullopt;
}

}  // namespace stridor::hearing
