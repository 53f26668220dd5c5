// What Python is measured against: the same work without it. Prints seconds, one number a line: the shortest of many
// runs of the squeal case with its verdicts, then wall and processor time of 10,000 points.

#include "stridor/classification/contact_rules.hpp"
#include "stridor/integration/failure.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/sweep/points.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>

namespace {

using namespace stridor;

double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double shortest_run(const parameters::Case& c) {
    double shortest = 1.0;
    for (int k = 0; k < 1000; ++k) {
        const double start = seconds();
        const integration::Motion motion = integration::simulate(c);
        if (integration::failure(c, motion)) return std::nan("");
        const auto verdicts = classification::classify_phases(motion.record.phases, c.verdict);
        if (verdicts.empty()) return std::nan("");
        shortest = std::min(shortest, seconds() - start);
    }
    return shortest;
}

}  // namespace

int main() {
    const parameters::Case c = parameters::paper_case(parameters::PaperCase::squeal);
    std::printf("%.9f\n", shortest_run(c));
    sweep::DesignPoints points{{c}, {"contact.preload"}, {}};
    for (int k = 0; k < 10000; ++k)
        points.values.push_back(5.0 + 0.05 * k);
    const double start = seconds();
    const std::clock_t cpu = std::clock();
    const std::size_t cells = sweep::evaluate(points, {.crew = crew::thread_crews(2)}).size();
    std::printf("%.9f\n%.9f\n", seconds() - start, static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC);
    return cells == 20000 ? 0 : 1;
}
