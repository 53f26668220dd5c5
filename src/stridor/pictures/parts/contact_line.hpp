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

/// Where the contacts of a case are drawn. A bar takes four fifths of the way to the nearest neighbour.
ContactLine contact_line(const parameters::Case& c);

}  // namespace stridor::pictures
