#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/sweep/following.hpp"

namespace stridor::pictures {

/// Draws a motion that was followed along a quantity: a figure of it over the quantity, a column per direction, with
/// the way up and the way down as two lines. The mark of a run is filled with the colour of its verdict. Where the ways
/// have other verdicts the ground is tinted.
drawing::Scene following(const sweep::Following& following, const sweep::CellFigure& figure);

}  // namespace stridor::pictures
