#pragma once

#include "stridor/storage/owner_file.hpp"
#include "stridor/sweep/store/share.hpp"
#include "stridor/sweep/study.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::sweep {

/// The state of a chart's store.
enum class StoreStanding {
    complete,    // it has all cells that are known to be its
    partial,     // it lacks some, and nobody fills it
    filled,      // somebody fills it at this moment
    missing,     // it was never begun
    unreadable,  // it is damaged, another study's, or in use
};

inline constexpr std::array<std::string_view, 5> standing_names{"complete", "partial", "filled", "missing",
                                                                "unreadable"};

/// A store of a chart: of a share, or the chart's own.
struct StoreState {
    std::filesystem::path file;
    std::optional<Share> share;  // `std::nullopt` for the chart's own, and for another name
    StoreStanding standing = StoreStanding::missing;
    std::size_t cells = 0;                    // [1] in it; of one that is being filled, as its owner told last
    std::size_t missing = 0;                  // [1] cells that are known to be needed in it, and are nowhere
    std::optional<storage::SeenOwner> owner;  // the process that fills it, or died filling it
    std::string problem;                      // why it is unreadable
};

/// The progress of a chart.
struct ChartState {
    std::size_t done = 0;    // [1] cells that are there, in any store
    std::size_t total = 0;   // [1] cells that are known to be needed: all, unless the chart is refined
    bool is_merged = false;  // the chart's own store has all of them
    StoreState chart;
    std::vector<StoreState> shares;  // by count and index, with the missing ones
};

/// Returns the state of a chart's stores in a folder, also of those being filled, and changes nothing.
ChartState chart_state(const Study& study, const std::filesystem::path& folder);

}  // namespace stridor::sweep
