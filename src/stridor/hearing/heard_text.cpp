#include "stridor/hearing/heard_text.hpp"

#include "stridor/base/packed_bytes.hpp"
#include "stridor/sound/feature_table.hpp"

namespace stridor::hearing {

namespace {

using base::Packing;
using base::Unpacking;
using sound::SoundFeatures;

constexpr std::size_t categories = classification::category_names.size();

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
    packing.add(sound.cell.status);
    packing.add(sound.cell.category);
    packing.add(sound.cell.quiet);
    packing.add(sound.cell.message);
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        packing.add(figure_of(sound.cell, figure));
    packing.add(sound.heard);
    add(packing, sound.features);
    packing.add(sound.reason);
    packing.add(static_cast<std::uint64_t>(sound.perturbed.size()));
    for (const classification::Category category : sound.perturbed)
        packing.add(category);
}

bool read(Unpacking& unpacking, HeardSound& sound) {
    using classification::Category;
    sound.index = unpacking.count();
    sound.cell.status = unpacking.kind<sweep::Status>(sweep::status_names.size());
    sound.cell.category = unpacking.kind<Category>(categories);
    sound.cell.quiet = unpacking.kind<classification::Quiet>(classification::quiet_names.size());
    sound.cell.message = unpacking.words();
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        set_figure(sound.cell, figure, unpacking.number());
    sound.heard = unpacking.kind<Category>(categories);
    sound.features = features_in(unpacking);
    sound.reason = unpacking.words();
    const std::uint64_t perturbed = unpacking.count();
    if (perturbed != 0 && perturbed != perturbations().size()) return false;
    for (std::uint64_t left = perturbed; left > 0; --left)
        sound.perturbed.push_back(unpacking.kind<Category>(categories));
    return unpacking.is_good();
}

}  // namespace

std::string packed(const CellSound& sound) {
    Packing packing;
    packing.add(static_cast<std::uint64_t>(sound.index));
    packing.add(sound.status);
    packing.add(sound.message);
    packing.add(sound.contact);
    packing.add(sound.heard);
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
    using classification::Category;
    Unpacking unpacking(text);
    CellSound sound;
    sound.index = unpacking.count();
    sound.status = unpacking.kind<sweep::Status>(sweep::status_names.size());
    sound.message = unpacking.words();
    sound.contact = unpacking.kind<Category>(categories);
    sound.heard = unpacking.kind<Category>(categories);
    sound.profile.features = features_in(unpacking);
    sound.profile.impulse_interval = unpacking.number();
    sound.profile.impulse_regularity = unpacking.number();
    return unpacking.is_complete() ? std::optional(std::move(sound)) : std::nullopt;
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
