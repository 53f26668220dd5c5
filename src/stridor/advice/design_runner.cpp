#include "stridor/advice/design_runner.hpp"

#include "stridor/analysis/evidence.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/packed_bytes.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/crew/compute.hpp"
#include "stridor/parameters/field.hpp"
#include "stridor/sweep/evaluate.hpp"
#include "stridor/sweep/simulating_work.hpp"
#include "stridor/sweep/store/store_layout.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

namespace stridor::advice {

namespace {

using base::Packing;
using base::Unpacking;
using classification::Category;
using parameters::Case;

// a phase that the drive never reaches is undecided, as in a chart's cell
void judge_phase(DesignVerdict& verdict, const integration::Motion& motion, record::Phase phase, const Case& c) {
    const auto& tallies = motion.record.phases;
    const auto found =
        std::find_if(tallies.begin(), tallies.end(), [&](const record::Tally& tally) { return tally.phase == phase; });
    const bool is_there = found != tallies.end();
    const classification::Verdict judged =
        is_there ? classification::classify_phase(*found, c.verdict) : classification::Verdict{};
    verdict.phases.push_back({sweep::Status::done, judged.category});
    verdict.quiet.push_back(judged.quiet);
}

DesignVerdict judged(const DesignSpace& space, const Case& c, const sweep::Attempt& run) {
    DesignVerdict verdict{{}, {}, run.message};
    if (run.status == sweep::Status::done) {
        for (const record::Phase phase : space.phases)
            judge_phase(verdict, run.motion, phase, c);
        return verdict;
    }
    verdict.phases.assign(space.phases.size(), {run.status, Category::undecided});
    verdict.quiet.assign(space.phases.size(), classification::Quiet::no);
    return verdict;
}

std::string packed(const Design& design) {
    Packing packing;
    packing.add(static_cast<std::uint64_t>(design.settings.size()));
    for (const Design::Setting& setting : design.settings) {
        packing.add(setting.key);
        packing.add(setting.value);
    }
    packing.add(static_cast<std::uint64_t>(design.start ? 1 : 0));
    if (design.start) packing.add(*design.start);
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
    if (unpacking.count() == 1) design.start = unpacking.kind<parameters::Initial>(sweep::start_names().size());
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
        packing.add(verdict.quiet[k]);
    }
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
        verdict.quiet.push_back(unpacking.kind<classification::Quiet>(classification::quiet_names.size()));
    }
    if (!unpacking.is_complete()) throw crew::damaged_result();
    return verdict;
}

}  // namespace

crew::Work work_of(const DesignSpace& space) {
    std::string text = "designs\n" + parameters::canonical_text(space.base);
    for (const record::Phase phase : space.phases)
        text += "phase = " + std::to_string(static_cast<int>(phase)) + "\n";
    text += "results = " + std::to_string(sweep::results_version) + "\n";
    const auto compute = [&space](const crew::Task& task, const std::stop_token& stop,
                                  integration::Workspace& workspace) -> std::optional<std::string> {
        const Case c = case_of(space, unpacked_design(task.bytes));
        const std::optional<sweep::Attempt> run = sweep::attempt(c, {}, stop, workspace);
        return run ? std::optional(packed(judged(space, c, *run))) : std::nullopt;
    };
    return sweep::simulating_work(std::move(text), compute);
}

DesignRunner::DesignRunner(const DesignSpace& space, const crew::CrewMaker& crew, const std::stop_token& stop)
    : space_(space),
      crew_(crew(work_of(space), stop)) {}

std::vector<DesignVerdict> DesignRunner::judge(std::span<const Design> designs) {
    std::vector<crew::Task> tasks = crew::numbered_tasks(designs.size());
    for (crew::Task& task : tasks)
        task.bytes = packed(designs[task.number]);
    std::vector<DesignVerdict> verdicts(designs.size());
    std::size_t judged = 0;
    const auto take = [&](const crew::Result& result) {
        verdicts[result.number] = unpacked_verdict(result.bytes);
        ++judged;
    };
    const auto tick = [&] {
        if (progress_) progress_(runs_ + judged);
    };
    crew::compute(*crew_, std::move(tasks), take, tick);
    runs_ += judged;
    if (judged < designs.size())
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

bool is_quiet(const DesignVerdict& verdict) {
    return !verdict.phases.empty() && std::all_of(verdict.phases.begin(), verdict.phases.end(), [](const auto& phase) {
        return phase.status == sweep::Status::done && phase.category == Category::none;
    });
}

bool slips_quietly(const DesignVerdict& verdict) {
    return is_quiet(verdict) &&
           std::all_of(verdict.quiet.begin(), verdict.quiet.end(),
                       [](classification::Quiet quiet) { return quiet == classification::Quiet::slides; });
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
    return verdict.phases[sweep::loudest(verdict.phases)];
}

}  // namespace stridor::advice
