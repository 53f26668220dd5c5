#include "stridor/recordings/table/instants.hpp"

#include "stridor/base/text.hpp"
#include "stridor/recordings/table/csv_table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <string>
#include <system_error>
#include <vector>

namespace stridor::recordings::csv_table {

namespace {

// digits alone
std::optional<int> whole_number(std::string_view text) {
    int number = 0;
    const bool is_short = !text.empty() && text.size() <= 9;
    if (!is_short || text.find_first_not_of(all_digits) != std::string_view::npos) return std::nullopt;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

std::vector<std::string_view> parts_of(std::string_view text, char mark) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t end = text.find(mark);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

// days from 1970 in the Gregorian calendar (Hinnant 2013)
double days_since_1970(int year, int month, int day) {
    year -= month <= 2 ? 1 : 0;
    const int era = year / 400;
    const int year_of_era = year - era * 400;
    const int day_of_year = (153 * (month + (month > 2 ? -3 : 9)) + 2) / 5 + day - 1;
    return era * 146097.0 + year_of_era * 365 + year_of_era / 4 - year_of_era / 100 + day_of_year - 719468;
}

std::optional<double> days_in(std::string_view text) {
    const std::size_t first = text.find_first_not_of(all_digits);
    if (first == std::string_view::npos) return std::nullopt;
    const char mark = text[first];
    const std::vector<std::string_view> parts = parts_of(text, mark);
    if (parts.size() != 3 || (mark != '-' && mark != '/' && mark != '.')) return std::nullopt;
    std::array<int, 3> numbers{};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::optional<int> number = whole_number(parts[k]);
        if (!number) return std::nullopt;
        numbers[k] = *number;
    }
    if (numbers[0] > 31)
        std::swap(numbers[0], numbers[2]);  // year first: day, month, year
    else if (mark == '/' && numbers[0] <= 12)
        std::swap(numbers[0], numbers[1]);  // month first, as in America
    const auto [day, month, year] = numbers;
    if (day < 1 || day > 31 || month < 1 || month > 12 || year > 9999) return std::nullopt;
    return days_since_1970(year < 100 ? 2000 + year : year, month, day);
}

// behind the seconds; only steps count, and one zone holds for all
std::string_view without_zone(std::string_view text) {
    if (text.ends_with('Z')) text.remove_suffix(1);
    const std::size_t sign = text.find_last_of("+-");
    const bool is_zone =
        sign != std::string_view::npos && text.find_first_not_of("0123456789:", sign + 1) == std::string_view::npos;
    return is_zone ? text.substr(0, sign) : text;
}

std::optional<ClockTime> clock_in(std::string_view text) {
    const std::string_view last = text.size() > 2 ? text.substr(text.size() - 2) : "";
    const bool is_afternoon = last == "PM" || last == "pm";
    const bool has_half = is_afternoon || last == "AM" || last == "am";
    if (has_half) text.remove_suffix(2);
    std::string numerals(without_zone(base::trimmed(text)));
    std::replace(numerals.begin(), numerals.end(), ',', '.');
    // "10:00:00:250"
    if (std::count(numerals.begin(), numerals.end(), ':') == 3) numerals[numerals.rfind(':')] = '.';
    const std::vector<std::string_view> parts = parts_of(numerals, ':');
    const std::size_t point = parts.back().find('.');
    const std::string_view fraction = point == std::string_view::npos ? "" : parts.back().substr(point + 1);
    // "10:00" may be hours or minutes
    if (parts.size() > 3 || parts.size() < (fraction.empty() ? 3U : 2U)) return std::nullopt;
    const std::optional<int> hour = parts.size() == 3 ? whole_number(parts[0]) : 0;
    const std::optional<int> minute = whole_number(parts[parts.size() - 2]);
    const std::optional<int> second = whole_number(parts.back().substr(0, point));
    const bool is_clock = hour && minute && second && *minute < 60 && *second < 61 &&
                          fraction.find_first_not_of(all_digits) == std::string_view::npos;
    if (!is_clock) return std::nullopt;
    double seconds = 0.0;
    std::from_chars(parts.back().data(), parts.back().data() + parts.back().size(), seconds);
    const int hours = has_half ? *hour % 12 + (is_afternoon ? 12 : 0) : *hour;
    return ClockTime{3600.0 * hours + 60.0 * *minute + seconds, static_cast<int>(fraction.size())};
}

}  // namespace

std::optional<ClockTime> instant_in(std::string_view text) {
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) return std::nullopt;
    const std::size_t gap = text.substr(0, colon).find_last_of(" T");
    const bool has_date = gap != std::string_view::npos;
    const std::optional<double> days = has_date ? days_in(base::trimmed(text.substr(0, gap))) : 0.0;
    std::optional<ClockTime> instant = days ? clock_in(text.substr(has_date ? gap + 1 : 0)) : std::nullopt;
    if (instant) instant->seconds += 86400.0 * *days;
    return instant;
}

}  // namespace stridor::recordings::csv_table
