#include "peers/agreement.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace stridor::peers {

namespace {

using record::ContactHistory;

std::array<double, model::contact_states> rates(const ContactHistory& history, double until) {
    std::array<double, model::contact_states> shares{};
    for (const record::ContactInterval& interval : history)
        shares[model::index_of(interval.state)] += std::max(0.0, std::min(interval.to, until) - interval.from) / until;
    return shares;
}

// number of the first change of `history` from number `start` on that enters a state at about a time;
// its size if there is none
std::size_t find(const ContactHistory& history, std::size_t start, const record::ContactInterval& entered,
                 double tolerance) {
    for (std::size_t k = start; k < history.size() && history[k].from <= entered.from + tolerance; ++k)
        if (history[k].state == entered.state && history[k].from >= entered.from - tolerance) return k;
    return history.size();
}

// numbers of the changes that lie strictly between two common ones
struct Between {
    std::size_t after, before;
    std::size_t count() const { return before - after - 1; }
};

// the same states in the same order: late or early, but none missed
bool are_alike(const ContactHistory& a, Between in_a, const ContactHistory& b, Between in_b) {
    if (in_a.count() != in_b.count()) return false;
    for (std::size_t k = 1; k <= in_a.count(); ++k)
        if (a[in_a.after + k].state != b[in_b.after + k].state) return false;
    return true;
}

// the next two changes enter the same states: only their times differ
bool goes_on_alike(const ContactHistory& a, std::size_t after_a, const ContactHistory& b, std::size_t after_b) {
    for (std::size_t k = 0; k < 2; ++k) {
        const bool has_a = after_a + k < a.size(), has_b = after_b + k < b.size();
        if (!has_a || !has_b) return has_a == has_b;
        if (a[after_a + k].state != b[after_b + k].state) return false;
    }
    return true;
}

}  // namespace

Agreement agreement(const ContactHistory& reference, const ContactHistory& found, double tolerance) {
    Agreement result;
    std::size_t last_reference = 0, last_found = 0;  // number of the last common change; 0 is the start
    for (std::size_t k = 1; k < reference.size() && k - last_reference <= lost_changes; ++k) {
        const std::size_t other = find(found, last_found + 1, reference[k], tolerance);
        if (other == found.size()) continue;
        const Between ours{last_reference, k}, theirs{last_found, other};
        if (are_alike(reference, ours, found, theirs)) {
            result.common += static_cast<int>(ours.count());
        } else {
            result.missed += static_cast<int>(ours.count());
            result.extra += static_cast<int>(theirs.count());
        }
        ++result.common;
        last_reference = k;
        last_found = other;
    }
    const bool is_complete = last_reference + 1 == reference.size() && last_found + 1 == found.size();
    result.until = is_complete ? reference.back().to : reference[last_reference].from;
    if (!is_complete)
        result.parting =
            goes_on_alike(reference, last_reference + 1, found, last_found + 1) ? Parting::drift : Parting::event;
    return result;
}

double rate_error(const ContactHistory& reference, const ContactHistory& found, double until) {
    const auto a = rates(reference, until), b = rates(found, until);
    double largest = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k)
        largest = std::max(largest, std::abs(a[k] - b[k]));
    return largest;
}

}  // namespace stridor::peers
