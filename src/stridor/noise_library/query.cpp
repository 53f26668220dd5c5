#include "stridor/noise_library/query.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <system_error>
#include <utility>

namespace stridor::noise_library {

namespace {

// longer signs first, so that "<=" is not taken for "<"
constexpr std::array signs{
    std::pair{std::string_view("<="), Comparison::at_most},   std::pair{std::string_view(">="), Comparison::at_least},
    std::pair{std::string_view("!="), Comparison::different}, std::pair{std::string_view("=="), Comparison::equal},
    std::pair{std::string_view("="), Comparison::equal},      std::pair{std::string_view("<"), Comparison::less},
    std::pair{std::string_view(">"), Comparison::more},       std::pair{std::string_view("~"), Comparison::contains}};

[[noreturn]] void refuse(std::string_view text, const std::string& why) {
    throw Error(ErrorKind::input, {"\"" + std::string(base::trimmed(text)) + "\" is no condition", why,
                                   "Write, for example, \"preload > 10 N and system = brake\"."});
}

bool is_name_letter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
}

std::string taken_name(std::string_view& rest, std::string_view whole) {
    const auto end = std::find_if_not(rest.begin(), rest.end(), is_name_letter);
    std::string name(rest.begin(), end);
    if (name.empty()) refuse(whole, "it does not begin with the name of a field");
    rest.remove_prefix(name.size());
    rest = base::trimmed(rest);
    // the option of a field is as good as its name
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

Comparison taken_sign(std::string_view& rest, std::string_view whole) {
    for (const auto& [sign, comparison] : signs)
        if (rest.starts_with(sign)) {
            rest = base::trimmed(rest.substr(sign.size()));
            return comparison;
        }
    refuse(whole, "after the name comes one of = != < <= > >= ~");
}

std::string taken_value(std::string_view& rest, std::string_view whole) {
    if (rest.starts_with('"') || rest.starts_with('\'')) {
        const std::size_t end = rest.find(rest.front(), 1);
        if (end == std::string_view::npos) refuse(whole, "the quote does not end");
        std::string value(rest.substr(1, end - 1));
        rest = base::trimmed(rest.substr(end + 1));
        return value;
    }
    const std::size_t end = std::min(rest.find(" and "), rest.size());
    std::string value(base::trimmed(rest.substr(0, end)));
    if (value.empty()) refuse(whole, "it has no value");
    if (value.ends_with(" and")) refuse(whole, "nothing comes after \"and\"");
    rest = base::trimmed(rest.substr(end));
    return value;
}

}  // namespace

std::vector<Condition> parse_conditions(std::string_view text) {
    std::vector<Condition> conditions;
    std::string_view rest = base::trimmed(text);
    while (true) {
        Condition condition;
        condition.name = taken_name(rest, text);
        condition.comparison = taken_sign(rest, text);
        condition.value = taken_value(rest, text);
        conditions.push_back(std::move(condition));
        if (rest.empty()) return conditions;
        if (!rest.starts_with("and ")) refuse(text, "conditions are joined by \"and\"");
        rest = base::trimmed(rest.substr(4));
    }
}

std::size_t parse_limit(std::string_view text) {
    if (text == "all") return 0;
    std::size_t limit = 0;
    const auto [stop, problem] = std::from_chars(text.data(), text.data() + text.size(), limit);
    if (problem != std::errc() || stop != text.data() + text.size() || limit == 0)
        base::refuse("--limit " + std::string(text) + " is no number of entries", "it is a whole number, or all", "");
    return limit;
}

std::vector<std::string> parse_words(std::string_view text) {
    std::vector<std::string> words;
    for (std::string_view rest = base::trimmed(text); !rest.empty();) {
        const std::size_t end = std::min(rest.find_first_of(" \t\n"), rest.size());
        words.emplace_back(rest.substr(0, end));
        rest = base::trimmed(rest.substr(end));
    }
    return words;
}

Query parse_query(std::span<const std::string> conditions, std::string_view words, std::string_view sort) {
    Query query;
    for (const std::string& text : conditions)
        for (Condition& condition : parse_conditions(text))
            query.conditions.push_back(std::move(condition));
    query.words = parse_words(words);
    if (sort.starts_with('-')) query.direction = SortOrder::falling;
    query.sort = sort.substr(sort.starts_with('-') ? 1 : 0);
    return query;
}

}  // namespace stridor::noise_library
