#include "golden/results.hpp"

#include "golden/many_contacts.hpp"
#include "golden/motion_values.hpp"
#include "golden/values.hpp"
#include "stridor/analysis/stability_scan.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/sweep/run.hpp"
#include "stridor/sweep/starts.hpp"
#include "stridor/sweep/store/keeper.hpp"
#include "support/seal_lip.hpp"
#include "support/small_chart.hpp"

#include <fmt/format.h>

#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace stridor::golden {

namespace {

using parameters::Case;
using parameters::DriveKind;
using parameters::Engine;
using parameters::ImpactKind;
using parameters::PaperCase;

enum class Keep { everything, tallies };

// with nothing kept but the tallies, a run under a constant drive may end early
record::Request request_of(const Case& c, Keep keep) {
    record::Request request;
    if (keep == Keep::tallies) return request;
    request.history = record::KeepHistory::yes;
    request.trace = {0.0, c.run.duration, c.run.duration / 100.0};
    return request;
}

Result run(std::string name, const Case& c, integration::InstructionSet set, Keep keep) {
    integration::Workspace workspace;
    workspace.instruction_set = set;
    const integration::Motion motion = integration::simulate(c, request_of(c, keep), {}, workspace);
    Values values;
    add(values, motion);
    add(values, motion.record.histories.front());
    add_motion(values, motion.record.trace);
    add(values, motion.record.trace.contacts.front());
    std::string extract = std::string(integration::reason_names[static_cast<std::size_t>(motion.outcome.reason)]);
    for (const record::Tally& tally : motion.record.phases) {
        add(values, tally.contacts.front());
        add_vibration(values, tally);
        add_ending(values, tally.contacts.front());
        const analysis::Evidence evidence = analysis::evidence(tally, 0);
        const classification::Verdict verdict = classification::classify(evidence, c.verdict);
        add(values, verdict);
        extract += fmt::format("; {} slip {:.6f} stick {:.6f}, {:.3f} dB", classification::name(verdict.category),
                               evidence.rates.slip, evidence.rates.stick, evidence.levels.joint.decibels);
    }
    return {std::move(name), values.text(), std::move(extract)};
}

Case with_engine(Case c, Engine engine) {
    c.run.engine = engine;
    c.run.step = 1e-6;
    return c;
}

// two periods of a column of Table 1
Case column(PaperCase which) {
    Case c = parameters::paper_case(which);
    c.run.duration = c.run.window = 0.4;
    return c;
}

// two joints on one plate, one of them at this angle [deg], for half a second
Case short_joints(double angle) {
    Case c = parameters::two_lips();
    c.joints[1].joint.incidence_angle = angle;
    c.run.duration = 0.5;
    c.run.window = 0.25;
    return c;
}

Case constant_drive(double velocity) {
    Case c = column(PaperCase::squeal);
    c.drive.kind = DriveKind::constant;
    c.drive.velocity = velocity;
    return c;
}

// a stroke that is no sine: there quickly, back slowly
Case sampled_drive() {
    Case c = column(PaperCase::squeak);
    c.drive.kind = DriveKind::sampled;
    for (int k = 0; k <= 80; ++k) {
        const double time = 0.005 * k;
        const double turn = 5.0 * time;
        c.drive.times.push_back(time);
        c.drive.velocities.push_back(0.1 * base::sine_cosine_of_turns(turn).sine +
                                     0.04 * base::sine_cosine_of_turns(2.0 * turn).sine);
    }
    return c;
}

// a contact that opens and closes often
Case bouncing(ImpactKind law) {
    Case c = column(PaperCase::squeak);
    c.contact().impact = law;
    return c;
}

Result chart(std::string name, const sweep::Study& study) {
    auto keeper = std::make_shared<sweep::MemoryKeeper>(study);
    sweep::RunOptions options;
    options.crew = crew::thread_crews(1);
    sweep::run(study, *keeper, options);
    const sweep::SweepResult result = sweep::load(study, keeper);
    Values values;
    for (const sweep::CellVerdict& cell : result.cells) {
        values.add("status", cell.status);
        values.add("category", cell.category);
        values.add("quiet", cell.quiet);
        values.add("agreement", cell.agreement);
        values.add("start", cell.shown_start);
    }
    result.computed->visit(0, result.cells.size(), [&](sweep::IndexedCell& computed) {
        values.add("index", computed.index);
        for (const sweep::CellFigure& figure : sweep::cell_figures())
            values.add(figure.name, figure_of(computed.cell, figure));
        for (const sweep::StartVerdict& start : computed.cell.starts)
            values.add("verdict", sweep::number_of(start));
    });
    std::string extract = fmt::format("{} cells, {} computed:", result.cells.size(), sweep::computed_count(result));
    const sweep::Counts counts = keeper->counts();
    for (std::size_t k = 0; k < counts.categories.size(); ++k)
        extract += fmt::format(" {} {}", counts.categories[k], classification::category_names[k]);
    return {std::move(name), values.text(), std::move(extract)};
}

// 8 by 6 points in two directions
sweep::Study pair() {
    sweep::Study study = sweep::small_study();
    study.base.run.duration = study.base.run.window = 0.3;
    study.x.points = 8;
    study.y.points = 6;
    return study;
}

sweep::Study refined_with_starts() {
    sweep::Study study = pair();
    study.x.points = study.y.points = 9;
    study.refine = 2;
    study.starts = {parameters::Initial::rest, parameters::Initial::stuck};
    return study;
}

Result stability() {
    const analysis::StabilityScan scan = analysis::scan_stability(
        column(PaperCase::squeal), analysis::ScanRange{"contact.kinetic_friction", 0.0, 0.8, 17});
    Values values;
    std::string extract;
    for (const analysis::DirectionScan& direction : scan.directions) {
        for (const analysis::StabilityPoint& point : direction.path.points) {
            values.add("kind", point.stability.kind);
            values.add("normal_force", point.stability.normal_force);
            for (const analysis::Eigenmode& mode : point.stability.modes) {
                values.add("growth", mode.growth);
                values.add("frequency", mode.frequency);
            }
        }
        for (const analysis::StabilityBoundary& boundary : direction.path.boundaries) {
            values.add("boundary", boundary.value);
            extract += fmt::format("{} from mu_d {:.6f} at {:.3f} Hz; ",
                                   analysis::stability_names[static_cast<std::size_t>(boundary.above)], boundary.value,
                                   boundary.frequency);
        }
    }
    return {"stability", values.text(), std::move(extract)};
}

Result sound(integration::InstructionSet set) {
    integration::Workspace workspace;
    workspace.instruction_set = set;
    const Case c = column(PaperCase::squeal);
    sound::AuralisationSettings settings;
    settings.stretches = hearing::heard_stretches(c, parameters::Direction::going);
    const std::optional<hearing::RunSound> heard = hearing::sound_of_run(c, settings, {}, workspace);
    Values values;
    for (const signal::Signal& part : heard->parts)
        values.add("sample", part.samples);
    const hearing::HeardVerdict verdict = hearing::judged(c, heard->parts, {});
    for (const sound::SoundStretch& stretch : verdict.stretches) {
        const sound::SoundFeatures& f = stretch.features;
        for (const double feature :
             {f.duration, f.mean_square, f.peak, f.clearness, f.frequency, f.prominence, f.tonality, f.regularity,
              f.repetition, f.repetition_frequency, f.movement, f.trend, f.unsteadiness, f.abruptness, f.rest,
              f.kurtosis, f.crest, f.impulse_interval, f.impulse_periodicity})
            values.add("feature", feature);
        values.add("impulses", stretch.impulses);
    }
    values.add("share", verdict.verdict.shares);
    std::string extract = fmt::format("{}, {} stretches, {:.3f} Hz", classification::name(verdict.verdict.category),
                                      verdict.stretches.size(), verdict.stretches.front().features.frequency);
    return {"sound", values.text(), std::move(extract)};
}

}  // namespace

