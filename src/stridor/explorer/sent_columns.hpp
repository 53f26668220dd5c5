#pragma once

#include "stridor/base/packed_bytes.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/record/trace.hpp"

#include <bit>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace stridor::explorer {

// Arrays as bytes, little endian as every browser's typed arrays are, and as text for JSON.

static_assert(std::endian::native == std::endian::little, "arrays are handed over as they lie in memory");

/// Returns numbers as they lie in memory, lowest byte first.
template <typename T>
std::string bytes_of(std::span<const T> values) {
    return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

/// Returns the bytes of numbers, as they lie in memory, in base 64.
template <typename T>
std::string base64_of(std::span<const T> values) {
    return base::base64({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
}

/// A column of the motion that is sent to the page, under the page's name for it.
struct SentColumn {
    std::string name;
    std::string unit;
    std::string sentence;
    std::function<void(const record::Trace&, std::vector<float>&)> add;  // its samples of a block, behind those before
};

/// Returns the columns of a case's motion: displacements and velocities, the surface's velocity, each contact's forces
/// and gap.
///
/// For joints on a plate they are "x1", "y1" and "y2", for several joints "x_lip2" and "y_plate". For an own structure
/// they are the motion of its contacts, along the tangent ("x1", of several "x_NAME") and along the normal ("y1",
/// "y_NAME"), the velocity of its outputs ("velocity_NAME") and the points of its outline ("outline_3_x",
/// "outline_3_y", from 1 on; without those that cannot move). Its rows are not sent: a part has thousands.
std::vector<SentColumn> sent_columns(const parameters::Case& c);

}  // namespace stridor::explorer
