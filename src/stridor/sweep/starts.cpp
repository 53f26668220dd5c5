#include "stridor/sweep/starts.hpp"

#include "stridor/base/check.hpp"
#include "stridor/parameters/field.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

namespace stridor::sweep {

namespace {

using classification::Category;

int rank(const StartVerdict& verdict) {
    const bool is_done = verdict.status == Status::done;
    if (is_done && verdict.category == Category::none) return 0;
    if (!is_done) return 1;
    return 1 + classification::loudness(verdict.category);
}

bool is_quiet(const StartVerdict& verdict) {
    return verdict.status == Status::done && verdict.category == Category::none;
}

bool is_noisy(const StartVerdict& verdict) {
    return verdict.status == Status::done && !is_quiet(verdict) && verdict.category != Category::undecided;
}

}  // namespace

std::span<const std::string_view> start_names() {
    return std::get<parameters::Choice>(parameters::find_field("run.initial")->kind).names;
}

std::size_t number_of(const StartVerdict& verdict) {
    return verdict.status == Status::done
               ? static_cast<std::size_t>(verdict.category)
               : classification::category_names.size() + static_cast<std::size_t>(verdict.status) - 1;
}

StartVerdict verdict_of(std::size_t number) {
    constexpr std::size_t categories = classification::category_names.size();
    if (number < categories) return {Status::done, static_cast<Category>(number)};
    return {static_cast<Status>(number - categories + 1), Category::undecided};
}

std::string_view word(const StartVerdict& verdict) {
    return verdict_words[number_of(verdict)];
}

std::size_t loudest(std::span<const StartVerdict> verdicts) {
    STRIDOR_EXPECT(!verdicts.empty());
    const auto first = std::max_element(verdicts.begin(), verdicts.end(),
                                        [](const auto& a, const auto& b) { return rank(a) < rank(b); });
    return static_cast<std::size_t>(first - verdicts.begin());
}

Agreement agreement(std::span<const StartVerdict> verdicts) {
    const bool has_quiet = std::any_of(verdicts.begin(), verdicts.end(), is_quiet);
    const bool has_noise = std::any_of(verdicts.begin(), verdicts.end(), is_noisy);
    if (has_quiet && has_noise) return Agreement::quiet_unless_disturbed;
    const bool are_alike = std::all_of(verdicts.begin(), verdicts.end(),
                                       [&](const StartVerdict& each) { return word(each) == word(verdicts.front()); });
    return are_alike ? Agreement::agree : Agreement::differ;
}

std::size_t shown_start(const Cell& cell) {
    return cell.starts.empty() ? 0 : loudest(cell.starts);
}

Cell joined(std::vector<Cell> by_start) {
    std::vector<StartVerdict> verdicts;
    for (const Cell& cell : by_start)
        verdicts.push_back({cell.status, cell.category});
    Cell cell = std::move(by_start[loudest(verdicts)]);
    cell.agreement = agreement(verdicts);
    cell.starts = std::move(verdicts);
    return cell;
}

}  // namespace stridor::sweep
