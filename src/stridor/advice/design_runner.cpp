#include "stridor/advice/design_runner.hpp"

#include "stridor/analysis/evidence.hpp"
#include "stridor/base/error.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/sweep/evaluate.hpp"
#include "stridor/sweep/fork_join.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <exception>
#include <mutex>
#include <optional>
#include <utility>

namespace stridor::advice {

namespace {

namespace tbb = oneapi::tbb;
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

}  // namespace

struct DesignRunner::Threads {
    Threads(int threads, std::stop_token asked)
        : count(threads > 0 ? threads : tbb::info::default_concurrency()),
          control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count)),
          arena(count),
          stop(std::move(asked)) {}

    int count;
    tbb::global_control control;  // as many threads, even beyond the number of processors
    tbb::task_arena arena;
    tbb::enumerable_thread_specific<integration::Workspace> workspaces{};
    std::stop_token stop;
    std::function<void(std::size_t)> progress{};
    std::size_t runs = 0;

    // the runs first <= k < last; what one throws comes out here
    void judge(const DesignSpace& space, std::span<const Case> cases, std::vector<DesignVerdict>& verdicts,
               std::size_t first, std::size_t last) {
        std::mutex mutex;
        std::exception_ptr failure;
        using IndexRange = tbb::blocked_range<std::size_t>;
        const sweep::ForkJoin all;
        const auto judge_range = [&](const IndexRange& range) {
            const sweep::ForkJoin::Task task;
            for (std::size_t k = range.begin(); k < range.end() && !stop.stop_requested(); ++k) {
                try {
                    const std::optional<sweep::Attempt> run = sweep::attempt(cases[k], {}, stop, workspaces.local());
                    if (run) verdicts[k] = judged(space, cases[k], *run);
                } catch (...) {
                    // kept here: TBB drops an exception that comes after another
                    const std::lock_guard lock(mutex);
                    if (!failure) failure = std::current_exception();
                }
            }
        };
        arena.execute([&] { tbb::parallel_for(IndexRange(first, last, 1), judge_range, tbb::simple_partitioner()); });
        all.join();
        if (failure) std::rethrow_exception(failure);
        if (stop.stop_requested())
            throw Error(ErrorKind::interrupted,
                        {"stopped after " + std::to_string(runs) + " runs", "advice keeps nothing", "Run it again."});
        runs += last - first;
        if (progress) progress(runs);
    }
};

DesignRunner::DesignRunner(int threads, std::stop_token stop)
    : threads_(std::make_unique<Threads>(threads, std::move(stop))) {}

DesignRunner::~DesignRunner() = default;

std::vector<DesignVerdict> DesignRunner::judge(const DesignSpace& space, std::span<const Case> cases) {
    std::vector<DesignVerdict> verdicts(cases.size());
    // so many between two signs of life that waiting for the last of them costs little
    const auto block = static_cast<std::size_t>(16 * threads_->count);
    for (std::size_t first = 0; first < cases.size(); first += block)
        threads_->judge(space, cases, verdicts, first, std::min(cases.size(), first + block));
    return verdicts;
}

std::vector<DesignVerdict> DesignRunner::judge(const DesignSpace& space, std::span<const Shares> designs) {
    std::vector<Case> cases;
    cases.reserve(designs.size());
    for (const Shares& shares : designs)
        cases.push_back(design_at(space, shares));
    return judge(space, cases);
}

void DesignRunner::on_progress(std::function<void(std::size_t)> progress) {
    threads_->progress = std::move(progress);
}

std::size_t DesignRunner::runs() const {
    return threads_->runs;
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
