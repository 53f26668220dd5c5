#include "stridor/pictures/parts/cell_kinds.hpp"

#include "stridor/drawing/palette.hpp"
#include "stridor/pictures/parts/category_colours.hpp"

#include <algorithm>
#include <array>

namespace stridor::pictures {

namespace {

using classification::Category;
using classification::Quiet;

constexpr std::array all_categories{Category::none, Category::squeak, Category::squeal, Category::creak,
                                    Category::undecided};
constexpr std::size_t stuck_kind = all_categories.size();  // quiet because it sticks
constexpr std::size_t locked_kind = stuck_kind + 1;        // silent, too, and no quiet design
constexpr std::size_t failed_kind = locked_kind + 1;

}  // namespace

std::size_t kind_of(const sweep::CellVerdict& cell) {
    if (cell.status != sweep::Status::done) return failed_kind;
    if (cell.quiet == Quiet::sticks) return stuck_kind;
    if (cell.quiet == Quiet::locks) return locked_kind;
    const auto* const found = std::find(all_categories.begin(), all_categories.end(), cell.category);
    return static_cast<std::size_t>(found - all_categories.begin());
}

std::vector<drawing::Fill> kind_fills() {
    std::vector<drawing::Fill> fills;
    for (const Category category : all_categories)
        fills.push_back(category_fill(category));
    fills.push_back(stuck_fill());
    fills.push_back(locked_fill());
    fills.push_back(failed_fill());
    return fills;
}

std::vector<drawing::StyledText> kind_names() {
    std::vector<drawing::StyledText> names;
    for (const Category category : all_categories)
        names.emplace_back(classification::name(category));
    names.emplace_back("none (sticks)");
    names.emplace_back("locks");
    names.emplace_back("failed");
    return names;
}

std::string failure_words(const sweep::SweepResult& result) {
    std::string list;
    for (std::size_t status = 1; status < sweep::status_names.size(); ++status) {
        const bool occurs = std::any_of(result.cells.begin(), result.cells.end(), [&](const sweep::CellVerdict& cell) {
            return static_cast<std::size_t>(cell.status) == status;
        });
        if (!occurs) continue;
        std::string name(sweep::status_names[status]);
        std::replace(name.begin(), name.end(), '_', ' ');
        list += (list.empty() ? "" : ", ") + name;
    }
    return list.empty() || list == "failed" ? list : "failed (" + list + ")";
}

void add_kind_legend(drawing::Scene& scene, const sweep::SweepResult& result) {
    const std::vector<drawing::Fill> fills = kind_fills();
    const std::vector<drawing::StyledText> names = kind_names();
    const auto occurs = [&](std::size_t kind) {
        return std::any_of(result.cells.begin(), result.cells.end(),
                           [&](const sweep::CellVerdict& cell) { return kind_of(cell) == kind; });
    };
    for (std::size_t kind = 0; kind < fills.size(); ++kind) {
        const bool is_category = kind < 4;
        if (kind == failed_kind && occurs(kind))
            scene.legend.push_back({failure_words(result), fills[kind]});
        else if (is_category || occurs(kind))
            scene.legend.push_back(
                {kind == 0 && occurs(stuck_kind) ? drawing::StyledText("none (slides)") : names[kind], fills[kind]});
    }
}

}  // namespace stridor::pictures
