#include "stridor/sweep/cell_sound.hpp"

#include "stridor/classification/sound_rules.hpp"
#include "stridor/signal/sound_analysis.hpp"
#include "stridor/sweep/evaluate.hpp"

namespace stridor::sweep {

namespace {

using parameters::Case;
using parameters::Direction;
using parameters::DriveKind;
using record::Phase;

Phase phase_of(const Case& c, Direction direction) {
    if (c.drive.kind == DriveKind::constant) return Phase::all;
    return direction == Direction::going ? Phase::going : Phase::coming;
}

}  // namespace

std::vector<signal::Stretch> heard_stretches(const Case& c, Direction direction) {
    return signal::stretches_of(record::schedule(c), phase_of(c, direction), record::Use::counted);
}

std::optional<CellSound> sound_of_cell(const Study& study, std::size_t index, const CellListening& listening,
                                       const std::stop_token& stop, integration::Workspace& workspace) {
    const CellPlace place = place_of(study, index);
    const Case c = case_at(study, place);
    const Direction direction = study.directions[place.direction];
    CellSound sound;
    sound.index = index;
    signal::AuralisationSettings settings = listening.sound;
    settings.stretches = heard_stretches(c, direction);
    if (settings.stretches.empty()) {
        sound.status = Status::invalid;
        sound.message = "the drive never moves that way in the window";
        return sound;
    }
    signal::ChannelAnalyser analyser(settings.rate, {"", signal::unit_of(settings.pickup.quantity)});
    signal::Auralisation auralisation(settings);
    const auto hear = [&](std::span<const double> block) { analyser.push(block); };
    record::Request request;
    request.trace = auralisation.request(c.run.duration, hear);
    const std::optional<Attempt> run = attempt(c, request, stop, workspace);
    if (!run) return std::nullopt;
    const Cell cell = cell_of(c, direction, *run);
    sound.status = cell.status;
    sound.message = cell.message;
    if (cell.status != Status::done) return sound;
    sound.contact = cell.category;
    hear(auralisation.finish());
    signal::SoundAnalysis analysis = analyser.finish();
    if (analysis.peak < least_motion) analysis.stretches.clear();
    const classification::RecordingVerdict verdict =
        classification::classify_recording(analysis.stretches, listening.thresholds);
    sound.heard = analysis.stretches.empty() ? classification::Category::none : verdict.category;
    sound.profile = classification::profile_of(analysis.stretches, verdict, listening.thresholds);
    return sound;
}

}  // namespace stridor::sweep
