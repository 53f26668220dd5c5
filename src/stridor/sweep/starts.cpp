#include "stridor/sweep/starts.hpp"

#include "stridor/base/check.hpp"
#include "stridor/parameters/fields/field.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

namespace stridor::sweep {

namespace {

using classification::Category;
using classification::Quiet;

bool is_silent(const StartVerdict& verdict) {
    return verdict.status == Status::done && verdict.category == Category::none;
}

bool is_quiet(const StartVerdict& verdict) {
    return is_silent(verdict) && verdict.quiet != Quiet::locks;
}

bool is_noisy(const StartVerdict& verdict) {
    return verdict.status == Status::done && !is_silent(verdict) && verdict.category != Category::undecided;
}

// how bad it is: slides, sticks, locks, no result, and the others by what speaks for noise
int rank(const StartVerdict& verdict) {
    constexpr int no_result = 3;
    if (is_silent(verdict)) return verdict.quiet == Quiet::locks ? 2 : verdict.quiet == Quiet::sticks ? 1 : 0;
    return verdict.status == Status::done ? no_result + classification::loudness(verdict.category) : no_result;
}

StartVerdict verdict_of_run(const Cell& cell) {
    return {cell.status, cell.category, cell.quiet};
}

}  // namespace

std::span<const std::string_view> start_names() {
    return std::get<parameters::Choice>(parameters::find_field("run.initial")->kind).names;
}

std::size_t number_of(const StartVerdict& verdict) {
    if (is_silent(verdict) && !is_quiet(verdict)) return verdict_words.size() - 1;
    return verdict.status == Status::done
               ? static_cast<std::size_t>(verdict.category)
               : classification::category_names.size() + static_cast<std::size_t>(verdict.status) - 1;
}

StartVerdict verdict_of(std::size_t number) {
    constexpr std::size_t categories = classification::category_names.size();
    if (number == 0) return {Status::done, Category::none, Quiet::slides};
    if (number < categories) return {Status::done, static_cast<Category>(number)};
    if (number == verdict_words.size() - 1) return {Status::done, Category::none, Quiet::locks};
    return {static_cast<Status>(number - categories + 1), Category::undecided};
}

std::string_view word(const StartVerdict& verdict) {
    return verdict_words[number_of(verdict)];
}

std::string_view word(const Cell& cell) {
    return word(verdict_of_run(cell));
}

bool has_same_verdict(const Cell& a, const Cell& b) {
    return verdict_of_run(a) == verdict_of_run(b);
}

std::size_t worst(std::span<const StartVerdict> verdicts) {
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
    return cell.starts.empty() ? 0 : worst(cell.starts);
}

Cell joined(std::vector<Cell> by_start) {
    std::vector<StartVerdict> verdicts;
    for (const Cell& cell : by_start)
        verdicts.push_back({cell.status, cell.category, cell.quiet});
    Cell cell = std::move(by_start[worst(verdicts)]);
    cell.agreement = agreement(verdicts);
    cell.starts = std::move(verdicts);
    return cell;
}

}  // namespace stridor::sweep
