#include "support/shrink.hpp"

#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/parameters/rules/check.hpp"

#include <charconv>
#include <variant>
#include <vector>

namespace stridor::support {

namespace {

using parameters::Case;
using parameters::Field;

double with_digits(double value, int digits) {
    char text[32];
    const auto printed = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, digits - 1);
    double rounded = value;
    std::from_chars(text, printed.ptr, rounded);
    return rounded;
}

// the same case with one field made plainer, plainest first
std::vector<Case> plainer(const Case& c, const Field& field) {
    const Case plain = parameters::paper_case(parameters::PaperCase::squeal);
    std::vector<Case> cases;
    const auto offer = [&](const auto& kind, auto value) {
        if (kind.get(c) == value) return;
        kind.set(cases.emplace_back(c), value);
    };
    if (const auto* choice = std::get_if<parameters::Choice>(&field.kind)) offer(*choice, choice->get(plain));
    if (const auto* quantity = std::get_if<parameters::Quantity>(&field.kind)) {
        if (quantity->get(c) == quantity->get(plain)) return {};
        offer(*quantity, quantity->get(plain));
        for (const int digits : {1, 2, 4}) {
            const double value = with_digits(quantity->get(c), digits);
            if (value >= quantity->range.low && value <= quantity->range.high) offer(*quantity, value);
        }
    }
    return cases;
}

// the same case with the paper's drive, which needs its time: no field alone could become plain
Case with_plain_drive(Case c) {
    const Case plain = parameters::paper_case(parameters::PaperCase::squeal);
    c.drive = plain.drive;
    c.run.duration = plain.run.duration;
    c.run.window = plain.run.window;
    return c;
}

bool shrink_field(Case& c, const Field& field, const std::function<bool(const Case&)>& fails) {
    for (const Case& candidate : plainer(c, field))
        if (parameters::findings(candidate).empty() && fails(candidate)) {
            c = candidate;
            return true;
        }
    return false;
}

}  // namespace

Case shrunk(Case c, const std::function<bool(const Case&)>& fails) {
    // a field may become dispensable once another is plain: so until nothing changes, at most some rounds
    constexpr int most_rounds = 5;
    if (const Case plain = with_plain_drive(c); fails(plain)) c = plain;
    bool has_changed = true;
    for (int round = 0; round < most_rounds && has_changed; ++round) {
        has_changed = false;
        for (const Field& field : parameters::fields())
            if (field.belongs(c)) has_changed = shrink_field(c, field, fails) || has_changed;
    }
    return c;
}

std::string command_of(const Case& c) {
    const Case plain = parameters::paper_case(parameters::PaperCase::squeal);
    std::string command = "stridor init squeal -o squeal.toml; stridor simulate squeal.toml";
    for (const Field& field : parameters::fields()) {
        if (!field.belongs(c)) continue;
        const std::string value = parameters::value_text(c, field);
        if (field.belongs(plain) && value == parameters::value_text(plain, field)) continue;
        command += " --set " + parameters::key_of(field) + "='" + value + "'";
    }
    return command;
}

}  // namespace stridor::support
