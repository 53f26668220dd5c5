#include "stridor/sweep/cell_sound.hpp"

#include "stridor/analysis/evidence.hpp"
#include "stridor/base/error.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/classification/sound_rules.hpp"
#include "stridor/parameters/check.hpp"
#include "stridor/signal/sound_analysis.hpp"

#include <utility>

namespace stridor::sweep {

namespace {

using integration::Reason;
using parameters::Case;
using parameters::Direction;
using parameters::DriveKind;
using record::Phase;

Phase phase_of(const Case& c, Direction direction) {
    if (c.drive.kind == DriveKind::constant) return Phase::all;
    return direction == Direction::going ? Phase::going : Phase::coming;
}

Status status_of(Reason reason) {
    switch (reason) {
        case Reason::step_limit:
            return Status::step_limit;
        case Reason::diverged:
            return Status::diverged;
        case Reason::chattering:
            return Status::failed;
        case Reason::completed:
        case Reason::settled:
        case Reason::cancelled:
            break;
    }
    return Status::done;
}

classification::Category contact_verdict(const Case& c, Phase phase, const record::Record& record) {
    for (const record::Tally& tally : record.phases)
        if (tally.phase == phase) return classification::classify(analysis::evidence(tally), c.verdict).category;
    return classification::Category::undecided;
}

integration::Motion rendered(const Case& c, const signal::AuralisationSettings& settings,
                             signal::ChannelAnalyser& analyser, const std::stop_token& stop,
                             integration::Workspace& workspace) {
    signal::Auralisation auralisation(settings);
    record::Request request;
    request.trace = auralisation.request(c.run.duration, [&](std::span<const double> block) { analyser.push(block); });
    integration::Motion motion = integration::simulate(c, request, stop, workspace);
    if (integration::has_result(motion.outcome)) analyser.push(auralisation.finish());
    return motion;
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
    const auto ended = [&](Status status, std::string message) {
        sound.status = status;
        sound.message = std::move(message);
        return sound;
    };
    const std::vector<parameters::Finding> findings = parameters::findings(c);
    if (!findings.empty()) return ended(Status::invalid, Error(ErrorKind::input, findings.front().problem).what());
    signal::AuralisationSettings settings = listening.sound;
    settings.stretches = heard_stretches(c, direction);
    if (settings.stretches.empty()) return ended(Status::invalid, "the drive never moves that way in the window");
    signal::ChannelAnalyser analyser(settings.rate, {"", signal::unit_of(settings.pickup.quantity)});
    try {
        const integration::Motion motion = rendered(c, settings, analyser, stop, workspace);
        if (motion.outcome.reason == Reason::cancelled) return std::nullopt;
        if (!integration::has_result(motion.outcome))
            return ended(status_of(motion.outcome.reason),
                         std::string(integration::reason_names[static_cast<std::size_t>(motion.outcome.reason)]));
        sound.contact = contact_verdict(c, phase_of(c, direction), motion.record);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::numerical) throw;
        return ended(Status::failed, error.what());
    }
    signal::SoundAnalysis analysis = analyser.finish();
    if (analysis.peak < least_motion) analysis.stretches.clear();
    const classification::RecordingVerdict verdict =
        classification::classify_recording(analysis.stretches, listening.thresholds);
    sound.status = Status::done;
    sound.heard = analysis.stretches.empty() ? classification::Category::none : verdict.category;
    sound.profile = classification::profile_of(analysis.stretches, verdict, listening.thresholds);
    return sound;
}

}  // namespace stridor::sweep
