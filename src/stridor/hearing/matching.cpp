#include "stridor/hearing/matching.hpp"

#include "stridor/base/error.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/sweep/store/store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace stridor::hearing {

using classification::Category;
using classification::ComparedSound;

void require_matchable(const ComparedSound& recording) {
    if (recording.analysis.stretches.empty())
        base::refuse(fmt::format("{} is too short to be matched, {:.3g} s", recording.name, recording.length),
                     "nothing shorter than 20 ms can be described", "");
    if (is_silent(recording.profile))
        base::refuse("nothing can be heard in " + recording.name, "silence sounds like every quiet cell", "");
}

void require_comparable_level(const ComparedSound& recording, signal::MotionQuantity quantity) {
    const std::string unit = sound::unit_of(quantity);
    if (recording.analysis.unit == unit) return;
    base::refuse("the level of " + recording.name + " cannot be compared",
                 "it is in " + recording.analysis.unit + ", the model's motion in " + unit +
                     ": a sound pressure would need a model of radiation",
                 "Leave --with-level out, or choose --quantity.");
}

double matching_rate(const ComparedSound& recording) {
    constexpr double least_rate = 8000.0;   // [Hz]
    constexpr double most_rate = 192000.0;  // [Hz]
    return std::clamp(std::round(recording.rate), least_rate, most_rate);
}

std::vector<bool> ruled_out(const sweep::Study& study, const std::filesystem::path& file, Category heard) {
    if (!std::filesystem::exists(file))
        throw Error(ErrorKind::io, {"there is no store " + file.string(), "", "`stridor chart` makes it."});
    std::vector<bool> cells(sweep::cell_count(study), false);
    sweep::Store store(file, study);
    const bool is_noise = heard == Category::squeal || heard == Category::squeak || heard == Category::creak;
    store.visit(0, cells.size(), [&](sweep::IndexedCell& cell) {
        const bool is_quiet = cell.cell.status == sweep::Status::done && cell.cell.category == Category::none;
        cells[cell.index] = cell.cell.status != sweep::Status::done || (is_noise && is_quiet);
    });
    return cells;
}

SimulatedSound simulated_of(const sweep::Study& study, const SoundMatch& match) {
    const sweep::CellPlace place = sweep::place_of(study, match.cell.index);
    SimulatedSound sound{sweep::case_at(study, place)};
    sound.stretches = heard_stretches(sound.c, study.directions[place.direction]);
    return sound;
}

}  // namespace stridor::hearing
