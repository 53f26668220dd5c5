#pragma once

#include "stridor/integration/cost.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/reduction/part_contacts.hpp"
#include "stridor/reduction/part_figures.hpp"
#include "stridor/reduction/reduction_errors.hpp"

#include <string>

namespace stridor::console {

/// Returns a case resolved: its fields by section, natural frequencies, what a run of it costs.
std::string case_text(const parameters::Case& c, const integration::Cost& cost);

/// Returns what a part holds, in SI.
std::string part_text(const reduction::ElasticPart& part, const reduction::PartSize& size);

/// Returns its rigid-body modes and frequencies.
std::string vibration_text(const reduction::PartVibration& vibration);

/// Returns what its contacts meet in an impact.
std::string part_contacts_text(const reduction::PartContacts& contacts);

/// Returns what a reduction kept, and its errors.
std::string reduction_text(const reduction::Reduction& reduction, const reduction::ReductionErrors& errors);

}  // namespace stridor::console
