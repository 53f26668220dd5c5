#include "stridor/report/sketch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

namespace stridor::report {

namespace {

struct Point {
    double x = 0.0;  // [px] to the right
    double y = 0.0;  // [px] downwards
};

constexpr double width = 340.0;         // [px]
constexpr double height = 250.0;        // [px]
constexpr Point contact{170.0, 150.0};  // where the joint touches the plate
constexpr double thickness = 20.0;      // [px] of the plate
constexpr Point body{contact.x, contact.y - 28.0};

std::string line(Point from, Point to, std::string_view style = "") {
    return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"{}/>", from.x, from.y, to.x, to.y,
                       style);
}

// a symbol with its index
std::string sign(Point at, std::string_view letter, std::string_view index = "", std::string_view value = "") {
    std::string text =
        fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\"><tspan font-style=\"italic\">{}</tspan>", at.x, at.y, letter);
    if (!index.empty()) text += fmt::format("<tspan font-size=\"9\" dy=\"3\">{}</tspan>", index);
    if (!value.empty()) text += fmt::format("<tspan dy=\"{}\"> = {}</tspan>", index.empty() ? 0 : -3, value);
    return text + "</text>";
}

std::string arrow(Point from, Point to) {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    const Point along{(to.x - from.x) / length, (to.y - from.y) / length};
    const Point neck{to.x - 8.0 * along.x, to.y - 8.0 * along.y};
    return line(from, neck, " stroke-width=\"2\"") +
           fmt::format(
               "<polygon points=\"{:.1f},{:.1f} {:.1f},{:.1f} {:.1f},{:.1f}\" fill=\"currentColor\" stroke=\"none\"/>",
               to.x, to.y, neck.x - 4.0 * along.y, neck.y + 4.0 * along.x, neck.x + 4.0 * along.y,
               neck.y - 4.0 * along.x);
}

// a spring and a dashpot side by side from a point to a hatched wall
std::string support(Point from, Point to) {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    const double turn = std::atan2(to.y - from.y, to.x - from.x) * 180.0 / std::numbers::pi;
    const double end = length - 6.0;
    const double middle = 0.5 * (6.0 + end);
    std::string zigzag = "6,-7";
    constexpr int turns = 12;
    for (int k = 0; k <= turns; ++k)
        zigzag += fmt::format(" {:.1f},{}", 12.0 + (end - 18.0) * k / turns, k % 2 == 0 ? -11 : -3);
    zigzag += fmt::format(" {:.1f},-7", end);
    std::string text = fmt::format("<g transform=\"translate({:.1f} {:.1f}) rotate({:.2f})\">", from.x, from.y, turn);
    text += line({0, 0}, {6, 0}) + line({6, -7}, {6, 7}) + line({end, -7}, {end, 7}) + line({end, 0}, {length, 0});
    text += "<polyline points=\"" + zigzag + "\"/>";
    text += line({6, 7}, {middle - 6, 7}) + line({middle + 2, 7}, {end, 7}) + line({middle + 2, 3}, {middle + 2, 11});
    text += fmt::format("<polyline points=\"{0:.1f},2 {1:.1f},2 {1:.1f},12 {0:.1f},12\"/>", middle + 7, middle - 6);
    text += line({length, -15}, {length, 15}, " stroke-width=\"1.8\"");
    for (int y = -12; y <= 15; y += 6)
        text += line({length, static_cast<double>(y)}, {length + 5, y - 4.0});
    return text + "</g>";
}

// the joint's axes i and j, each towards the upper side, where its support hangs
std::string joint_supports(double angle) {
    std::string text;
    const double radians = angle * std::numbers::pi / 180.0;
    struct Axis {
        Point along;
        std::string_view index;
    };
    for (const Axis& axis :
         {Axis{{std::cos(radians), -std::sin(radians)}, "1i"}, Axis{{-std::sin(radians), -std::cos(radians)}, "1j"}}) {
        const double up = axis.along.y > 0.05 ? -1.0 : 1.0;
        const Point d{up * axis.along.x, up * axis.along.y};
        const double reach = std::min(
            {(0.5 * width - 16.0) / std::max(std::abs(d.x), 1e-6), (body.y - 12.0) / std::max(-d.y, 1e-6), 122.0});
        const Point wall{body.x + reach * d.x, body.y + reach * d.y};
        text += support({body.x + 16.0 * d.x, body.y + 16.0 * d.y}, wall);
        // beside the middle, on the spring's and the dashpot's side
        const Point middle{body.x + 0.6 * reach * d.x, body.y + 0.6 * reach * d.y};
        text += sign({middle.x + 23.0 * d.y - 7.0, middle.y - 23.0 * d.x + 4.0}, "k", axis.index);
        text += sign({middle.x - 24.0 * d.y - 7.0, middle.y + 24.0 * d.x + 4.0}, "c", axis.index);
    }
    return text;
}

