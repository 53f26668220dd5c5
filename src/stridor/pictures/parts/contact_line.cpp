#include "stridor/pictures/parts/contact_line.hpp"

#include "stridor/parameters/own_structure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace stridor::pictures {

namespace {

constexpr double bar = 0.4;  // [1] half of a bar's width, of the way to the nearest neighbour

// Way from each place to the nearest other one; zero where two contacts are at one place. Shape [contact].
std::vector<double> ways_to_neighbours(const ContactLine& line) {
    std::vector<double> ways(line.places.size(), std::numeric_limits<double>::infinity());
    for (std::size_t k = 1; k < line.order.size(); ++k) {
        const std::size_t left = line.order[k - 1], right = line.order[k];
        const double way = line.places[right] - line.places[left];
        ways[left] = std::min(ways[left], way);
        ways[right] = std::min(ways[right], way);
    }
    return ways;
}

void number_contacts(ContactLine& line) {
    std::iota(line.order.begin(), line.order.end(), std::size_t{0});
    std::iota(line.places.begin(), line.places.end(), 1.0);
}

// takes the places that the case knows; false where it does not know them, or two are one
bool place_contacts(ContactLine& line, const parameters::Case& c) {
    if (!c.own_structure) return false;
    std::vector<double> places = parameters::places_along_line(*c.own_structure);
    if (places.empty()) return false;
    line.places = std::move(places);
    std::sort(line.order.begin(), line.order.end(),
              [&](std::size_t a, std::size_t b) { return line.places[a] < line.places[b]; });
    const std::vector<double> ways = ways_to_neighbours(line);
    return *std::min_element(ways.begin(), ways.end()) > 0.0;
}

}  // namespace

ContactLine contact_line(const parameters::Case& c) {
    const std::size_t contacts = parameters::contact_count(c);
    ContactLine line;
    line.order.resize(contacts);
    line.places.resize(contacts);
    number_contacts(line);
    if (place_contacts(line, c)) {
        line.axis.label = "place along the line";
        line.axis.unit = "m";
    } else {
        number_contacts(line);
        line.axis.label = "contact";
        for (std::size_t k = 0; k < contacts; ++k)
            line.axis.ticks.push_back({line.places[k], parameters::contact_name(c, k), drawing::TickSize::major});
    }
    std::vector<double> ways = ways_to_neighbours(line);
    for (double& way : ways)
        way = std::isfinite(way) ? way : 1.0;  // of a single contact
    for (std::size_t k = 0; k < contacts; ++k)
        line.bars.push_back({line.places[k] - bar * ways[k], line.places[k] + bar * ways[k]});
    const std::size_t first = line.order.front(), last = line.order.back();
    line.axis.range = {line.places[first] - 0.5 * ways[first], line.places[last] + 0.5 * ways[last]};
    return line;
}

}  // namespace stridor::pictures
