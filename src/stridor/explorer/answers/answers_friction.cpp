#include "stridor/explorer/answers/answers.hpp"
#include "stridor/model/laws/friction.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/pictures/friction_law.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

namespace stridor::explorer {

namespace {

using parameters::Contact;
using parameters::FrictionKind;

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double least_velocity_share = 1e-3;  // [1] of the picture: no velocity of a law is dragged to 0
constexpr double room_beside = 1.3;            // [1] of the speeds visited, where the law has no scale of its own
constexpr double law_samples = 1e4;            // [1] of the window, of which the extremes are told
constexpr std::size_t most_rows = 60;          // of a table; more are no points for a hand

enum class GripWay { speed, friction };

// A point of the curve that a hand may move one way. What it sets is origin + rate times where it is along that way.
struct Grip {
    std::string_view key;
    double speed = 0.0;                        // [m/s]
    double friction = 0.0;                     // [1]
    GripWay along = GripWay::friction;         // which way it moves
    double low = 0.0, high = unlimited;        // between which it may
    double origin = 0.0, rate = 1.0;           // of what it sets
    std::string_view way = "both directions";  // whose slip it belongs to
};

std::vector<Grip> coefficients_of(const Contact& contact, double edge) {
    const auto pair = [&](std::string_view static_key, double mu_s, std::string_view kinetic_key, double mu_d,
                          std::string_view way) {
        return std::vector<Grip>{{.key = static_key, .friction = mu_s, .low = mu_d, .way = way},
                                 {.key = kinetic_key, .speed = 0.5 * edge, .friction = mu_d, .high = mu_s, .way = way}};
    };
    if (contact.friction != FrictionKind::directional)
        return pair("contact.static_friction", contact.static_friction, "contact.kinetic_friction",
                    contact.kinetic_friction, "both directions");
    std::vector<Grip> grips = pair("contact.static_friction", contact.static_friction, "contact.kinetic_friction",
                                   contact.kinetic_friction, "going");
    const std::vector<Grip> coming = pair("contact.static_friction_coming", contact.static_friction_coming,
                                          "contact.kinetic_friction_coming", contact.kinetic_friction_coming, "coming");
    grips.insert(grips.end(), coming.begin(), coming.end());
    return grips;
}

double resistance_at(const Contact& contact, double speed) {
    return slip_ratio(model::friction_law(contact), model::Slip::backward, -speed);
}

std::vector<Grip> grips_of(const Contact& contact, double edge) {
    const double mu_s = contact.static_friction, mu_d = contact.kinetic_friction;
    const double least = least_velocity_share * edge;
    switch (contact.friction) {
        case FrictionKind::coulomb:
        case FrictionKind::directional:
            return coefficients_of(contact, edge);
        case FrictionKind::linear: {
            // the line goes through (0, mu_d)
            const double speed = 0.5 * edge;
            return {{.key = "contact.static_friction", .friction = mu_s, .low = mu_d},
                    {.key = "contact.kinetic_friction", .friction = mu_d, .high = mu_s},
                    {.key = "contact.friction_slope",
                     .speed = speed,
                     .friction = resistance_at(contact, speed),
                     .high = mu_d,
                     .origin = mu_d / speed,
                     .rate = -1.0 / speed}};
        }
        case FrictionKind::stribeck:
        case FrictionKind::stribeck_rational:
        case FrictionKind::lugre: {
            // at the edge it has mu_d (1 - g) + mu_s g + k_v V, where g is what is left of the fall
            const double viscous = contact.viscous_friction * edge;
            const double left = mu_s > mu_d ? (resistance_at(contact, edge) - mu_d - viscous) / (mu_s - mu_d) : 0.0;
            const double v_s = contact.stribeck_velocity;
            return {{.key = "contact.static_friction", .friction = mu_s, .low = mu_d},
                    {.key = "contact.kinetic_friction",
                     .speed = edge,
                     .friction = resistance_at(contact, edge),
                     .low = mu_s * left + viscous,
                     .high = mu_s + viscous,
                     .origin = -(mu_s * left + viscous) / (1.0 - left),
                     .rate = 1.0 / (1.0 - left)},
                    {.key = "contact.stribeck_velocity",
                     .speed = v_s,
                     .friction = resistance_at(contact, v_s),
                     .along = GripWay::speed,
                     .low = least}};
        }
        case FrictionKind::tanh:
        case FrictionKind::arctan:
            return {{.key = "contact.kinetic_friction", .speed = edge, .friction = mu_d},
                    {.key = "contact.regularisation",
                     .speed = contact.regularisation,
                     .friction = resistance_at(contact, contact.regularisation),
                     .along = GripWay::speed,
                     .low = least}};
        case FrictionKind::dieterich:
        case FrictionKind::ruina:
            return {{.key = "contact.kinetic_friction",
                     .speed = contact.reference_velocity,
                     .friction = resistance_at(contact, contact.reference_velocity)}};
        case FrictionKind::table:
            break;  // its rows are points
    }
    return {};
}

Json grip_object(const Grip& grip) {
    return {{"key", grip.key},
            {"speed", grip.speed},
            {"friction", grip.friction},
            {"along", grip.along == GripWay::speed ? "speed" : "friction"},
            {"low", grip.low},
            {"high", grip.high},  // null where it has no end
            {"origin", grip.origin},
            {"rate", grip.rate},
            {"way", grip.way}};
}

// between which speeds the first joint slips in the window; null where it never does, or where nobody asks
Json visited_object(const parameters::Case& c, const Json& body, const std::stop_token& stop) {
    const bool is_asked = body.contains("visited") && body.at("visited") == true;
    if (!is_asked) return nullptr;
    record::Request request;
    request.trace = {c.run.duration - c.run.window, c.run.duration, c.run.window / law_samples};
    const std::optional<drawing::Extent> visited =
        pictures::visited_velocities(c, run_case(c, request, stop).record.trace);
    if (!visited) return nullptr;
    const bool has_turned = visited->from <= 0.0 && visited->to >= 0.0;
    return {{"from", has_turned ? 0.0 : std::min(std::abs(visited->from), std::abs(visited->to))},
            {"to", std::max(std::abs(visited->from), std::abs(visited->to))}};
}

}  // namespace

Response friction(const World& world, const Json& body, const std::stop_token& stop) {
    const parameters::Case c = case_in(world, body);
    const Contact contact = pictures::one_law(c);
    const Json visited = visited_object(c, body, stop);
    // a page whose hand is on a point asks for no run, and keeps the picture as wide as it was
    const double reach = visited.is_null() ? number_in(body, "reach", 0.0) : visited.at("to").get<double>();
    pictures::LawCurve curve = pictures::law_curve(contact, drawing::Extent{0.0, reach});
    if (reach > 0.0 && parameters::is_state_wise(contact.friction)) curve.speeds.back() = room_beside * reach;
    Json document{{"schema", "stridor.explorer.friction/1"},
                  {"friction", parameters::value_text(c, "contact.friction")},
                  {"speeds", curve.speeds},
                  {"curves", Json::array()},
                  {"grips", Json::array()},
                  {"rows", Json::array()},
                  {"visited", visited}};
    const bool is_the_same = curve.resistances[0] == curve.resistances[1] && curve.limits[0] == curve.limits[1];
    const bool creeps =
        parameters::is_regularised(contact.friction) || parameters::has_friction_state(contact.friction);
    const auto add = [&](const char* way, model::Slip slip) {
        document["curves"].push_back({{"way", way},
                                      {"limit", creeps ? Json(nullptr) : Json(curve.limits[index_of(slip)])},
                                      {"friction", curve.resistances[index_of(slip)]}});
    };
    // steady sliding over a surface that moves going lags behind it
    add(is_the_same ? "both directions" : "going", model::Slip::backward);
    if (!is_the_same) add("coming", model::Slip::forward);
    for (const Grip& grip : grips_of(contact, curve.speeds.back()))
        document["grips"].push_back(grip_object(grip));
    const parameters::FrictionTable& table = contact.friction_table;
    if (contact.friction == FrictionKind::table && table.speeds.size() <= most_rows)
        for (std::size_t row = 0; row < table.speeds.size(); ++row)
            document["rows"].push_back({{"speed", table.speeds[row]}, {"friction", table.coefficients[row]}});
    return json(document.dump());
}

}  // namespace stridor::explorer
