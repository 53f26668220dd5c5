#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/sweep/study.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Makes axes and captions from the field table, so that every picture uses one name, symbol and unit for a quantity.
namespace stridor::pictures {

/// Returns the edges of the cells around an axis' values: midpoints in the axis' own scale (arithmetic or geometric),
/// the outer edges half a cell beyond the ends; shape [points + 1].
std::vector<double> cell_edges(const sweep::Axis& axis);

/// Returns the axis of a chart: name, symbol, unit and scale of the quantity, after the name of its joint if it has
/// one; from the first cell's edge to the last one's.
drawing::PanelAxis field_axis(const sweep::Axis& axis);

/// Returns a name in words: "early ending" for "early_ending".
std::string spelled(std::string_view name);

/// Returns name and symbol of a field: "kinetic friction μ_d".
drawing::StyledText field_label(const parameters::Field& field);

/// Returns a field with its value: "α = 70°", "F = 20 N", of one of several joints "lip2: F = 20 N". A field without a
/// symbol has its name.
drawing::StyledText setting(const parameters::Case& c, std::string_view key);

/// Returns a number beside its unit: "20 N", "70°", "0.6".
drawing::StyledText with_unit(const drawing::StyledText& number, std::string_view unit);

/// Returns settings in a row, separated by commas; fields without a meaning for the case are left out.
drawing::StyledText settings(const parameters::Case& c, std::span<const std::string_view> keys);

/// Returns all that a reader needs to repeat a picture of this case: the contact, the drive, the start and the time
/// step, without the fields named in `varied`. If the temperature varies, quantities that depend on it by table are
/// named without a value.
drawing::StyledText conditions(const parameters::Case& c, std::span<const std::string_view> varied = {});

/// Returns a panel's title behind "a) ", "b) " ...
drawing::StyledText lettered(std::size_t panel, const drawing::StyledText& title);

}  // namespace stridor::pictures
