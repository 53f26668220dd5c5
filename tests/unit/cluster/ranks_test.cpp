// Sweeps on ranks whose letters are late and mixed, whose members stop, and that are begun anew with other numbers of
// ranks: the cells are those of one process. STRIDOR_CLUSTER_SEEDS=10000 looks further.

#include "stridor/cluster/rank_crew.hpp"
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
    options.crew = [&](const Study& of, const std::stop_token& stop) {
        return std::make_unique<InventedCrew>(of, stop, random, nullptr);
    };
    EXPECT_EQ(sweep::run(study, keeper, options).ending, sweep::SweepEnding::completed);
    return cells_of(study, keeper);
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
    options.crew = [&](const Study& of, const std::stop_token& token) {
        RankCrewOptions crew;
        crew.longest_silence = std::chrono::seconds{2};
        crew.timing = network.timing(turn);
        crew.crew = [&](const Study& again, const std::stop_token& own) {
            return std::make_unique<InventedCrew>(again, own, network.random(), turn);
        };
        return std::make_unique<RankCrew>(network.post(0), of, token, std::move(crew));
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
            Network network(study, 1 + static_cast<int>(random() % 5), random());
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

}  // namespace
}  // namespace stridor::cluster
