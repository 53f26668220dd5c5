#include "stridor/base/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>
#include <vector>

namespace stridor::base {

namespace {

// rows of a table of edits, kept from one pair of texts to the next
struct Rows {
    std::vector<std::size_t> before_last, last, row;
};

// optimal string alignment distance (Damerau-Levenshtein with neighbours swapped once);
// `most` or more where it is no less
std::size_t edits(std::string_view a, std::string_view b, std::size_t most, Rows& rows) {
    auto& [before_last, last, row] = rows;
    for (std::vector<std::size_t>* each : {&before_last, &last, &row})
        each->resize(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        std::size_t least = std::min(i, last[0]);  // of this row and the one before: later ones are no less
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replace = last[j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U);
            row[j] = std::min(std::min(replace, last[j] + 1), row[j - 1] + 1);
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
            least = std::min(least, std::min(row[j], last[j]));
        }
        if (least >= most) return most;
        std::swap(before_last, last);
        std::swap(last, row);
    }
    return last[b.size()];
}

}  // namespace

std::string shortest(double value) {
    if (std::isnan(value)) return "nan";
    std::array<char, 32> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), result.ptr};
}

std::string_view nearest_name(std::string_view name, std::span<const std::string_view> candidates,
                              std::size_t most_edits) {
    std::string_view best;
    std::size_t fewest = most_edits + 1;
    Rows rows;
    for (const std::string_view candidate : candidates) {
        // each character too many is an edit
        const std::size_t longer = std::max(name.size(), candidate.size());
        if (longer - std::min(name.size(), candidate.size()) >= fewest) continue;
        const std::size_t count = edits(name, candidate, fewest, rows);
        if (count < fewest && count < candidate.size()) {
            fewest = count;
            best = candidate;
        }
    }
    return best;
}

std::size_t character_count(std::string_view text) {
    const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
    return text.size() - static_cast<std::size_t>(std::count_if(text.begin(), text.end(), continues));
}

std::string wrapped(std::string_view text, const Wrapping& wrapping) {
    std::string result;
    std::size_t column = wrapping.first;
    bool is_start = true;  // of a line
    const auto begin_line = [&] {
        result += "\n" + std::string(wrapping.indent, ' ');
        column = wrapping.indent;
        is_start = true;
    };
    for (std::size_t from = 0; from < text.size();) {
        if (text[from] == '\n') begin_line();
        if (text[from] == '\n' || text[from] == ' ') {
            ++from;
            continue;
        }
        const std::size_t end = std::min(text.find_first_of(" \n", from), text.size());
        const std::string_view word = text.substr(from, end - from);
        const std::size_t width = character_count(word);
        if (!is_start && column + 1 + width > wrapping.columns) begin_line();
        if (!is_start) result += ' ';
        column += width + (is_start ? 0 : 1);
        result += word;
        is_start = false;
        from = end;
    }
    return result;
}

std::size_t nesting(std::string_view text) {
    std::size_t depth = 0;
    std::size_t deepest = 0;
    bool is_quoted = false;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const char c = text[k];
        if (c == '"') is_quoted = !is_quoted;
        if (is_quoted && c == '\\') ++k;
        if (is_quoted) continue;
        if (c == '[' || c == '{') deepest = std::max(deepest, ++depth);
        if ((c == ']' || c == '}') && depth > 0) --depth;
    }
    return deepest;
}

std::string listed(std::span<const std::string> texts) {
    std::string list;
    for (const std::string& text : texts)
        list += (list.empty() ? "" : ", ") + text;
    return list;
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

}  // namespace stridor::base
