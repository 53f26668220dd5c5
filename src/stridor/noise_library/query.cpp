#include "stridor/noise_library/query.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/field_table.hpp"
#include "stridor/base/text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
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

constexpr std::array<std::string_view, 7> sql_signs{"=", "<>", "<", "<=", ">", ">=", "~"};

std::string in_quotes(std::string_view text) {
    return "\"" + std::string(text) + "\"";
}

// a name of a query: a column, a figure, or the id
struct QueryTerm {
    std::string expression;
    std::string unit;                   // of a number
    const EntryField* field = nullptr;  // of a field
    bool is_number = true;
};

[[noreturn]] void refuse_name(const std::string& name, std::span<const FigureKind> figures) {
    std::vector<std::string> names = field_names([](const EntryField&) { return true; });
    for (const FigureKind& figure : figures)
        names.push_back(figure.name);
    throw Error(ErrorKind::input, {in_quotes(name) + " is no field", "no entry has a figure of that name either",
                                   base::did_you_mean(name, names, "`stridor library fields` lists them.")});
}

// figure names are [a-z0-9_], and this one is known: it may stand in the text
QueryTerm target_of(const std::string& name, std::span<const FigureKind> figures) {
    if (name == "id") return {"e.id", "1", nullptr, true};
    if (const EntryField* field = find_field(name))
        return {is_document(*field)
                    ? "ifnull((SELECT text FROM document WHERE entry = e.id AND name = '" + name + "'), '')"
                    : "e." + column_of(*field),
                std::string(unit_of(*field)), field, std::holds_alternative<EntryQuantity>(field->kind)};
    for (const FigureKind& figure : figures)
        if (figure.name == name)
            return {"(SELECT value FROM figure WHERE entry = e.id AND name = '" + name + "')", figure.unit, nullptr,
                    true};
    refuse_name(name, figures);
}

std::string number_condition(const QueryTerm& target, const Condition& condition, Selection& selection) {
    if (condition.comparison == Comparison::contains)
        throw Error(ErrorKind::input,
                    {condition.name + " is a number", "~ looks for words", "Compare it with = != < <= > >=."});
    double value = 0.0;
    try {
        value = parse_value(condition.value, target.unit);
    } catch (const Error& error) {
        const base::Problem& problem = error.problem();
        throw Error(ErrorKind::input, {condition.name + ": " + problem.what, problem.why, problem.suggestion});
    }
    const bool is_equality = condition.comparison == Comparison::equal || condition.comparison == Comparison::different;
    if (std::isnan(value)) {
        if (!is_equality)
            throw Error(ErrorKind::input, {condition.name + " cannot be more or less than unknown", "", ""});
        return target.expression + (condition.comparison == Comparison::equal ? " IS NULL" : " IS NOT NULL");
    }
    selection.values.emplace_back(value);
    return target.expression + " " + std::string(sql_signs[static_cast<std::size_t>(condition.comparison)]) + " ?";
}

void expect_choice(const EntryField& field, const std::string& value) {
    Entry probe;
    if (std::holds_alternative<EntryChoice>(field.kind)) set_from_text(probe, field, value);
}

std::string word_condition(const QueryTerm& target, const Condition& condition, Selection& selection) {
    const bool is_order = condition.comparison != Comparison::equal && condition.comparison != Comparison::different &&
                          condition.comparison != Comparison::contains;
    if (is_order && !std::holds_alternative<EntryDate>(target.field->kind))
        throw Error(ErrorKind::input, {condition.name + " is words", "words are not more or less than others",
                                       "Compare them with = != ~ (contains)."});
    const bool is_unknown = condition.value.empty() || condition.value == "unknown";
    if (is_unknown && !is_order)
        return target.expression + (condition.comparison == Comparison::equal ? " = ''" : " <> ''");
    selection.values.emplace_back(condition.value);
    if (condition.comparison == Comparison::contains) return "instr(lower(" + target.expression + "), lower(?)) > 0";
    expect_choice(*target.field, condition.value);
    const std::string sign(sql_signs[static_cast<std::size_t>(condition.comparison)]);
    return "(" + target.expression + " <> '' AND " + target.expression + " " + sign + " ? COLLATE NOCASE)";
}

// all that a search looks through
std::string all_words() {
    std::string expression;
    for (const EntryField& field : fields())
        if (!std::holds_alternative<EntryQuantity>(field.kind) && !is_document(field) && field.name != "audio")
            expression += (expression.empty() ? "" : " || char(10) || ") + ("e." + column_of(field));
    return expression;
}

std::string id_list(std::span<const std::int64_t> ids) {
    std::string list;
    for (const std::int64_t id : ids)
        list += (list.empty() ? "" : ", ") + std::to_string(id);
    return list;
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

std::string column_of(const EntryField& field) {
    return in_quotes(field.name);
}

Selection select(const Query& query, std::span<const FigureKind> figures) {
    Selection selection;
    selection.rows = " FROM entry e WHERE 1";
    if (!query.ids.empty()) selection.rows += " AND e.id IN (" + id_list(query.ids) + ")";
    for (const Condition& condition : query.conditions) {
        const QueryTerm target = target_of(condition.name, figures);
        selection.rows += " AND " + (target.is_number ? number_condition(target, condition, selection)
                                                      : word_condition(target, condition, selection));
    }
    for (const std::string& word : query.words) {
        selection.rows += " AND instr(lower(" + all_words() + "), lower(?)) > 0";
        selection.values.emplace_back(word);
    }
    const std::string order = query.direction == SortOrder::falling ? " DESC" : "";
    const std::string limit = query.limit == 0 ? "" : " LIMIT " + std::to_string(query.limit);
    if (query.sort.empty()) {
        selection.order = " ORDER BY e.id" + order + limit;
        return selection;
    }
    const QueryTerm target = target_of(query.sort, figures);
    const std::string unknown_last = target.expression + (target.is_number ? " IS NULL" : " = ''");
    selection.order = " ORDER BY " + unknown_last + ", " + target.expression +
                      (target.is_number ? "" : " COLLATE NOCASE") + order + ", e.id" + limit;
    return selection;
}

void bind(storage::Statement& statement, const Selection& selection) {
    int parameter = 0;
    for (const std::variant<double, std::string>& value : selection.values) {
        ++parameter;
        if (const double* number = std::get_if<double>(&value))
            statement.bind(parameter, *number);
        else
            statement.bind(parameter, std::string_view(std::get<std::string>(value)));
    }
}

std::string columns() {
    std::string columns = "e.id";
    for (const EntryField& field : fields())
        if (!is_document(field)) columns += ", e." + column_of(field);
    return columns;
}

Entry entry_in(const storage::Statement& row) {
    Entry entry;
    entry.id = row.integer(0);
    int column = 1;
    for (const EntryField& field : fields()) {
        if (is_document(field)) continue;
        if (std::holds_alternative<EntryQuantity>(field.kind))
            quantity_in(entry, field) = row.number(column++);
        else
            words_in(entry, field) = row.text(column++);
    }
    return entry;
}

}  // namespace stridor::noise_library
