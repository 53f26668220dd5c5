#include "stridor/hearing/hearing_run.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/packed_bytes.hpp"
#include "stridor/base/text.hpp"
#include "stridor/crew/crew.hpp"
#include "stridor/hearing/heard_recordings.hpp"
#include "stridor/hearing/rendered_sound.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/sound/feature_table.hpp"
#include "stridor/sweep/results_version.hpp"
#include "stridor/sweep/store/store.hpp"
#include "stridor/sweep/study_work.hpp"

#include <array>
#include <chrono>
#include <memory>
#include <utility>

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

using Clock = std::chrono::steady_clock;

// all directions that a run gives; none if it was stopped
std::vector<HeardSound> heard_of_run(const sweep::Study& study, const HearingOptions& options, std::size_t first,
                                     const std::stop_token& stop, integration::Workspace& workspace) {
    const sweep::CellPlace place = sweep::place_of(study, first);
    const std::span directions = std::span(study.directions).subspan(place.direction, sweep::directions_per_run(study));
    HearingSettings settings = options.settings;
    if (options.perturb_every > 0 && first % options.perturb_every == 0) settings.seed = first;
    std::vector<HeardSound> heard = hear(sweep::case_at(study, place), directions, settings, stop, workspace);
    // the same place in one direction after the other
    const std::size_t points = sweep::cell_count(study) / study.directions.size();
    for (std::size_t k = 0; k < heard.size(); ++k)
        heard[k].index = first + k * points;
    return heard;
}

// all cells of a study
class Hearing {
public:
    Hearing(const sweep::Study& study, const HearingOptions& options)
        : study_(study),
          options_(options),
          sounds_(sweep::cell_count(study)) {
        progress_.total = sounds_.size();
        for (const crew::Task& run : crew::numbered_tasks(sounds_.size() / sweep::directions_per_run(study)))
            if (!take_kept(run.number)) missing_.push_back(run);
        known_ = progress_.done;
    }

    // false if it was stopped
    bool compute() {
        const std::unique_ptr<crew::Crew> crew = options_.crew(work_of(study_, options_), options_.stop);
        const auto take = [&](crew::Result result) {
            if (!take_sounds(result.bytes)) throw crew::damaged_result();
            if (options_.kept != nullptr) options_.kept->keep(result.number, std::move(result.bytes));
        };
        crew::compute(*crew, std::move(missing_), take, [&] { report(); });
        return progress_.done == progress_.total;
    }

    std::vector<HeardSound> sounds() && { return std::move(sounds_); }

private:
    using Clock = std::chrono::steady_clock;

    bool take_kept(std::size_t first) {
        const std::optional<std::string> text = options_.kept == nullptr ? std::nullopt : options_.kept->find(first);
        return text && take_sounds(*text);
    }

    // those of one run
    bool take_sounds(std::string_view bytes) {
        std::optional<std::vector<HeardSound>> heard = unpacked_heard_sounds(bytes);
        if (!heard || heard->size() != sweep::directions_per_run(study_)) return false;
        for (HeardSound& sound : *heard) {
            sweep::count(progress_.counts, sweep::verdict_of(sound.cell));
            sounds_.at(sound.index) = std::move(sound);
        }
        progress_.done += heard->size();
        return true;
    }

    void report() {
        const double time = std::chrono::duration<double>(Clock::now() - begin_).count();
        progress_.rate = static_cast<double>(progress_.done - known_) / time;
        if (options_.progress) options_.progress(progress_);
    }

    const sweep::Study& study_;
    const HearingOptions& options_;
    Clock::time_point begin_ = Clock::now();
    sweep::Progress progress_;
    std::size_t known_ = 0;            // [1] of the finished cells, those that were heard before
    std::vector<crew::Task> missing_;  // runs that nobody has heard yet
    std::vector<HeardSound> sounds_;   // shape [cell]
};

classification::RecordingVerdict verdict_on_whole(const parameters::Case& c, const HearingOptions& options) {
    sound::AuralisationSettings settings;
    settings.pickup = heard_motion(c, options.settings.motion, options.stop).pickup;
    settings.rate = options.settings.sound.rate;
    settings.stretches = {{0.0, c.run.duration}};
    const std::unique_ptr<RenderedSound> sound = render(c, settings, options.stop, [](double) {});
    return verdict_on(*sound, options.settings.thresholds);
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

std::string heard_text(const sweep::Study& study, const HearingOptions& options) {
    const HearingSettings& settings = options.settings;
    std::string text = sweep::canonical_text(study);
    const auto add = [&](const std::string& key, double value) {
        text += "heard." + key + " = " + base::shortest(value) + "\n";
    };
    add("results", sweep::results_version);
    text += "heard.of = " + settings.motion.of + " " + settings.motion.component + "\n";
    add("quantity", static_cast<double>(settings.motion.quantity));
    for (const parameters::OwnOutput& output : parameters::outputs_of(study.base)) {
        text += "heard.output = " + output.name + "\n";
        for (const double weight : output.weights)
            add("weight", weight);
    }
    add("rate", settings.sound.rate);
    add("high_pass", settings.sound.high_pass);
    add("fade", settings.sound.fade);
    add("density", settings.sound.density);
    add("perturb_every", static_cast<double>(options.perturb_every));
    for (const parameters::SoundThreshold& threshold : parameters::sound_thresholds())
        add(std::string(threshold.name), settings.thresholds.*threshold.member);
    return text;
}

crew::Work work_of(const sweep::Study& study, const HearingOptions& options) {
    const auto compute = [&study, &options](const crew::Task& task, const std::stop_token& stop,
                                            integration::Workspace& workspace) -> std::optional<std::string> {
        const std::vector<HeardSound> heard = heard_of_run(study, options, task.number, stop, workspace);
        return heard.empty() ? std::nullopt : std::optional(packed(heard));
    };
    return sweep::simulating_work("sounds\n" + heard_text(study, options), compute);
}

std::vector<HeardSound> hear(const sweep::Study& study, const HearingOptions& options) {
    if (!study.starts.empty())
        throw Error(ErrorKind::input, {"the chart has several starts", "a sound is that of one motion",
                                       "Leave chart.starts out; run.initial is the start that is heard."});
    check_audible(study.base, options.settings.sound);
    Hearing hearing(study, options);
    return hearing.compute() ? std::move(hearing).sounds() : std::vector<HeardSound>{};
}

std::vector<HeardCase> hear_table_1(const HearingOptions& options) {
    constexpr std::array directions{parameters::Direction::going, parameters::Direction::coming};
    std::vector<HeardCase> cases;
    integration::Workspace workspace;
    for (std::size_t k = 0; k < parameters::paper_case_names.size(); ++k) {
        const parameters::Case c = parameters::paper_case(static_cast<parameters::PaperCase>(k));
        HeardCase& heard = cases.emplace_back();
        heard.name = parameters::paper_case_names[k];
        heard.phases = hear(c, directions, options.settings, options.stop, workspace);
        if (heard.phases.empty()) throw_stopped("Table 1");
        const classification::RecordingVerdict whole = verdict_on_whole(c, options);
        heard.whole = whole.category;
        heard.reason = whole.reasons.front();
    }
    return cases;
}

void throw_stopped(const std::string& where) {
    throw Error(ErrorKind::interrupted,
                {"stopped in " + where, "the sounds heard so far are kept", "Run the same command again to go on."});
}

}  // namespace stridor::hearing
