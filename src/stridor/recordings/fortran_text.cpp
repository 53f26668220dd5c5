#include "stridor/recordings/fortran_text.hpp"

#include "stridor/base/text.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string>

namespace stridor::recordings {

std::vector<std::string_view> words(std::string_view line) {
    constexpr std::string_view blanks = " \t\r";
    std::vector<std::string_view> found;
    for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;) {
        const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
        found.push_back(line.substr(at, end - at));
        at = line.find_first_not_of(blanks, end);
    }
    return found;
}

std::optional<double> fortran_number(std::string_view text) {
    text = base::trimmed(text);
    if (text.starts_with('+')) text.remove_prefix(1);
    constexpr std::size_t longest = 60;
    if (text.empty() || text.size() > longest || text.starts_with('+')) return std::nullopt;
    std::string numeral(text);
    std::replace_if(
        numeral.begin(), numeral.end(), [](char c) { return c == 'D' || c == 'd'; }, 'E');
    // an exponent of three digits leaves no room for its letter
    const std::size_t sign = numeral.find_first_of("+-", 1);
    const bool lacks_letter = sign != std::string::npos && numeral.find_first_of("eE") == std::string::npos;
    if (lacks_letter) numeral.insert(sign, 1, 'E');
    double number = 0.0;
    const auto [end, code] = std::from_chars(numeral.data(), numeral.data() + numeral.size(), number);
    if (code == std::errc::invalid_argument || end != numeral.data() + numeral.size()) return std::nullopt;
    return code == std::errc::result_out_of_range ? std::strtod(numeral.c_str(), nullptr) : number;
}

}  // namespace stridor::recordings
