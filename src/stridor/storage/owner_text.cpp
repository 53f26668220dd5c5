#include "stridor/storage/owner_text.hpp"

#include <fmt/format.h>

#include <charconv>

namespace stridor::storage {

namespace {

constexpr double minute = 60.0;  // [s]
constexpr double hour = 3600.0;  // [s]

template <typename Number>
Number number_in(std::string_view text) {
    Number number{};
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

}  // namespace

std::string owner_text(const Owner& owner) {
    return fmt::format(
        "host = {}\nprocess = {}\njob = {}\nmark = {}\nlock = {}\nfiles = {}\ncount = {:<20}\nchanges = {:<20}\n",
        owner.host.substr(0, 255), owner.process, owner.job.substr(0, 255), owner.mark,
        owner.has_lock ? "own " : "none", owner.has_files ? "own " : "left", owner.count, owner.changes);
}

Owner read_owner(std::string_view text) {
    Owner owner;
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(text.size(), line.size() + 1));
        const std::size_t sign = line.find(" = ");
        if (sign == std::string_view::npos) continue;
        const std::string_view key = line.substr(0, sign);
        const std::string_view value = line.substr(sign + 3);
        if (key == "host") owner.host = value;
        if (key == "process") owner.process = number_in<long>(value);
        if (key == "job") owner.job = value;
        if (key == "mark") owner.mark = value;
        if (key == "lock") owner.has_lock = value != "none";
        if (key == "files") owner.has_files = value != "left";
        if (key == "count") owner.count = number_in<std::uint64_t>(value);
        if (key == "changes") owner.changes = number_in<std::uint64_t>(value);
    }
    return owner;
}

std::string text_of(const Owner& owner) {
    if (owner.host.empty()) return "somebody unknown";
    return fmt::format("process {} of host {}", owner.process, owner.host) +
           (owner.job.empty() ? "" : ", job " + owner.job);
}

std::string ago_text(double silence) {
    // by clocks that differ
    if (silence < -2.0 * hour) return fmt::format("{:.0f} h from now", -silence / hour);
    if (silence < -minute) return fmt::format("{:.0f} min from now", -silence / minute);
    if (silence < 2.0 * minute) return fmt::format("{:.0f} s ago", silence < 0.0 ? 0.0 : silence);
    if (silence < 2.0 * hour) return fmt::format("{:.0f} min ago", silence / minute);
    return fmt::format("{:.0f} h ago", silence / hour);
}

}  // namespace stridor::storage
