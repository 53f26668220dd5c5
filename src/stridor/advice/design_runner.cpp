#include "stridor/advice/design_runner.hpp"

#include "stridor/analysis/evidence.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/packed_bytes.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/crew/crew.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/sweep/evaluate.hpp"
#include "stridor/sweep/results_version.hpp"
#include "stridor/sweep/study_work.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

namespace stridor::advice {

namespace {

using base::Packing;
using base::Unpacking;
using classification::Category;
using classification::Quiet;
using parameters::Case;

bool is_worse(const sweep::StartVerdict& a, const sweep::StartVerdict& b) {
    return sweep::worst(std::array{b, a}) == 1;
}

// a phase that the drive never reaches is undecided, as in a chart's cell
sweep::StartVerdict judged_phase(const sweep::Attempt& run, record::Phase phase, const Case& c) {
    if (run.status != sweep::Status::done) return {run.status, Category::undecided};
    const auto& tallies = run.motion.record.phases;
    const auto found = std::find_if(tallies.begin(), tallies.end(), [&](const record::Tally& tally) {
        return tally.phase == phase || tally.phase == record::Phase::all;
    });
    if (found == tallies.end()) return {sweep::Status::done, Category::undecided};
    const classification::Verdict judged = classification::classify_phase(*found, c.verdict);
    return {sweep::Status::done, judged.category, judged.quiet};
}

bool concerns(const DesignRun& run, record::Phase phase) {
    return !run.direction || (*run.direction == parameters::Direction::going) == (phase == record::Phase::going);
}

class Judgement {
public:
    explicit Judgement(const DesignSpace& space) : space_(space), is_known_(space.phases.size(), false) {
        verdict_.phases.resize(space.phases.size());
        verdict_.starts.resize(space.phases.size(), space.base.run.initial);
    }

    // does a run tell anything more?
    bool asks_for(const DesignRun& run) const {
        for (std::size_t k = 0; k < space_.phases.size(); ++k)
            if (concerns(run, space_.phases[k]) && !(is_known_[k] && is_worst(verdict_.phases[k]))) return true;
        return false;
    }

    void take(const DesignRun& run, const Case& c, const sweep::Attempt& attempt) {
        ++verdict_.runs;
        if (verdict_.message.empty()) verdict_.message = attempt.message;
        for (std::size_t k = 0; k < space_.phases.size(); ++k) {
            if (!concerns(run, space_.phases[k])) continue;
            const sweep::StartVerdict found = judged_phase(attempt, space_.phases[k], c);
            if (is_known_[k] && !is_worse(found, verdict_.phases[k])) continue;
            is_known_[k] = true;
            verdict_.phases[k] = found;
            verdict_.starts[k] = run.start;
        }
    }

    DesignVerdict verdict() && {
        if (verdict_.runs == 0) verdict_.message = "it has no steady sliding to start with: the contact digs in";
        return std::move(verdict_);
    }

private:
    static bool is_worst(const sweep::StartVerdict& verdict) {
        return verdict == sweep::StartVerdict{sweep::Status::done, Category::squeal};
    }

