#include "stridor/io/structure/fortran_format.hpp"

#include "stridor/base/text.hpp"
#include "stridor/io/structure/field_scanner.hpp"

#include <algorithm>

namespace stridor::io::structure {

std::optional<FortranFormat> fortran_format(std::string_view text) {
    const std::string large = upper(text);
    // "1P," scales what is written, not what is read
    std::size_t from = large.find("P");
    from = from == std::string::npos ? 0 : from + 1;
    const std::size_t kind = large.find_first_of("IEDFG", from);
    if (kind == std::string::npos) return std::nullopt;
    const auto digits = [&](std::size_t begin) {
        const std::size_t end = std::min(large.find_first_not_of("0123456789", begin), large.size());
        return integer_in(std::string_view(large).substr(begin, end - begin));
    };
    std::size_t count_begin = kind;
    while (count_begin > from && large[count_begin - 1] >= '0' && large[count_begin - 1] <= '9')
        --count_begin;
    const auto count = count_begin == kind ? std::optional<std::int64_t>(1) : digits(count_begin);
    const auto width = digits(kind + 1);
    constexpr std::int64_t most = 60;
    if (!count || !width || *count < 1 || *width < 1 || *width > most || *count > 1000) return std::nullopt;
    return FortranFormat{static_cast<std::size_t>(*count), static_cast<std::size_t>(*width)};
}

std::vector<std::string_view> fields_of(std::string_view line, const FortranFormat& format) {
    std::vector<std::string_view> fields;
    for (std::size_t from = 0; from < line.size() && fields.size() < format.count; from += format.width)
        fields.push_back(base::trimmed(line.substr(from, format.width)));
    while (!fields.empty() && fields.back().empty())
        fields.pop_back();
    return fields;
}

}  // namespace stridor::io::structure
