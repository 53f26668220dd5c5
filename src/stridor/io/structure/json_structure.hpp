#pragma once

#include "stridor/reduction/part_contacts.hpp"
#include "stridor/reduction/part_figures.hpp"
#include "stridor/reduction/reduction_errors.hpp"

#include <string>

namespace stridor::io {

/// Returns the content of a part (schema stridor.part/1), in SI; with its frequencies and its contacts unless null.
std::string part_json(const reduction::ElasticPart& part, const reduction::PartSize& size,
                      const reduction::PartVibration* vibration, const reduction::PartContacts* contacts = nullptr);

/// Returns the content of a reduction, and its errors (schema stridor.reduction/1).
std::string reduction_json(const reduction::Reduction& reduction, const reduction::ReductionErrors& errors);

}  // namespace stridor::io
