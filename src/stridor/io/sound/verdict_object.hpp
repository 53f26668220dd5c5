#pragma once

#include "stridor/base/json.hpp"
#include "stridor/classification/recording_verdict.hpp"

namespace stridor::io {

/// Returns the verdict on a channel as a member of a document. `reference` is the quantity of 0 dB.
base::Json verdict_object(const classification::RecordingVerdict& verdict, double reference);

}  // namespace stridor::io
