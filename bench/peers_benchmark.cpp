// Time and accuracy of the engines and of general solvers on the same equations, as Markdown tables.
//
// The four columns of Table 1 at a constant velocity of +-0.1 m/s, started at rest, one simulated second; a small
// chart over the ranges of Figure 8, falling friction, bristles. Errors are differences from the reference of 33 digits
// (tests/support/oracles/quad_reference), which is computed once per case and does not belong to the measurement. Times
// are processor time of the thread, medians of runs.

#include "peers/agreement.hpp"
#include "peers/odeint.hpp"
#include "peers/peer.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/sweep/ready_charts.hpp"
#include "stridor/verification/published.hpp"
#include "support/oracles/quad_reference.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <exception>
#include <fstream>
#include <iterator>
#include <optional>
#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace stridor::peers {
namespace {

using parameters::Case;
using record::ContactHistory;

constexpr double beginning = 0.05;    // [s] before irregular motions have lost their reference
constexpr double enough_time = 0.25;  // [s] of processor time after which no further run is made
constexpr std::size_t least_runs = 3, most_runs = 15;

struct Problem {
    std::string name;
    Case c;
    ContactHistory reference;
    double known_until = 0.0;  // [s] to where two references with unlike steps agree
};

// one peer on one problem
struct Measurement {
    double time = 0.0;             // [s] of the processor per simulated second
    double error = 0.0;            // [1] of the rates, over everything
    double beginning_error = 0.0;  // [1] of the rates, over the beginning
    Agreement agreement;
    std::string failure;  // empty if there was none
};

double processor_time() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Problem with_reference(std::string name, const Case& c) {
    Problem problem{std::move(name), c, support::quad_reference(c).history, c.run.duration};
    support::QuadOptions shorter;
    shorter.step_share = 0.7;
    problem.known_until = agreement(problem.reference, support::quad_reference(c, shorter).history, 1e-9).until;
    return problem;
}

std::vector<Problem> table_1() {
    std::vector<Problem> problems;
    for (std::size_t which = 0; which < parameters::paper_case_names.size(); ++which)
        for (const double velocity : {0.1, -0.1}) {
            Case c = parameters::paper_case(static_cast<parameters::PaperCase>(which));
            c.drive.kind = parameters::DriveKind::constant;
            c.drive.velocity = velocity;
            c.run.duration = c.run.window = 1.0;
            const char* direction = velocity > 0.0 ? " going" : " coming";
            problems.push_back(with_reference(std::string(parameters::paper_case_names[which]) + direction, c));
        }
    return problems;
}

// Figure 8, going, with fewer cells and a shorter time
std::vector<Problem> chart() {
    sweep::Study study = sweep::figure_8();
    study.x.points = study.y.points = 12;
    study.directions = {parameters::Direction::going};
    study.base.run.duration = study.base.run.window = 0.1;
    std::vector<Problem> problems;
    for (std::size_t index = 0; index < sweep::cell_count(study); ++index)
        problems.push_back(with_reference("cell", sweep::case_at(study, sweep::place_of(study, index))));
    return problems;
}

Measurement measure(const Peer& peer, const Problem& problem, std::size_t fewest, std::size_t most) {
    Measurement result;
    ContactHistory found;
    std::vector<double> times;
    try {
        for (double sum = 0.0; times.size() < fewest || (times.size() < most && sum < enough_time);) {
            const double before = processor_time();
            found = peer.run(problem.c);
            times.push_back(processor_time() - before);
            sum += times.back();
        }
    } catch (const std::exception& failure) {
        result.failure = failure.what();
        return result;
    }
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::nth_element(times.begin(), middle, times.end());
    const double duration = problem.c.run.duration;
    result.time = *middle / duration;
    result.error = rate_error(problem.reference, found, duration);
    result.beginning_error = rate_error(problem.reference, found, std::min(beginning, duration));
    result.agreement = agreement(problem.reference, found);
    return result;
}

std::string agreement_text(const Agreement& a, const Problem& problem) {
    std::string text = fmt::format("{}", a.common);
    if (a.missed > 0 || a.extra > 0) text += fmt::format(" (-{} +{})", a.missed, a.extra);
    if (a.parting == Parting::never || a.until >= problem.known_until) return text;
    return text + fmt::format(", {} at {:.0f} ms", a.parting == Parting::drift ? "drift" : "event", 1e3 * a.until);
}

void print_header(const std::vector<Problem>& problems, bool has_mean) {
    std::string names = "| program |", rule = "| --- |";
    for (const Problem& problem : problems) {
        names += " " + problem.name + " |";
        rule += " --- |";
    }
    fmt::print("{}{}\n{}{}\n", names, has_mean ? " mean |" : "", rule, has_mean ? " --- |" : "");
}

using Row = std::vector<Measurement>;

// a table of one number per peer and problem, and their mean over the problems
template <typename Number>
void print_numbers(const std::vector<Peer>& all, const std::vector<Problem>& problems, const std::vector<Row>& rows,
                   Number number, fmt::format_string<double> format) {
    print_header(problems, true);
    for (std::size_t peer = 0; peer < all.size(); ++peer) {
        fmt::print("| {} |", all[peer].name);
        double sum = 0.0;
        for (const Measurement& m : rows[peer]) {
            sum += number(m);
            fmt::print(" {} |", m.failure.empty() ? fmt::format(format, number(m)) : "failed");
        }
        fmt::print(" {} |\n", fmt::format(format, sum / static_cast<double>(problems.size())));
    }
}

void print_agreement(const std::vector<Peer>& all, const std::vector<Problem>& problems, const std::vector<Row>& rows) {
    print_header(problems, false);
    fmt::print("| *changes of state in all* |");
    for (const Problem& problem : problems)
        fmt::print(" {} |", problem.reference.size() - 1);
    fmt::print("\n| *reference known until* |");
    for (const Problem& problem : problems)
        fmt::print(" {:.0f} ms |", 1e3 * problem.known_until);
    fmt::print("\n");
    for (std::size_t peer = 0; peer < all.size(); ++peer) {
        fmt::print("| {} |", all[peer].name);
        for (std::size_t k = 0; k < problems.size(); ++k) {
            const Measurement& m = rows[peer][k];
            fmt::print(" {} |", m.failure.empty() ? agreement_text(m.agreement, problems[k]) : m.failure);
        }
        fmt::print("\n");
    }
}

void compare_on_table_1(const std::vector<Peer>& all) {
    const std::vector<Problem> problems = table_1();
    std::vector<Row> rows;
    for (const Peer& peer : all) {
        rows.emplace_back();
        for (const Problem& problem : problems)
            rows.back().push_back(measure(peer, problem, least_runs, most_runs));
    }
    fmt::print("\n### Processor time per simulated second [ms]\n\n");
    print_numbers(
        all, problems, rows, [](const Measurement& m) { return 1e3 * m.time; }, "{:.3g}");
    fmt::print("\n### Largest error of a rate over 1 s [1]\n\n");
    print_numbers(
        all, problems, rows, [](const Measurement& m) { return m.error; }, "{:.1e}");
    fmt::print("\n### Largest error of a rate over the first 50 ms [1]\n\n");
    print_numbers(
        all, problems, rows, [](const Measurement& m) { return m.beginning_error; }, "{:.1e}");
    fmt::print("\n### Changes of state in common with the reference\n\n");
    print_agreement(all, problems, rows);
}

void compare_on_chart(const std::vector<Peer>& all) {
    const std::vector<Problem> problems = chart();
    fmt::print("\n### A chart of {} cells, 0.1 s each\n\n", problems.size());
    fmt::print(
        "| program | ms per simulated second | mean rate error | cells above 0.01 | missed | extra | parted by event "
        "| failed |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n");
    for (const Peer& peer : all) {
        double time = 0.0, error = 0.0;
        int wrong = 0, missed = 0, extra = 0, parted = 0, failed = 0;
        for (const Problem& problem : problems) {
            const Measurement m = measure(peer, problem, 1, 1);
            time += m.time;
            error += m.error;
            wrong += m.error > 0.01 ? 1 : 0;
            missed += m.agreement.missed;
            extra += m.agreement.extra;
            parted += m.agreement.parting == Parting::event && m.agreement.until < problem.known_until ? 1 : 0;
            failed += m.failure.empty() ? 0 : 1;
        }
        const auto cells = static_cast<double>(problems.size());
        fmt::print("| {} | {:.3g} | {:.1e} | {} | {} | {} | {} | {} |\n", peer.name, 1e3 * time / cells, error / cells,
                   wrong, missed, extra, parted, failed);
    }
}

// the reference is a general solver's with the finest tolerance
Problem with_general_reference(std::string name, const Case& c) {
    const ContactHistory reference = by_odeint(c, 1e-14);
    return {std::move(name), c, reference, agreement(reference, by_odeint(c, 1e-13), 1e-9).until};
}

// the paper's joint with Stribeck's curve, slow to fast
std::vector<Problem> falling_friction() {
    std::vector<Problem> problems;
    for (const double velocity : {0.01, 0.03, 0.1, 0.3}) {
        Case c = parameters::paper_case(parameters::PaperCase::squeak);
        c.contact().friction = parameters::FrictionKind::stribeck;
        c.contact().stribeck_velocity = 0.05;
        c.drive.kind = parameters::DriveKind::constant;
        c.drive.velocity = velocity;
        c.run.initial = parameters::Initial::stuck;
        c.run.duration = c.run.window = 0.25;
        problems.push_back(with_general_reference(fmt::format("joint, {} m/s", velocity), c));
    }
    for (const verification::PublishedSystem& system : verification::published_systems())
        if (system.file == "leine-block.toml")
            problems.push_back(
                with_general_reference("Leine's block", verification::case_of(system, system.numbers.front())));
    return problems;
}

// beta_2 would take minutes for a block, and has no state of the contact
std::vector<Peer> without_steps(const std::vector<Peer>& all) {
    std::vector<Peer> taken;
    std::copy_if(all.begin(), all.end(), std::back_inserter(taken),
                 [](const Peer& peer) { return !peer.name.starts_with("Stridor beta_2"); });
    return taken;
}

// the paper's joint with bristles; a slip below a twentieth of the drive's velocity is told as a stick
std::vector<Problem> bristles() {
    std::vector<Problem> problems;
    for (const double velocity : {0.03, 0.1, 0.3}) {
        Case c = parameters::paper_case(parameters::PaperCase::squeak);
        c.contact().friction = parameters::FrictionKind::lugre;
        c.contact().stribeck_velocity = 0.05;
        c.contact().bristle_stiffness = 2e5;
        c.contact().bristle_damping = 0.2;
        c.contact().viscous_friction = 1.0;
        c.verdict.creep_speed = 0.05 * velocity;
        c.drive.kind = parameters::DriveKind::constant;
        c.drive.velocity = velocity;
        c.run.initial = parameters::Initial::stuck;
        c.run.duration = c.run.window = 0.1;
        problems.push_back(with_general_reference(fmt::format("joint, {} m/s", velocity), c));
    }
    return problems;
}

void compare_on_bristles(const std::vector<Peer>& all) {
    const std::vector<Problem> problems = bristles();
    std::vector<Peer> taken = without_steps(all);
    for (Peer& peer : stiff_peers())
        taken.push_back(std::move(peer));
    std::vector<Row> rows;
    for (const Peer& peer : taken) {
        rows.emplace_back();
        for (const Problem& problem : problems)
            rows.back().push_back(measure(peer, problem, least_runs, most_runs));
    }
    fmt::print("\n### LuGre: processor time per simulated second [ms]\n\n");
    print_numbers(
        taken, problems, rows, [](const Measurement& m) { return 1e3 * m.time; }, "{:.3g}");
    fmt::print("\n### LuGre: largest error of a rate [1]\n\n");
    print_numbers(
        taken, problems, rows, [](const Measurement& m) { return m.error; }, "{:.1e}");
    fmt::print("\n### LuGre: changes of state in common with odeint, rtol 1e-14\n\n");
    print_agreement(taken, problems, rows);
}

void compare_on_falling_friction(const std::vector<Peer>& all) {
    const std::vector<Problem> problems = falling_friction();
    const std::vector<Peer> taken = without_steps(all);
    std::vector<Row> rows;
    for (const Peer& peer : taken) {
        rows.emplace_back();
        for (const Problem& problem : problems)
            rows.back().push_back(measure(peer, problem, least_runs, most_runs));
    }
    fmt::print("\n### Falling friction: processor time per simulated second [ms]\n\n");
    print_numbers(
        taken, problems, rows, [](const Measurement& m) { return 1e3 * m.time; }, "{:.3g}");
    fmt::print("\n### Falling friction: largest error of a rate [1]\n\n");
    print_numbers(
        taken, problems, rows, [](const Measurement& m) { return m.error; }, "{:.1e}");
    fmt::print("\n### Falling friction: changes of state in common with odeint, rtol 1e-14\n\n");
    print_agreement(taken, problems, rows);
}

#ifdef __clang__
constexpr const char* compiler = __VERSION__;
#else
constexpr const char* compiler = "GCC " __VERSION__;
#endif

std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown processor";
}

// `./dev bench --benchmark_filter=REGEX` is meant for Google Benchmark; what it leaves out is left out here
bool is_asked_for(int count, char** arguments) {
    const std::string filter = "--benchmark_filter=";
    for (int k = 1; k < count; ++k) {
        const std::string argument = arguments[k];
        if (argument.starts_with(filter)) return std::regex_search("peers", std::regex(argument.substr(filter.size())));
    }
    return true;
}

}  // namespace
}  // namespace stridor::peers

int main(int count, char** arguments) {
    using namespace stridor::peers;
    if (!is_asked_for(count, arguments)) return 0;
    const std::vector<Peer> all = peers();
    for (const std::string& version : peer_versions())
        fmt::print("- {}\n", version);
    fmt::print("- {}, {}\n", compiler, processor());
    compare_on_table_1(all);
    compare_on_chart(all);
    compare_on_falling_friction(all);
    compare_on_bristles(all);
    return 0;
}
