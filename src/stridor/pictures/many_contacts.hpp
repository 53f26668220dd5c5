#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/record/recorder.hpp"

#include <cstddef>
#include <optional>
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

/// Is a case shown contact by contact? One with its own structure and several contacts: the motion of its rows would be
/// too many curves.
bool shows_many_contacts(const parameters::Case& c);

/// Every contact of a run along their line, by their places where the case knows them, else in their order: for each
/// phase the share of the judged time in each state, stacked, beside the mean normal force and what presses at rest;
/// below them their states over the whole run and over a stretch of it, one row a contact, the first on top.
///
/// Where a contact changes its state too often to be drawn, its row is split at each instant by the shares of the time
/// around it, stacked as above. The record needs a history.
drawing::Scene many_contacts(const parameters::Case& c, const record::Record& record,
                             const std::optional<drawing::Extent>& stretch);

/// How long a stretch shows some twenty stays of the contact that changes its state most often in the judged part [s]:
/// 1, 2 or 5 times a power of ten, at most the run; a tenth of the run if none changes there.
double telling_length(const parameters::Case& c, const record::Record& record);

}  // namespace stridor::pictures
