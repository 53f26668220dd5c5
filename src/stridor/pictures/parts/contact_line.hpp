#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/parameters/case.hpp"

#include <cstddef>
#include <vector>

namespace stridor::pictures {

/// The contacts of a case along their line: in metres where all places are known and differ, else numbered from 1 in
/// the order of the case.
struct ContactLine {
    std::vector<std::size_t> order;     // contacts from one end of the line to the other
    std::vector<double> places;         // along the axis, shape [contact]
    std::vector<drawing::Extent> bars;  // what a contact's bar takes of the axis, shape [contact]
    drawing::PanelAxis axis;            // ticks with the contacts' names where they are numbered
};

/// Where the contacts of a case are drawn, on an axis whose names may take `names_width` [mm]. A bar takes four fifths
/// of the way to the nearest neighbour.
ContactLine contact_line(const parameters::Case& c, double names_width);

/// Of `contacts` names on an axis of `space` [mm], every so many are shown where each takes `taken` [mm].
std::size_t named_every(std::size_t contacts, double taken, double space);

}  // namespace stridor::pictures
