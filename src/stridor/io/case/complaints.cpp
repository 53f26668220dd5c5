#include "stridor/io/case/complaints.hpp"

#include <algorithm>
#include <tuple>

namespace stridor::io {

namespace {

bool is_same(const base::Complaint& a, const base::Complaint& b) {
    const auto where = [](const base::Complaint& each) { return each.place ? base::describe(*each.place) : ""; };
    return a.problem.what == b.problem.what && where(a) == where(b);
}

// an override's place names the option instead of a file
auto rank(const base::Complaint& complaint) {
    const base::Place place = complaint.place.value_or(base::Place{});
    const int group = place.line > 0 ? 0 : place.file.starts_with("--") ? 2 : 1;
    return std::tuple(group, place.line, place.column);
}

}  // namespace

void Complaints::add(const Error& error) {
    for (const base::Complaint& complaint : error.complaints())
        if (std::none_of(all_.begin(), all_.end(), [&](const auto& known) { return is_same(known, complaint); }))
            all_.push_back(complaint);
}

void Complaints::throw_any() const {
    if (all_.empty()) return;
    std::vector<base::Complaint> sorted = all_;
    std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return rank(a) < rank(b); });
    throw Error::of(ErrorKind::input, std::move(sorted));
}

}  // namespace stridor::io
