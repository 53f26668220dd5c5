#include "stridor/report/sketch.hpp"

#include "stridor/base/escapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

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

// What is drawn so far, as points, so that labels find a free place.
class Crowd {
public:
    void add(Point from, Point to) {
        const int steps = 1 + static_cast<int>(std::hypot(to.x - from.x, to.y - from.y) / 3.0);
        for (int k = 0; k <= steps; ++k) {
            const double share = static_cast<double>(k) / steps;
            points_.push_back({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
        }
    }
    void add_text(Point at, double length) { add({at.x, at.y - 4.0}, {at.x + length, at.y - 4.0}); }

    // [px] from a line to the nearest point
    double room(Point from, Point to) const {
        Crowd probe;
        probe.add(from, to);
        double least = width;
        for (const Point& each : probe.points_)
            for (const Point& other : points_)
                least = std::min(least, std::hypot(each.x - other.x, each.y - other.y));
        return least;
    }
    double room_for_text(Point at, double length) const {
        return room({at.x, at.y - 4.0}, {at.x + length, at.y - 4.0});
    }

    // the first place with room enough for a text, else the one with most
    Point place(const std::vector<Point>& candidates, double length) {
        constexpr double enough = 11.0;  // [px] half a letter's height and some air
        Point best = candidates.front();
        double most = -1.0;
        for (const Point& candidate : candidates) {
            const double room = room_for_text(candidate, length);
            if (room > most) {
                most = room;
                best = candidate;
            }
            if (most >= enough) break;
        }
        add_text(best, length);
        return best;
    }

private:
    std::vector<Point> points_;
};

constexpr double index_length = 17.0;   // [px] of "k1i"
constexpr double letter_length = 11.0;  // [px] of "F"

// an axis of the joint towards the upper side, where its support hangs
struct Support {
    Point d;             // direction, length 1
    double reach = 0.0;  // [px] from the joint's centre to the wall
    std::string_view index;
};

std::array<Support, 2> joint_supports(double angle) {
    const double radians = angle * std::numbers::pi / 180.0;
    std::array<Support, 2> supports{
        {{{std::cos(radians), -std::sin(radians)}, 0.0, "1i"}, {{-std::sin(radians), -std::cos(radians)}, 0.0, "1j"}}};
    for (Support& each : supports) {
        if (each.d.y > 0.05) each.d = {-each.d.x, -each.d.y};
        each.reach = std::min({(0.5 * width - 16.0) / std::max(std::abs(each.d.x), 1e-6),
                               (body.y - 12.0) / std::max(-each.d.y, 1e-6), 122.0});
    }
    return supports;
}

Point beside(const Support& support, double along, double aside) {
    return {body.x + along * support.d.x + aside * support.d.y, body.y + along * support.d.y - aside * support.d.x};
}

std::string drawn(const Support& each, Crowd& crowd) {
    for (const double aside : {-10.0, 0.0, 10.0})
        crowd.add(beside(each, 16.0, aside), beside(each, each.reach, aside));
    crowd.add(beside(each, each.reach + 3.0, -16.0), beside(each, each.reach + 3.0, 16.0));
    return support(beside(each, 16.0, 0.0), beside(each, each.reach, 0.0));
}

// beside the middle, on the spring's and the dashpot's side
std::string names(const Support& each, Crowd& crowd) {
    std::string text;
    for (const auto& [letter, side] : {std::pair("k", 1.0), std::pair("c", -1.0)}) {
        std::vector<Point> candidates;
        for (const double aside : {23.0, 26.0, 29.0, 19.0})
            for (const double share : {0.6, 0.7, 0.5, 0.8, 0.4, 0.9}) {
                const Point middle = beside(each, share * each.reach, side * aside);
                candidates.push_back({middle.x - 0.5 * index_length, middle.y + 4.0});
            }
        text += sign(crowd.place(candidates, index_length), letter, each.index);
    }
    return text;
}

constexpr double arc_radius = 46.0;  // [px]

std::string incidence(double angle, Crowd& crowd) {
    const double shown = std::clamp(angle, 0.0, 180.0) * std::numbers::pi / 180.0;
    const auto on_arc = [&](double share, double radius) {
        return Point{body.x + radius * std::cos(share * shown), body.y - radius * std::sin(share * shown)};
    };
    for (int k = 0; k < 12; ++k)
        crowd.add(on_arc(k / 12.0, arc_radius), on_arc((k + 1) / 12.0, arc_radius));
    const Point end = on_arc(1.0, arc_radius);
    crowd.add({body.x + 18, body.y}, {body.x + 62, body.y});
    return line({body.x + 18, body.y}, {body.x + 62, body.y}, " stroke-dasharray=\"3 3\"") +
           fmt::format("<path d=\"M {:.1f} {:.1f} A {} {} 0 0 0 {:.1f} {:.1f}\"/>", body.x + arc_radius, body.y,
                       arc_radius, arc_radius, end.x, end.y);
}

// at the arc, else at its begin
std::string incidence_name(double angle, Crowd& crowd) {
    const double shown = std::clamp(angle, 0.0, 180.0) * std::numbers::pi / 180.0;
    std::vector<Point> candidates;
    for (const double radius : {arc_radius + 13.0, arc_radius - 13.0, arc_radius + 24.0})
        for (const double share : {0.5, 0.4, 0.3, 0.2, 0.6, 0.7, 0.8})
            candidates.push_back({body.x + radius * std::cos(share * shown) - 0.5 * letter_length,
                                  body.y - radius * std::sin(share * shown) + 4.0});
    candidates.push_back({body.x + 68, body.y + 4});
    return sign(crowd.place(candidates, letter_length), "α");
}

// under all joints, so much longer than under one
std::string plate(const parameters::Case& c, double longer) {
    std::string text =
        fmt::format("<rect x=\"20\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"currentColor\" fill-opacity=\"0.08\"/>",
                    contact.y, 300.0 + longer, thickness);
    text += support({contact.x, contact.y + thickness}, {contact.x, height - 12.0});
    text += sign({contact.x + 18, contact.y + 48}, "k", "2y") + sign({contact.x - 36, contact.y + 48}, "c", "2y");
    text += sign({28, contact.y + 14}, "m", "2");
    const double right = 262 + longer;
    text += arrow({right, contact.y + 36}, {right + 50, contact.y + 36});
    const bool is_constant = parameters::is_steady(c.drive);
    const std::string value = is_constant ? fmt::format("{:.4g} m/s", std::abs(c.drive.velocity)) : "";
    // a long value begins further to the left
    constexpr double letter = 6.5;  // [px] width of a digit
    const double room = width + longer - 6.0 - letter * static_cast<double>(value.size() + 4);
    return text + sign({std::min(right, room), contact.y + 54}, "V", "", value);
}

// the preload comes from above, where no support is
std::string preload(Crowd& crowd) {
    double best = body.x;
    double most = -1.0;
    for (const double aside : {-20.0, 20.0, -14.0, 14.0, 0.0, -8.0, 8.0}) {
        const double x = body.x + aside;
        const double room = crowd.room({x, body.y - 72}, {x, body.y - 34});
        if (room > most + 0.1) {
            most = room;
            best = x;
        }
    }
    crowd.add({best, body.y - 72}, {best, body.y - 22});
    std::vector<Point> candidates;
    for (const double y : {body.y - 66, body.y - 58, body.y - 50})
        for (const double x : {best - letter_length - 7.0, best + 7.0})
            candidates.push_back({x, y});
    candidates.push_back({best - 0.5 * letter_length, body.y - 78});
    return arrow({best, body.y - 72}, {best, body.y - 22}) + sign(crowd.place(candidates, letter_length), "F");
}

// below the plate, where nothing else is
std::string values(const parameters::PlateJoint& of) {
    constexpr double left = 20.0;
    return sign({left, contact.y + 50}, "F", "", fmt::format("{:.4g} N", of.contact.preload)) +
           sign({left, contact.y + 67}, "α", "", fmt::format("{:g}°", of.joint.incidence_angle)) +
           sign({left, contact.y + 84}, "μ", "d", fmt::format("{:g}", of.contact.kinetic_friction));
}

std::string joint() {
    std::string text = fmt::format(
        "<path d=\"M {0:.1f} {1:.1f} l -9 -10 h -16 v -32 q 0 -5 5 -5 h 40 q 5 0 5 5 v 32 h -16 z\" "
        "style=\"fill:var(--paper,#fff)\" stroke-width=\"1.6\"/>",
        contact.x, contact.y);
    text += sign({contact.x - 10, body.y + 3}, "m", "1");
    return text + sign({contact.x + 32, contact.y - 10}, "μ", "d");
}

// the joint, how it is held and pressed, and what all of it is called
std::string joint_part(const parameters::PlateJoint& of) {
    const double angle = of.joint.incidence_angle;
    const std::array<Support, 2> supports = joint_supports(angle);
    Crowd crowd;
    crowd.add({body.x - 25, body.y - 19}, {body.x + 25, body.y - 19});
    crowd.add({body.x - 25, body.y - 19}, {body.x - 25, body.y + 18});
    crowd.add({body.x + 25, body.y - 19}, {body.x + 25, body.y + 18});
    crowd.add({0, contact.y}, {width, contact.y});
    crowd.add_text({contact.x + 32, contact.y - 10}, index_length);
    std::string text;
    for (const Support& each : supports)
        text += drawn(each, crowd);
    text += incidence(angle, crowd) + preload(crowd) + incidence_name(angle, crowd);
    for (const Support& each : supports)
        text += names(each, crowd);
    return text + joint();
}

}  // namespace

namespace {

// one of several joints in its place, with its name above its values
std::string joint_in_place(const parameters::PlateJoint& of, std::size_t place) {
    const std::string name = fmt::format("<text x=\"20\" y=\"{:.1f}\" font-weight=\"bold\">{}</text>", contact.y + 34,
                                         base::markup_text(of.name));
    return fmt::format("<g transform=\"translate({:.1f} 0)\">", static_cast<double>(place) * width) + joint_part(of) +
           name + values(of) + "</g>";
}

std::string joints_in_place(const parameters::Case& c) {
    if (!parameters::has_several_joints(c)) return joint_part(c.joints.front()) + values(c.joints.front());
    std::string text;
    for (std::size_t joint = 0; joint < c.joints.size(); ++joint)
        text += joint_in_place(c.joints[joint], joint);
    return text;
}

}  // namespace

std::string sketch_svg(const parameters::Case& c) {
    const double longer = static_cast<double>(c.joints.size() - 1) * width;
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" fill=\"none\" stroke=\"currentColor\" "
               "stroke-width=\"1.2\" stroke-linecap=\"round\" stroke-linejoin=\"round\">"
               "<style>.stridor-sketch text{{fill:currentColor;stroke:none;font:13px serif}}</style>"
               "<g class=\"stridor-sketch\">",
               width + longer, height) +
           plate(c, longer) + joints_in_place(c) + "</g></svg>";
}

}  // namespace stridor::report
