#pragma once

#include "stridor/integration/contact_coordinates.hpp"
#include "stridor/integration/exact_tables.hpp"

namespace stridor::integration {

/// Prepares the contact states of a structure; `drive_frequency` [Hz] is 0 unless the drive is sinusoidal.
template <int dofs>
Flows prepare_flows(const ContactCoordinates<dofs>& coordinates, const model::Coulomb& friction,
                    double drive_frequency);

extern template Flows prepare_flows<2>(const ContactCoordinates<2>&, const model::Coulomb&, double);
extern template Flows prepare_flows<3>(const ContactCoordinates<3>&, const model::Coulomb&, double);

}  // namespace stridor::integration