std::vector<Result> results(integration::InstructionSet set) {
    std::vector<Result> all;
    const auto add_run = [&](const std::string& name, const Case& c) {
        all.push_back(run(name, c, set, Keep::everything));
    };
    const auto add_early = [&](const std::string& name, const Case& c) {
        all.push_back(run(name, c, set, Keep::tallies));
    };
    const auto add_by_both = [&](const std::string& name, const Case& c) {
        add_run(name + ".exact", with_engine(c, Engine::exact));
        add_run(name + ".beta_2", with_engine(c, Engine::beta_2));
    };
    for (std::size_t k = 0; k < parameters::paper_case_names.size(); ++k)
        add_by_both(std::string(parameters::paper_case_names[k]), column(static_cast<PaperCase>(k)));
    add_by_both("constant.going", constant_drive(0.1));
    add_run("constant.coming", constant_drive(-0.1));
    add_run("constant.lip", support::seal_lip());
    add_early("early.going", constant_drive(0.1));
    add_early("early.coming", constant_drive(-0.1));
    add_early("early.lip", support::seal_lip());
    add_by_both("sampled", sampled_drive());
    add_run("impact.normal-only", bouncing(ImpactKind::normal_only));
    add_run("impact.restitution.exact", bouncing(ImpactKind::restitution));
    add_run("joints.locked", short_joints(60.0));
    add_run("joints.impacts", short_joints(110.0));
    for (Result& result : results_of_many_contacts())
        all.push_back(std::move(result));
    all.push_back(chart("chart.plain", pair()));
    all.push_back(chart("chart.refined", refined_with_starts()));
    all.push_back(stability());
    all.push_back(sound(set));
    return all;
}

}  // namespace stridor::golden
