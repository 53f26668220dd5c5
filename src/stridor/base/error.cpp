#include "stridor/base/error.hpp"

#include <utility>

namespace stridor::base {

namespace {

std::string sentence(const Problem& problem, const std::optional<Place>& place) {
    std::string text = problem.what;
    if (!problem.why.empty()) text += " (" + problem.why + ")";
    if (!problem.suggestion.empty()) text += ". " + problem.suggestion;
    if (place) text += " [" + describe(*place) + "]";
    return text;
}

}  // namespace

Error::Error(ErrorKind kind, Problem problem, std::optional<Place> place)
    : std::runtime_error(sentence(problem, place)),
      kind_(kind),
      problem_(std::move(problem)),
      place_(std::move(place)) {}

int exit_code(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::input:
            return 2;
        case ErrorKind::numerical:
            return 3;
        case ErrorKind::interrupted:
            return 4;
        case ErrorKind::io:
            return 5;
    }
    return 5;
}

std::string describe(const Place& place) {
    std::string text = place.file;
    if (place.line > 0) text += ":" + std::to_string(place.line);
    if (place.line > 0 && place.column > 0) text += ":" + std::to_string(place.column);
    return text;
}

}  // namespace stridor::base
