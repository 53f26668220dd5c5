#include "stridor/verification/published.hpp"

#include "stridor/base/error.hpp"
#include "stridor/classification/verdict.hpp"
#include "stridor/io/case/ready_files.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/verification/published_cases.inc"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace stridor::verification {

std::string case_text(const PublishedSystem& system) {
    for (const EmbeddedFile& file : published_cases)
        if (file.name == system.file) return {file.bytes, file.bytes + file.size};
    const std::vector<std::string> ready = io::ready_file_names();
    if (std::find(ready.begin(), ready.end(), system.file) == ready.end())
        base::refuse("there is no case " + std::string(system.file), "", "");
    return io::ready_file(std::string(system.file));
}

parameters::Case case_of(const PublishedSystem& system, const PublishedNumber& number) {
    return io::read_case(io::TomlSource{case_text(system), std::string(system.file), number.set});
}

bool HeldNumber::agrees() const {
    return std::abs(difference()) <= published->tolerance;
}

HeldSystem held(const PublishedSystem& system) {
    HeldSystem found{&system, {}};
    for (const PublishedNumber& number : system.numbers)
        found.numbers.push_back({&number, number.measure(case_of(system, number), number.about)});
    return found;
}

bool is_word(const PublishedNumber& number) {
    return number.unit == category_unit || number.unit == motion_unit;
}

std::string number_text(const PublishedNumber& number, double value) {
    if (number.unit == motion_unit) return std::string(motion_names.at(static_cast<std::size_t>(value)));
    if (number.unit != category_unit) return fmt::format("{:.9g}", value);
    return std::string(classification::category_names.at(static_cast<std::size_t>(value)));
}

}  // namespace stridor::verification
