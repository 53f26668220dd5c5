#include "stridor/report/structure_sketch.hpp"

#include "stridor/base/escapes.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace stridor::report {

namespace {

constexpr double sketch_width = 340.0;      // [px]
constexpr double sketch_height = 250.0;     // [px]
constexpr double surface = 160.0;           // [px] from above, where it rubs
constexpr double body_left = 40.0;          // [px]
constexpr double body_right = 300.0;        // [px]
constexpr double body_top = 60.0;           // [px]
constexpr double body_bottom = 125.0;       // [px]
constexpr std::size_t most_drawn = 9;       // [1] contacts
constexpr std::size_t longest_name = 8;     // [1] letters below a contact
constexpr std::size_t longest_origin = 34;  // [1] letters across the body

std::string shortened(const std::string& name, std::size_t longest) {
    if (base::character_count(name) <= longest) return name;
    std::string text;
    std::size_t letters = 0;
    for (const char byte : name) {
        const bool begins_letter = (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
        if (begins_letter && ++letters == longest) break;
        text += byte;
    }
    return text + "\u2026";
}

std::string text_at(double x, double y, const std::string& text, const char* more = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\"{}>{}</text>", x, y, more, text);
}

// the numbers of those that are drawn; the gap between them stands for the rest
std::vector<std::size_t> drawn_contacts(std::size_t contacts) {
    std::vector<std::size_t> drawn;
    for (std::size_t k = 0; k < contacts; ++k)
        if (contacts <= most_drawn || k + 1 < most_drawn / 2 + 1 || k + most_drawn / 2 >= contacts) drawn.push_back(k);
    return drawn;
}

std::string foot_at(double x) {
    return fmt::format("<path d=\"M {0:.1f} {1:.1f} l -9 -{2:.1f} h 18 z\" style=\"fill:var(--paper,#fff)\"/>", x,
                       surface, surface - body_bottom);
}

std::string contacts_drawing(const parameters::Case& c) {
    const std::vector<std::size_t> drawn = drawn_contacts(parameters::contact_count(c));
    const bool is_cut = drawn.size() < parameters::contact_count(c);
    const double places = static_cast<double>(drawn.size() + (is_cut ? 1 : 0));
    std::string text;
    std::size_t place = 0;
    const auto next = [&] {
        return body_left + (body_right - body_left) * (static_cast<double>(place++) + 0.5) / places;
    };
    for (std::size_t k = 0; k < drawn.size(); ++k) {
        if (k > 0 && drawn[k] != drawn[k - 1] + 1) text += text_at(next(), surface - 12.0, "\u2026");
        const double x = next();
        const std::string name = base::markup_text(shortened(parameters::contact_name(c, drawn[k]), longest_name));
        // names of neighbours stand on two lines
        text += foot_at(x) + text_at(x, surface + (k % 2 == 0 || drawn.size() <= 4 ? 36.0 : 50.0), name,
                                     " style=\"font-size:10px\"");
    }
    return text;
}

}  // namespace

std::string structure_sketch_svg(const parameters::Case& c) {
    const std::size_t contacts = parameters::contact_count(c);
    const double middle = 0.5 * (body_left + body_right);
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" fill=\"none\" stroke=\"currentColor\" "
        "stroke-width=\"1.2\" stroke-linecap=\"round\" stroke-linejoin=\"round\">"
        "<style>.stridor-sketch text{{fill:currentColor;stroke:none;font:13px serif}}</style>"
        "<g class=\"stridor-sketch\">",
        sketch_width, sketch_height);
    text += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" rx=\"8\" "
        "style=\"fill:var(--paper,#fff)\"/>",
        body_left, body_top, body_right - body_left, body_bottom - body_top);
    text += text_at(middle, 0.5 * (body_top + body_bottom) - 4.0,
                    base::markup_text(shortened(parameters::origin_of(c), longest_origin)));
    text += text_at(
        middle, 0.5 * (body_top + body_bottom) + 14.0,
        fmt::format("{} rows, {} contact{}", parameters::coordinate_count(c), contacts, contacts == 1 ? "" : "s"));
    if (parameters::is_preloaded(c))
        text += fmt::format("<path d=\"M {0:.1f} 18 v 34 m -5 -9 l 5 9 l 5 -9\"/>", middle) +
                text_at(middle + 46.0, 34.0, fmt::format("F = {:.4g} N", c.contact().preload));
    text += contacts_drawing(c);
    text += fmt::format("<rect x=\"10\" y=\"{:.1f}\" width=\"320\" height=\"18\"/>", surface);
    text += fmt::format("<path d=\"M 130 {0:.1f} h 80 m -9 -5 l 9 5 l -9 5\"/>", surface + 66.0);
    text += text_at(226.0, surface + 70.0, "<tspan font-style=\"italic\">V</tspan>");
    return text + "</g></svg>";
}

}  // namespace stridor::report
