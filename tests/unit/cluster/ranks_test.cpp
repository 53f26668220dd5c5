// Sweeps on ranks whose letters are late and mixed, whose members stop, and that are begun anew with other numbers of
// ranks: the cells are those of one process. STRIDOR_CLUSTER_SEEDS=10000 looks further.

#include "stridor/cluster/rank_crew.hpp"
#include "stridor/crew/crew.hpp"
#include "stridor/sweep/run.hpp"
#include "stridor/sweep/store/keeper.hpp"
#include "unit/cluster/network.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace stridor::cluster {
namespace {

std::size_t seeds() {
    const char* asked = std::getenv("STRIDOR_CLUSTER_SEEDS");
    return asked == nullptr ? 200 : std::stoul(asked);
}

// what a sweep in this thread alone keeps
std::vector<IndexedCell> cells_of(const Study& study, sweep::CellKeeper& keeper) {
    std::vector<IndexedCell> cells;
    keeper.visit(0, sweep::cell_count(study), [&](IndexedCell& cell) { cells.push_back(cell); });
    return cells;
}

std::vector<IndexedCell> alone(const Study& study) {
    std::mt19937_64 random(1);
    sweep::MemoryKeeper keeper(study);
    sweep::RunOptions options;
    options.crew = [&](const crew::Work&, const std::stop_token& stop) {
        return std::make_unique<OwnersCrew>(invented_work(study), stop, random, nullptr);
    };
    EXPECT_EQ(sweep::run(study, keeper, options).ending, sweep::SweepEnding::completed);
    return cells_of(study, keeper);
}

// the crew of rank 0
std::unique_ptr<crew::Crew> led_by(Network& network, const std::function<void()>& turn, const crew::Work& work,
                                   const std::stop_token& stop) {
    RankCrewOptions options;
    options.longest_silence = std::chrono::seconds{2};
    options.timing = network.timing(turn);
    options.crew = [&network, turn](const crew::Work& again, const std::stop_token& own) {
        return std::make_unique<OwnersCrew>(again, own, network.random(), turn);
    };
    return std::make_unique<RankCrew>(network.post(0), work, stop, std::move(options));
}

// what may happen to a sweep on its ranks
struct Fate {
    std::size_t turns_to_a_death = 0;  // of one of the hands; 0: none
    std::size_t turns_to_a_stop = 0;   // on request; 0: none
};

enum class Ended { completed, stopped, silent };

// a sweep on ranks of one process
Ended run_on_ranks(const Study& study, sweep::CellKeeper& keeper, Network& network, const Fate& fate) {
    std::stop_source stop;
    std::size_t turns = 0;
    const auto turn = [&] {
        ++turns;
        if (turns == fate.turns_to_a_death && network.hands() > 0) network.kill(network.random()() % network.hands());
        if (turns == fate.turns_to_a_stop) stop.request_stop();
        network.turn();
    };
    sweep::RunOptions options;
    options.stop = stop.get_token();
    options.cells_per_commit = 1 + network.random()() % 50;
    options.crew = [&](const crew::Work&, const std::stop_token& token) {
        return led_by(network, turn, invented_work(study), token);
    };
    try {
        const sweep::RunReport report = sweep::run(study, keeper, options);
        return report.ending == sweep::SweepEnding::completed ? Ended::completed : Ended::stopped;
    } catch (const SilentRank&) {
        return Ended::silent;
    }
}

TEST(Ranks, ComputeTheSameCellsWhateverHappensToThem) {
    std::size_t deaths = 0;
    std::size_t stops = 0;
    for (std::uint64_t seed = 0; seed < seeds(); ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937_64 random(seed);
        const Study study = invented_study(5 + static_cast<int>(random() % 20), static_cast<int>(random() % 4));
        sweep::MemoryKeeper keeper(study);
        Ended ended = Ended::stopped;
        for (int attempts = 0; ended != Ended::completed; ++attempts) {
            ASSERT_LT(attempts, 200);
            Network network({invented_work(study)}, 1 + static_cast<int>(random() % 5), random());
            // sooner or later it is left in peace
            const bool is_disturbed = random() % 3 != 0;
            const Fate fate{is_disturbed ? random() % 60 : 0, is_disturbed ? random() % 1000 : 0};
            ended = run_on_ranks(study, keeper, network, fate);
            deaths += ended == Ended::silent ? 1U : 0U;
            stops += ended == Ended::stopped ? 1U : 0U;
        }
        const std::vector<IndexedCell> expected = alone(study);
        const std::vector<IndexedCell> kept = cells_of(study, keeper);
        ASSERT_EQ(kept.size(), expected.size());
        for (std::size_t k = 0; k < kept.size(); ++k) {
            ASSERT_EQ(kept[k].index, expected[k].index);
            ASSERT_TRUE(sweep::same_cell(kept[k].cell, expected[k].cell)) << kept[k].index;
        }
    }
    EXPECT_GT(deaths, seeds() / 20);
    EXPECT_GT(stops, seeds() / 20);
}

// a result says its work and what the task says
crew::Work named_work(const std::string& name) {
    return {name, [name] {
                return [name](const crew::Task& task, const std::stop_token&) -> std::optional<std::string> {
                    return name + std::to_string(task.number) + task.bytes;
                };
            }};
}

// a command with several works, of which rank 0 leaves some out and gives some up, on ranks that know nothing of that
TEST(Ranks, ServeOneWorkAfterTheOther) {
    std::size_t by_others = 0;
    for (std::uint64_t seed = 0; seed < seeds(); ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        const std::vector<crew::Work> works{named_work("a"), named_work("b"), named_work("c"), named_work("d")};
        Network network(works, 2 + static_cast<int>(seed % 3), seed);
        std::mt19937_64 random(seed);
        for (const crew::Work& work : works) {
            if (random() % 4 == 0) continue;
            std::stop_source stop;
            std::size_t turns_to_a_stop = random() % 4 == 0 ? 1 + random() % 30 : 0;
            const auto turn = [&] {
                if (turns_to_a_stop > 0 && --turns_to_a_stop == 0) stop.request_stop();
                network.turn();
            };
            const std::unique_ptr<crew::Crew> crew = led_by(network, turn, work, stop.get_token());
            // a work may ask for more once it knows what came of what it asked for before
            for (std::size_t count : {40U, 7U, 0U, 25U}) {
                std::vector<crew::Task> tasks = crew::numbered_tasks(count);
                for (crew::Task& task : tasks)
                    task.bytes = "!";
                std::vector<std::string> results(count);
                crew::compute(*crew, std::move(tasks),
                              [&](crew::Result result) { results.at(result.number) = std::move(result.bytes); });
                for (std::size_t k = 0; k < count; ++k) {
                    const bool is_given_up = stop.stop_requested() && results[k].empty();
                    ASSERT_EQ(results[k], is_given_up ? "" : work.text + std::to_string(k) + "!");
                }
            }
        }
        by_others += network.results_of_others();
    }
    EXPECT_GT(by_others, 5 * seeds());
}

}  // namespace
}  // namespace stridor::cluster
