#pragma once

#include "stridor/base/error.hpp"

#include <string>
#include <utility>

namespace stridor::recordings {

/// An error (input) in a file that is read, where it stands.
inline base::Error refusal(base::Place place, std::string what, std::string why = "", std::string suggestion = "") {
    return {base::ErrorKind::input, {std::move(what), std::move(why), std::move(suggestion)}, std::move(place)};
}

/// The same where only the file is known.
inline base::Error refusal(const std::string& file, std::string what, std::string why = "",
                           std::string suggestion = "") {
    return refusal(base::Place{file, 0, 0, ""}, std::move(what), std::move(why), std::move(suggestion));
}

}  // namespace stridor::recordings
