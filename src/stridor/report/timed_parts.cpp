#include "stridor/report/timed_parts.hpp"

#include "stridor/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace stridor::report {

namespace {

// asks for a stop when somebody else does, or when the time is up
class Deadline {
public:
    Deadline(const std::stop_token& asked, PartTime time)
        : relay_(asked, [this] { source_.request_stop(); }),
          watch_([this, time](const std::stop_token& end) {
              std::unique_lock lock(mutex_);
              std::condition_variable_any().wait_for(lock, end, time, [] { return false; });
              if (!end.stop_requested()) source_.request_stop();
          }) {}

    std::stop_token token() const { return source_.get_token(); }

private:
    std::stop_source source_;
    std::stop_callback<std::function<void()>> relay_;
    std::mutex mutex_;
    std::jthread watch_;  // last: ends before what it uses
};

}  // namespace

bool ends_within(PartTime longest, const std::stop_token& asked,
                 const std::function<void(const std::stop_token&)>& part) {
    constexpr PartTime most{1e7};  // so that a clock can count it
    const Deadline deadline(asked, std::clamp(longest, PartTime(0.0), most));
    try {
        part(deadline.token());
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::interrupted || asked.stop_requested()) throw;
        return false;
    }
    return true;
}

namespace {

void chart_within(DesignResults& results, const sweep::Study& study, const sweep::RunOptions& options,
                  PartTime longest) {
    constexpr int least = 4;  // [1] points of an axis; fewer are no chart
    const auto begin = std::chrono::steady_clock::now();
    for (const int part : {4, 2, 1}) {
        sweep::Study coarse = study;
        for (sweep::Axis* axis : {&coarse.x, &coarse.y})
            axis->points = std::min(axis->points, std::max(least, (axis->points + part - 1) / part));
        const PartTime before = std::chrono::steady_clock::now() - begin;
        const bool is_done = ends_within(longest - before, options.stop, [&](const std::stop_token& stop) {
            sweep::RunOptions timed = options;
            timed.stop = stop;
            results.chart = chart_in_memory(coarse, timed);
        });
        const PartTime after = std::chrono::steady_clock::now() - begin;
        if (coarse.x.points == study.x.points && coarse.y.points == study.y.points) break;
        constexpr double growth = 4.0;  // [1] cells of the next one
        if (!is_done || growth * (after - before) > longest - after) break;
    }
    const bool is_whole = results.chart && results.chart->study.x.points == study.x.points &&
                          results.chart->study.y.points == study.y.points;
    if (is_whole) return;
    results.about_chart =
        fmt::format("{} within {:g} s; `stridor chart` takes its time.",
                    results.chart ? "The chart is coarse, to end" : "No chart, however coarse, ended", longest.count());
}

}  // namespace

void add_chart(DesignResults& results, const sweep::Study& study, const sweep::RunOptions& options, PartTime longest) {
    try {
        chart_within(results, study, options, longest);
    } catch (const Error& error) {
        results.about_chart = reason_of(error);
    }
}

void add_advice(DesignResults& results, advice::AdviceOptions options, PartTime longest) {
    try {
        ends_within(longest, options.stop, [&](const std::stop_token& stop) {
            advice::AdviceOptions timed = options;
            timed.stop = stop;
            timed.when_stopped = advice::WhenStopped::kept;
            results.advice = advice::advise(results.design, timed);
        });
    } catch (const Error& error) {
        results.without_advice = reason_of(error);
        return;
    }
    if (!results.advice->stopped_in) return;
    if (options.stop.stop_requested())
        throw Error(ErrorKind::interrupted, {"stopped while advising", "a report keeps nothing", "Run it again."});
    results.without_advice =
        fmt::format("The search for a quieting change did not end within {:g} s; `stridor advise` takes its time.",
                    longest.count());
    results.advice_time = longest;
    const bool has_looked = std::any_of(results.advice->margins.begin(), results.advice->margins.end(),
                                        [](const advice::ParameterMargin& margin) { return margin.scan.size() > 1; });
    if (!has_looked) results.advice.reset();
}

}  // namespace stridor::report
