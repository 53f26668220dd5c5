#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/parameters/field.hpp"
#include "stridor/sweep/study.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

/// From the field table to axes and captions, so that every picture calls a quantity by the same name, symbol and unit.
namespace stridor::pictures {

/// Edges of the cells around an axis' values: midpoints in the axis' own scale (arithmetic or geometric), the outer
/// edges half a cell beyond the ends; shape [points + 1].
std::vector<double> cell_edges(const sweep::Axis& axis);

/// The axis of a chart: name, symbol, unit and scale of the quantity, after the name of the joint if it is of one; from
/// the first cell's edge to the last one's.
drawing::PanelAxis field_axis(const sweep::Axis& axis);

/// Returns a name in words: "early ending" for "early_ending".
std::string spelled(std::string_view name);

/// Name and symbol of a field: "kinetic friction μ_d".
drawing::StyledText field_label(const parameters::Field& field);

/// A field with its value: "α = 70°", "F = 20 N", of one of several joints "lip2: F = 20 N". Fields without a
/// symbol are called by their name.
drawing::StyledText setting(const parameters::Case& c, std::string_view key);

/// A number beside its unit: "20 N", "70°", "0.6".
drawing::StyledText with_unit(const drawing::StyledText& number, std::string_view unit);

/// Settings in a row, parted by commas; fields that mean nothing for the case are left out.
drawing::StyledText settings(const parameters::Case& c, std::span<const std::string_view> keys);

/// What a reader must know to repeat a picture of this case: the contact, the drive, the start and the time step,
/// without the fields named in `varied`. Where the temperature varies, what follows it by table is
/// named without a value.
drawing::StyledText conditions(const parameters::Case& c, std::span<const std::string_view> varied = {});

/// "a) ", "b) " ... before a panel's title.
drawing::StyledText lettered(std::size_t panel, const drawing::StyledText& title);

}  // namespace stridor::pictures
