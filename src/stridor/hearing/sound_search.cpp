#include "stridor/hearing/sound_search.hpp"

#include "stridor/base/error.hpp"
#include "stridor/crew/crew.hpp"
#include "stridor/hearing/hearing_run.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/sweep/store/store.hpp"
#include "stridor/sweep/study_work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace stridor::hearing {

namespace {

constexpr std::size_t least_front = 12;  // [1] best cells whose neighbours are looked at

// 0, stride, 2 stride, ..., and the last point
std::vector<int> grid_points(int points, int stride) {
    std::vector<int> indices;
    for (int index = 0; index < points - 1; index += stride)
        indices.push_back(index);
    indices.push_back(points - 1);
    return indices;
}

crew::Work listening_work(const sweep::Study& study, const CellListening& listening) {
    const auto compute = [&study, &listening](const crew::Task& task, const std::stop_token& stop,
                                              integration::Workspace& workspace) -> std::optional<std::string> {
        const std::optional<CellSound> sound = sound_of_cell(study, task.number, listening, stop, workspace);
        return sound ? std::optional(packed(*sound)) : std::nullopt;
    };
    return sweep::simulating_work(listening_text(study, listening), compute);
}

class Search {
public:
    Search(const sweep::Study& study, const classification::SoundProfile& recording, const CellListening& listening,
           const SoundSearch& options)
        : study_(study),
          recording_(recording),
          options_(options),
          is_taken_(options.ruled_out),
          crew_(options.crew(listening_work(study, listening), options.stop)) {
        is_taken_.resize(sweep::cell_count(study), false);
    }

    SoundSearchResult result() && {
        int stride = first_stride();
        std::vector<std::size_t> asked = grid(stride);
        while (!asked.empty() && !options_.stop.stop_requested()) {
            listen(asked);
            stride = std::max(1, stride / 2);
            asked = neighbours(stride);
            // nothing new at this distance: nearer still
            while (asked.empty() && stride > 1) {
                stride /= 2;
                asked = neighbours(stride);
            }
        }
        SoundSearchResult result;
        result.heard = done_;
        result.without_result = without_result_;
        result.ruled_out =
            static_cast<std::size_t>(std::count(options_.ruled_out.begin(), options_.ruled_out.end(), true));
        result.is_stopped = options_.stop.stop_requested();
        known_.resize(std::min(known_.size(), options_.keep));
        result.best = std::move(known_);
        return result;
    }

private:
    const sweep::Study& study_;
    const classification::SoundProfile& recording_;
    const SoundSearch& options_;
    std::vector<bool> is_taken_;       // listened to, asked for or ruled out
    std::vector<SoundMatch> known_{};  // nearest first; as many as anyone will ask for
    std::size_t done_ = 0;
    std::size_t kept_ = 0;  // of these, by an earlier run
    std::size_t asked_ = 0;
    std::size_t without_result_ = 0;
    std::unique_ptr<crew::Crew> crew_;

    std::size_t front() const { return std::max(least_front, options_.keep); }

    int first_stride() const {
        int stride = 1;
        if (options_.extent == SearchExtent::every) return stride;
        const auto cells = [&] {
            return grid_points(study_.x.points, stride).size() * grid_points(study_.y.points, stride).size() *
                   study_.directions.size();
        };
        while (cells() > options_.first_grid && stride < sweep::most_points)
            stride *= 2;
        return stride;
    }

    void ask(std::vector<std::size_t>& asked, const sweep::CellPlace& place) {
        const std::size_t index = sweep::index_of(study_, place);
        if (is_taken_[index]) return;
        is_taken_[index] = true;
        asked.push_back(index);
    }

    std::vector<std::size_t> grid(int stride) {
        std::vector<std::size_t> asked;
        for (std::size_t direction = 0; direction < study_.directions.size(); ++direction)
            for (const int iy : grid_points(study_.y.points, stride))
                for (const int ix : grid_points(study_.x.points, stride))
                    ask(asked, {direction, iy, ix, 0});
        return asked;
    }

    std::vector<std::size_t> neighbours(int stride) {
        std::vector<std::size_t> asked;
        for (std::size_t k = 0; k < std::min(front(), known_.size()); ++k) {
            const sweep::CellPlace centre = sweep::place_of(study_, known_[k].cell.index);
            for (const int dy : {-stride, 0, stride})
                for (const int dx : {-stride, 0, stride})
                    ask(asked, {centre.direction, std::clamp(centre.iy + dy, 0, study_.y.points - 1),
                                std::clamp(centre.ix + dx, 0, study_.x.points - 1), 0});
        }
        return asked;
    }

    // nothing if it was not listened to before
    std::optional<CellSound> kept(std::size_t index) const {
        if (options_.kept == nullptr) return std::nullopt;
        const std::optional<std::string> text = options_.kept->find(index);
        std::optional<CellSound> sound = text ? unpacked_cell_sound(*text) : std::nullopt;
        return sound && sound->index == index ? std::move(sound) : std::nullopt;
    }

    void listen(const std::vector<std::size_t>& asked) {
        asked_ += asked.size();
        std::vector<crew::Task> missing;
        for (const std::size_t index : asked) {
            if (std::optional<CellSound> sound = kept(index)) {
                ++kept_;
                take(std::move(*sound));
            } else {
                missing.push_back({index});
            }
        }
        const auto take_result = [&](crew::Result result) {
            std::optional<CellSound> sound = unpacked_cell_sound(result.bytes);
            if (!sound) throw crew::damaged_result();
            if (options_.kept != nullptr) options_.kept->keep(result.number, std::move(result.bytes));
            take(std::move(*sound));
        };
        crew::compute(*crew_, std::move(missing), take_result, [&] { report(); });
        sort();
    }

    void report() const {
        if (options_.progress) options_.progress({done_, kept_, asked_});
    }

    void take(CellSound sound) {
        ++done_;
        if (sound.status != sweep::Status::done) {
            ++without_result_;
            return;
        }
        classification::Likeness likeness = classification::likeness(recording_, sound.profile, options_.level);
        known_.push_back({std::move(sound), std::move(likeness)});
    }

    void sort() {
        std::sort(known_.begin(), known_.end(), [](const SoundMatch& a, const SoundMatch& b) {
            if (a.likeness.distance != b.likeness.distance) return a.likeness.distance < b.likeness.distance;
            return a.cell.index < b.cell.index;
        });
        known_.resize(std::min(known_.size(), front()));
    }
};

}  // namespace

std::string listening_text(const sweep::Study& study, const CellListening& listening) {
    // a cell sounds as `hear` hears it, without what is done to its sound there
    HearingOptions options;
    options.settings.motion = listening.motion;
    options.settings.sound = listening.sound;
    options.settings.thresholds = listening.thresholds;
    options.perturb_every = 0;
    return "cells\n" + heard_text(study, options);
}

SoundSearchResult search(const sweep::Study& study, const classification::SoundProfile& recording,
                         const CellListening& listening, const SoundSearch& options) {
    return Search(study, recording, listening, options).result();
}

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
