#include "stridor/io/structure/fortran_format.hpp"

#include "stridor/base/text.hpp"
#include "stridor/io/structure/field_scanner.hpp"

#include <algorithm>

namespace stridor::io::structure {

std::optional<FortranFormat> fortran_format(std::string_view text) {
    const std::string large = upper(text);
    const std::size_t kind = large.find_first_of("IEDFG");
    if (kind == std::string::npos) return std::nullopt;
    // the number that ends before a letter; 1 where there is none
    const auto number_before = [&](std::size_t end) {
        std::size_t begin = end;
        while (begin > 0 && large[begin - 1] >= '0' && large[begin - 1] <= '9')
            --begin;
        constexpr std::int64_t most = 10000;
        const auto number = integer_in(std::string_view(large).substr(begin, end - begin));
        return begin == end ? std::int64_t{1} : std::clamp(number.value_or(0), std::int64_t{0}, most);
    };
    // "1P," scales what is written, not what is read; "1P3E23.16" has no comma, and 3(1P,E24.16) repeats its group
    const std::size_t group = large.rfind('(', kind);
    const std::size_t blanks = large.rfind('X', kind);
    const std::int64_t repeated = group == std::string::npos ? 1 : number_before(group);
    const std::int64_t count = repeated * number_before(kind);
    const std::size_t end = std::min(large.find_first_not_of("0123456789", kind + 1), large.size());
    const auto width = integer_in(std::string_view(large).substr(kind + 1, end - kind - 1));
    const std::int64_t skipped = blanks == std::string::npos ? 0 : number_before(blanks);
    constexpr std::int64_t most = 60;
    if (!width || count < 1 || count > 1000 || *width < 1 || *width > most || skipped > most) return std::nullopt;
    return FortranFormat{static_cast<std::size_t>(count), static_cast<std::size_t>(*width),
                         static_cast<std::size_t>(skipped)};
}

std::vector<std::string_view> fields_of(std::string_view line, const FortranFormat& format) {
    std::vector<std::string_view> fields;
    for (std::size_t from = format.skipped; from < line.size() && fields.size() < format.count; from += format.width)
        fields.push_back(base::trimmed(line.substr(from, format.width)));
    while (!fields.empty() && fields.back().empty())
        fields.pop_back();
    return fields;
}

}  // namespace stridor::io::structure