    const DesignSpace& space_;
    DesignVerdict verdict_;
    std::vector<bool> is_known_;  // shape [phase]
};

// the verdict of a design by all of its runs; nothing if it was stopped
std::optional<DesignVerdict> judged(const DesignSpace& space, const Case& design, const std::stop_token& stop,
                                    integration::Workspace& workspace) {
    Judgement judgement(space);
    for (const DesignRun& run : space.runs) {
        const Case c = case_of(design, run);
        if (!judgement.asks_for(run) || !sweep::can_begin(c)) continue;
        const std::optional<sweep::Attempt> attempt = sweep::attempt(c, {}, stop, workspace);
        if (!attempt) return std::nullopt;
        judgement.take(run, c, *attempt);
    }
    return std::move(judgement).verdict();
}

std::string packed(const Design& design) {
    Packing packing;
    packing.add(static_cast<std::uint64_t>(design.settings.size()));
    for (const Design::Setting& setting : design.settings) {
        packing.add(setting.key);
        packing.add(setting.value);
    }
    return packing.take();
}

Design unpacked_design(std::string_view bytes) {
    Unpacking unpacking(bytes);
    Design design;
    for (std::uint64_t left = unpacking.count(); left > 0 && unpacking.is_good(); --left) {
        Design::Setting& setting = design.settings.emplace_back();
        setting.key = unpacking.words();
        setting.value = unpacking.number();
    }
    if (!unpacking.is_complete()) throw crew::damaged_result();
    return design;
}

std::string packed(const DesignVerdict& verdict) {
    Packing packing;
    packing.add(verdict.message);
    packing.add(static_cast<std::uint64_t>(verdict.phases.size()));
    for (std::size_t k = 0; k < verdict.phases.size(); ++k) {
        packing.add(verdict.phases[k].status);
        packing.add(verdict.phases[k].category);
        packing.add(verdict.phases[k].quiet);
        packing.add(verdict.starts[k]);
    }
    packing.add(static_cast<std::uint64_t>(verdict.runs));
    return packing.take();
}

DesignVerdict unpacked_verdict(std::string_view bytes) {
    Unpacking unpacking(bytes);
    DesignVerdict verdict;
    verdict.message = unpacking.words();
    for (std::uint64_t left = unpacking.count(); left > 0 && unpacking.is_good(); --left) {
        sweep::StartVerdict& phase = verdict.phases.emplace_back();
        phase.status = unpacking.kind<sweep::Status>(sweep::status_names.size());
        phase.category = unpacking.kind<Category>(classification::category_names.size());
        phase.quiet = unpacking.kind<Quiet>(classification::quiet_names.size());
        verdict.starts.push_back(unpacking.kind<parameters::Initial>(sweep::start_names().size()));
    }
    verdict.runs = unpacking.count();
    if (!unpacking.is_complete()) throw crew::damaged_result();
    return verdict;
}

}  // namespace

crew::Work work_of(const DesignSpace& space) {
    std::string text = "designs\n" + parameters::canonical_text(space.base);
    for (const record::Phase phase : space.phases)
        text += "phase = " + std::to_string(static_cast<int>(phase)) + "\n";
    for (const DesignRun& run : space.runs)
        text += "run = " + std::to_string(run.direction ? static_cast<int>(*run.direction) : -1) + " " +
                std::to_string(static_cast<int>(run.start)) + "\n";
    text += "results = " + std::to_string(sweep::results_version) + "\n";
    const auto compute = [&space](const crew::Task& task, const std::stop_token& stop,
                                  integration::Workspace& workspace) -> std::optional<std::string> {
        const Case c = case_of(space, unpacked_design(task.bytes));
        const std::optional<DesignVerdict> verdict = judged(space, c, stop, workspace);
        return verdict ? std::optional(packed(*verdict)) : std::nullopt;
    };
    return sweep::simulating_work(std::move(text), compute);
}

DesignRunner::DesignRunner(const DesignSpace& space, const crew::CrewMaker& crew, const std::stop_token& stop)
    : space_(space),
      crew_(crew(work_of(space), stop)) {}

std::vector<DesignVerdict> DesignRunner::judge(std::span<const Design> designs) {
    std::vector<crew::Task> tasks = crew::numbered_tasks(designs.size());
    for (crew::Task& task : tasks) {
        Design design{first_};
        const std::vector<Design::Setting>& own = designs[task.number].settings;
        design.settings.insert(design.settings.end(), own.begin(), own.end());
        task.bytes = packed(design);
    }
    std::vector<DesignVerdict> verdicts(designs.size());
    std::size_t known = 0;
    const auto take = [&](const crew::Result& result) {
        verdicts[result.number] = unpacked_verdict(result.bytes);
        runs_ += verdicts[result.number].runs;
        ++known;
    };
    const auto tick = [&] {
        if (progress_) progress_(runs_);
    };
    crew::compute(*crew_, std::move(tasks), take, tick);
    if (known < designs.size())
        throw Error(ErrorKind::interrupted,
                    {"stopped after " + std::to_string(runs_) + " runs", "advice keeps nothing", "Run it again."});
    return verdicts;
}

std::vector<DesignVerdict> DesignRunner::judge(std::span<const Shares> points) {
    std::vector<Design> designs;
    designs.reserve(points.size());
    for (const Shares& shares : points)
        designs.push_back(design_at(space_, shares));
    return judge(designs);
}

void DesignRunner::on_progress(std::function<void(std::size_t)> progress) {
    progress_ = std::move(progress);
}

bool are_alike(const DesignVerdict& a, const DesignVerdict& b) {
    return std::equal(a.phases.begin(), a.phases.end(), b.phases.begin(), b.phases.end(),
                      [](const sweep::StartVerdict& x, const sweep::StartVerdict& y) {
                          return sweep::number_of(x) == sweep::number_of(y);
                      });
}

bool is_quiet_phase(const DesignVerdict& verdict, std::size_t phase) {
    const Quiet quiet = verdict.phases[phase].quiet;
    return quiet == Quiet::slides || quiet == Quiet::sticks;
}

bool is_quiet(const DesignVerdict& verdict) {
    for (std::size_t k = 0; k < verdict.phases.size(); ++k)
        if (!is_quiet_phase(verdict, k)) return false;
    return !verdict.phases.empty();
}

bool slips_quietly(const DesignVerdict& verdict) {
    return is_quiet(verdict) && std::all_of(verdict.phases.begin(), verdict.phases.end(),
                                            [](const auto& phase) { return phase.quiet == Quiet::slides; });
}

bool is_noisy(const DesignVerdict& verdict) {
    return std::any_of(verdict.phases.begin(), verdict.phases.end(), [](const auto& phase) {
        return phase.status == sweep::Status::done && phase.category != Category::none &&
               phase.category != Category::undecided;
    });
}

bool is_invalid(const DesignVerdict& verdict) {
    return std::any_of(verdict.phases.begin(), verdict.phases.end(),
                       [](const auto& phase) { return phase.status == sweep::Status::invalid; });
}

sweep::StartVerdict overall(const DesignVerdict& verdict) {
    return verdict.phases[sweep::worst(verdict.phases)];
}

}  // namespace stridor::advice
