#include "stridor/base/error.hpp"

#include "stridor/base/check.hpp"

#include <utility>

namespace stridor::base {

namespace {

std::string sentence(const Complaint& complaint) {
    const auto& [problem, place] = complaint;
    std::string text = problem.what;
    if (!problem.why.empty()) text += " (" + problem.why + ")";
    if (!problem.suggestion.empty()) text += ". " + problem.suggestion;
    if (place) text += " [" + describe(*place) + "]";
    return text;
}

std::string sentences(const std::vector<Complaint>& complaints) {
    std::string text;
    for (const Complaint& complaint : complaints)
        text += (text.empty() ? "" : "\n") + sentence(complaint);
    return text;
}

}  // namespace

Error::Error(ErrorKind kind, Problem problem, std::optional<Place> place)
    : Error(std::vector{Complaint{std::move(problem), std::move(place)}}, kind) {}

Error::Error(std::vector<Complaint> complaints, ErrorKind kind)
    : std::runtime_error(sentences(complaints)),
      kind_(kind),
      complaints_(std::move(complaints)) {
    STRIDOR_EXPECT(!complaints_.empty());
}

void refuse(std::string what, std::string why, std::string suggestion) {
    throw Error(ErrorKind::input, {std::move(what), std::move(why), std::move(suggestion)});
}

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
