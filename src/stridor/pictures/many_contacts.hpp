#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/record/recorder.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace stridor::pictures {

/// The contacts of a case along their line: in metres if all places are known and differ, else numbered from 1 in the
/// order of the case.
struct ContactLine {
    std::vector<std::size_t> order;     // contacts from one end of the line to the other
    std::vector<double> places;         // along the axis, shape [contact]
    std::vector<drawing::Extent> bars;  // the extent of a contact's bar on the axis, shape [contact]
    drawing::PanelAxis axis;            // ticks with the contacts' names if they are numbered
};

/// Returns the places of the contacts of a case in a picture. A bar takes four fifths of the way to the nearest
/// neighbour.
ContactLine contact_line(const parameters::Case& c);

/// Says whether a case is shown contact by contact. That is a case with an own structure and several contacts, whose
/// rows would have too many curves.
bool shows_many_contacts(const parameters::Case& c);

/// Draws every contact of a run along their line, by their places if the case knows them, else in their order. For each
/// phase it shows the share of the judged time in each state, stacked, beside the mean normal force and the force at
/// rest; below them the states over the whole run and over a stretch of it, one row a contact, the first on top.
///
/// If a contact changes its state too often to be drawn, its row is split at each instant by the shares of the time
/// around it, stacked as above. The record needs a history.
drawing::Scene many_contacts(const parameters::Case& c, const record::Record& record,
                             const std::optional<drawing::Extent>& stretch);

/// Returns the length of a stretch [s] with some twenty stays of the contact that changes its state most often in the
/// judged part: 1, 2 or 5 times a power of ten, at most the run; a tenth of the run if no contact changes there.
double telling_length(const parameters::Case& c, const record::Record& record);

}  // namespace stridor::pictures
