#include "fuzz/targets/targets.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/rules/check.hpp"

#include <algorithm>
#include <string>

namespace stridor::fuzz {

namespace {

// a sampled drive would open a file that the text names
bool names_a_file(const io::TomlDocument& document) {
    return std::any_of(document.entries.begin(), document.entries.end(), [](const io::TomlEntry& entry) {
        const auto* text = std::get_if<std::string>(&entry.value);
        return entry.key == "drive.kind" && text != nullptr && base::trimmed(*text) == "sampled";
    });
}

void require_well_put(const Error& error) {
    require(error.kind() == ErrorKind::input && error.place().has_value() && !error.problem().what.empty());
}

}  // namespace

// first line: overrides, parted by 0x1f; the rest: a case file, which may hold a chart
void case_file(std::string_view bytes) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    io::TomlSource source{std::string(bytes.substr(std::min(end + 1, bytes.size()))), "input", {}};
    for (std::size_t from = 0; from < end;) {
        const std::size_t to = std::min(bytes.find('\x1f', from), end);
        if (to > from) source.overrides.emplace_back(bytes.substr(from, to - from));
        from = to + 1;
    }
    bool has_chart = false;
    try {
        const io::TomlDocument document = io::parse_toml(source);
        if (names_a_file(document)) return;
        has_chart = document.find("chart") != nullptr;
        const parameters::Case c = io::read_case(io::parse_toml(source), io::readers_without_files());
        require(parameters::findings(c).empty());
        // what was read can be written, and reads back as the same
        const parameters::Case back = io::read_case(io::TomlSource{io::case_toml(c), "written", {}});
        require(parameters::canonical_text(back) == parameters::canonical_text(c));
    } catch (const Error& error) {
        require_well_put(error);
    }
    if (!has_chart) return;
    try {
        const sweep::Study study = io::read_study(io::parse_toml(source), {}, io::readers_without_files());
        const sweep::Study back = io::read_study(io::TomlSource{io::study_toml(study), "written", {}});
        require(sweep::canonical_text(back) == sweep::canonical_text(study));
    } catch (const Error& error) {
        require_well_put(error);
    }
}

}  // namespace stridor::fuzz
