#include "stridor/io/case/ready_files.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"
#include "stridor/io/case/case_schema.hpp"
#include "stridor/io/case/ready_laws.hpp"
#include "stridor/io/case/ready_structures.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "stridor/sweep/ready_charts.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace stridor::io {

namespace {

constexpr const char* two_lips_name = "two-lips";

}  // namespace

std::vector<std::string> ready_file_names() {
    std::vector<std::string> names(parameters::paper_case_names.begin(), parameters::paper_case_names.end());
    for (sweep::ReadyChart& chart : sweep::ready_charts())
        names.push_back(std::move(chart.name));
    for (const ReadyLaw& law : ready_laws())
        names.emplace_back(law.name);
    names.emplace_back(two_lips_name);
    for (const ReadyStructure& structure : ready_structures())
        names.emplace_back(structure.name);
    names.emplace_back("schema");
    return names;
}

std::string ready_file(const std::string& name) {
    if (name == "schema") return json_schema();
    if (name == two_lips_name) return case_toml(parameters::two_lips());
    for (const ReadyLaw& law : ready_laws())
        if (name == law.name) return study_toml(law.make(), {.heading = std::string(law.source)});
    for (const ReadyStructure& structure : ready_structures())
        if (name == structure.name) return case_toml(structure.make());
    for (const sweep::ReadyChart& chart : sweep::ready_charts())
        if (name == chart.name) return study_toml(chart.study);
    const auto& cases = parameters::paper_case_names;
    const auto found = std::find(cases.begin(), cases.end(), name);
    STRIDOR_EXPECT(found != cases.end());
    return case_toml(parameters::paper_case(static_cast<parameters::PaperCase>(found - cases.begin())));
}

void spare_written(const std::string& file) {
    std::error_code ignored;
    if (file.empty() || file == storage::standard_input || !std::filesystem::is_regular_file(file, ignored)) return;
    const std::string there = storage::read_file(file);
    const std::vector<std::string> all = ready_file_names();
    const bool is_ours =
        std::any_of(all.begin(), all.end(), [&](const std::string& name) { return ready_file(name) == there; });
    if (!there.empty() && !is_ours)
        throw Error(ErrorKind::input, {"\"" + file + "\" is there already", "it holds other than `stridor init` writes",
                                       "Name another file, or take --force to lose it."});
}

}  // namespace stridor::io