std::string incidence(double angle) {
    constexpr double radius = 46.0;
    const double shown = std::clamp(angle, 0.0, 180.0) * std::numbers::pi / 180.0;
    return line({body.x + 18, body.y}, {body.x + 62, body.y}, " stroke-dasharray=\"3 3\"") +
           fmt::format("<path d=\"M {:.1f} {:.1f} A {} {} 0 0 0 {:.1f} {:.1f}\"/>", body.x + radius, body.y, radius,
                       radius, body.x + radius * std::cos(shown), body.y - radius * std::sin(shown)) +
           sign({body.x + 66, body.y - 6}, "α", "", fmt::format("{:g}°", angle));
}

std::string plate(const parameters::Case& c) {
    std::string text =
        fmt::format("<rect x=\"20\" y=\"{}\" width=\"300\" height=\"{}\" fill=\"currentColor\" fill-opacity=\"0.08\"/>",
                    contact.y, thickness);
    text += support({contact.x, contact.y + thickness}, {contact.x, height - 12.0});
    text += sign({contact.x + 18, contact.y + 48}, "k", "2y") + sign({contact.x - 36, contact.y + 48}, "c", "2y");
    text += sign({28, contact.y + 14}, "m", "2");
    text += arrow({262, contact.y + 36}, {312, contact.y + 36});
    const bool is_constant = c.drive.kind == parameters::DriveKind::constant;
    text +=
        sign({262, contact.y + 54}, "V", "", is_constant ? fmt::format("{:g} m/s", std::abs(c.drive.velocity)) : "");
    return text;
}

// where above the joint a vertical arrow is farthest from the lines of both supports
double free_place(double angle) {
    constexpr double aside = 20.0;
    constexpr double above = 50.0;
    const double radians = angle * std::numbers::pi / 180.0;
    const auto distance = [&](double x) {
        double least = width;
        for (const Point& d : {Point{std::cos(radians), -std::sin(radians)}, {-std::sin(radians), -std::cos(radians)}})
            if (std::abs(d.y) > 1e-3) least = std::min(least, std::abs(x - (body.x - above * d.x / d.y)));
        return least;
    };
    return distance(body.x - aside) >= distance(body.x + aside) ? body.x - aside : body.x + aside;
}

std::string joint(const parameters::Case& c) {
    std::string text = fmt::format(
        "<path d=\"M {0:.1f} {1:.1f} l -9 -10 h -16 v -32 q 0 -5 5 -5 h 40 q 5 0 5 5 v 32 h -16 z\" "
        "style=\"fill:var(--paper,#fff)\" stroke-width=\"1.6\"/>",
        contact.x, contact.y);
    text += sign({contact.x - 10, body.y + 3}, "m", "1");
    text += sign({contact.x + 32, contact.y - 10}, "μ", "d", fmt::format("{:g}", c.contact.kinetic_friction));
    // the preload comes from above, where no support is
    const double x = free_place(c.joint.incidence_angle);
    const std::string value = fmt::format("{:.4g} N", c.contact.preload);
    const double length = 36.0 + 7.5 * static_cast<double>(value.size());  // [px] about that of "F = 20 N"
    const double label = x < contact.x ? x - length : x + 8.0;
    return text + arrow({x, body.y - 72}, {x, body.y - 22}) + sign({label, body.y - 62}, "F", "", value);
}

}  // namespace

std::string sketch_svg(const parameters::Case& c) {
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" fill=\"none\" stroke=\"currentColor\" "
               "stroke-width=\"1.2\" stroke-linecap=\"round\" stroke-linejoin=\"round\">"
               "<style>.stridor-sketch text{{fill:currentColor;stroke:none;font:13px serif}}</style>"
               "<g class=\"stridor-sketch\">",
               width, height) +
           plate(c) + joint_supports(c.joint.incidence_angle) + incidence(c.joint.incidence_angle) + joint(c) +
           "</g></svg>";
}

}  // namespace stridor::report
