#include "stridor/sweep/store/chart_state.hpp"

#include "stridor/base/error.hpp"
#include "stridor/sweep/refinement.hpp"
#include "stridor/sweep/store/merge.hpp"
#include "stridor/sweep/store/share.hpp"
#include "stridor/sweep/store/store.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace stridor::sweep {

namespace fs = std::filesystem;

namespace {

// what a store holds, into the marks of all cells (shape [cell])
void look_into(StoreState& state, const Study& study, std::vector<int>& marks) {
    if (state.standing == StoreStanding::missing) return;
    state.owner = storage::owner_of(state.file);
    if (state.owner && storage::may_be_alive(*state.owner)) {
        state.standing = StoreStanding::filled;
        state.cells = state.owner->owner.count;
        return;
    }
    try {
        Store store(state.file, study, StoreUse::read);
        if (study.refine == 0) {
            const std::vector<bool> stored = store.stored();
            for (std::size_t index = 0; index < stored.size(); ++index)
                if (stored[index]) marks[index] = 0;
            state.cells = static_cast<std::size_t>(std::count(stored.begin(), stored.end(), true));
        } else
            store.visit(0, marks.size(), [&](const IndexedCell& indexed) {
                marks[indexed.index] = mark_of(study, indexed.cell);
                ++state.cells;
            });
        state.standing = StoreStanding::partial;
    } catch (const Error& error) {
        state.standing = StoreStanding::unreadable;
        state.problem = error.what();
    }
}

// those that are there, and those that the names of the others tell of
std::vector<StoreState> share_states(const fs::path& folder) {
    std::vector<StoreState> states;
    std::map<std::size_t, std::vector<bool>> there;  // by count
    for (const ShareStore& store : share_stores(folder)) {
        StoreState state;
        state.file = store.file;
        state.share = store.share;
        state.standing = StoreStanding::partial;
        states.push_back(std::move(state));
        if (!store.share) continue;
        std::vector<bool>& found = there[store.share->count];
        found.resize(store.share->count);
        found[store.share->index] = true;
    }
    for (const auto& [count, found] : there)
        for (std::size_t index = 0; index < count; ++index) {
            if (found[index]) continue;
            StoreState state;
            state.share = Share{index, count};
            state.file = share_file(folder, *state.share);
            states.push_back(std::move(state));
        }
    const auto order = [](const StoreState& state) {
        const Share share = state.share.value_or(Share{0, most_shares + 1});
        return std::tuple(share.count, share.index, state.file);
    };
    std::sort(states.begin(), states.end(),
              [&](const StoreState& a, const StoreState& b) { return order(a) < order(b); });
    return states;
}

// how many of the missing cells are of which share
void deal_out(const Study& study, const std::vector<int>& marks, const std::vector<std::size_t>& runs,
              std::vector<StoreState>& shares) {
    const std::size_t points = marks.size() / study.directions.size();
    for (StoreState& state : shares) {
        if (!state.share) continue;
        for (const std::size_t run : runs)
            for (std::size_t k = 0; is_in(*state.share, study, run) && k < directions_per_run(study); ++k)
                state.missing += marks[run + k * points] == unknown_mark ? 1 : 0;
    }
}

}  // namespace

ChartState chart_state(const Study& study, const fs::path& folder) {
    ChartState state;
    std::vector<int> marks(cell_count(study), unknown_mark);
    const auto known = [&] {
        return marks.size() - static_cast<std::size_t>(std::count(marks.begin(), marks.end(), unknown_mark));
    };
    state.chart.file = folder / "chart.sqlite";
    if (fs::exists(state.chart.file)) state.chart.standing = StoreStanding::partial;
    look_into(state.chart, study, marks);
    if (state.chart.standing == StoreStanding::partial && refine(study, marks).missing.empty()) {
        state.is_merged = true;
        state.chart.standing = StoreStanding::complete;
    }
    state.shares = share_states(folder);
    for (StoreState& share : state.shares)
        look_into(share, study, marks);
    const std::vector<std::size_t> runs = refine(study, marks).missing;
    const std::size_t points = marks.size() / study.directions.size();
    state.done = known();
    state.total = state.done;
    for (const std::size_t run : runs)
        for (std::size_t k = 0; k < directions_per_run(study); ++k)
            state.total += marks[run + k * points] == unknown_mark ? 1 : 0;
    deal_out(study, marks, runs, state.shares);
    for (StoreState& share : state.shares) {
        if (share.standing == StoreStanding::partial && share.missing == 0) share.standing = StoreStanding::complete;
        if (share.standing == StoreStanding::filled) state.done += std::min(share.cells, share.missing);
    }
    if (state.chart.standing == StoreStanding::filled) state.done = std::max(state.done, state.chart.cells);
    state.total = std::max(state.total, state.done);
    if (!state.is_merged) state.chart.missing = state.total - std::min(state.total, state.chart.cells);
    return state;
}

}  // namespace stridor::sweep
