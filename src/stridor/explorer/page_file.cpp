#include "stridor/explorer/page_file.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/json.hpp"
#include "stridor/base/packed_bytes.hpp"
#include "stridor/io/case/material_pairs.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/recordings/table/sampled_csv.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "stridor/sweep/study.hpp"

#include <array>
#include <string_view>
#include <system_error>
#include <utility>

namespace stridor::explorer {

namespace {

constexpr std::string_view place_of_case = R"(<script type="application/json" id="stridor-case">null</script>)";
constexpr std::string_view nothing = "null";

// the element's text (explorer/src/anywhere/opened.ts): no letter of it is markup, whatever the case says
std::string inert_json(const StandingCase& standing) {
    base::Json held = standing.toml;
    if (!standing.files.empty()) {
        base::Json files;
        for (const auto& [name, bytes] : standing.files)
            files[name] = base::base64(bytes);
        held = {{"toml", standing.toml}, {"files", std::move(files)}};
    }
    const std::string json = held.dump(-1, ' ', true, base::Json::error_handler_t::replace);
    std::string inert;
    for (const char letter : json)
        letter == '<' ? inert += "\\u003c" : inert += letter;
    return inert;
}

}  // namespace

std::string one_file_page(const std::filesystem::path& program) {
    const std::filesystem::path folder = program.parent_path();
    const std::array places{folder / "page/page.html", folder.parent_path() / "share/stridor/page.html"};
    std::error_code ignored;
    for (const std::filesystem::path& place : places)
        if (std::filesystem::is_regular_file(place, ignored)) return storage::read_file(place.string());
    throw Error(ErrorKind::io,
                {"this stridor has no page in one file", "it was built without " + places.back().filename().string(),
                 "Build it in the checkout by ./dev page, which installs clang-19 and wasi-libc, or use stridor "
                 "explore."});
}

StandingCase standing_alone(const io::TomlSource& source) {
    StandingCase standing;
    const auto taken = [&](const std::string& path) {
        return standing.files[std::filesystem::path(path).filename().string()] = storage::read_file(path);
    };
    io::CaseReaders readers;
    readers.samples = [&](const std::string& path) { return recordings::read_sampled_csv(taken(path), path); };
    readers.friction = [&](const std::string& path) { return recordings::read_friction_csv(taken(path), path); };
    readers.force = [&](const std::string& path) {
        taken(path);
        return recordings::read_force_file(path);
    };
    readers.pair = [&](const std::string& path, const std::string& name) {
        taken(path);
        return io::read_material_pair(path, name);
    };
    const io::TomlDocument document = io::parse_toml(source);
    // the folders of this machine are nobody's business
    const auto without_folder = [](parameters::Case& c) {
        c.drive.file = std::filesystem::path(c.drive.file).filename().string();
    };
    if (document.find("chart") != nullptr) {
        sweep::Study study = io::read_study(document, {}, readers);
        without_folder(study.base);
        standing.toml = io::study_toml(study);
    } else {
        parameters::Case c = io::read_case(document, readers);
        without_folder(c);
        standing.toml = io::case_toml(c);
    }
    std::erase_if(standing.files,
                  [&](const auto& file) { return standing.toml.find(file.first) == std::string::npos; });
    return standing;
}

std::string page_with_case(std::string page, const StandingCase& standing) {
    const std::size_t at = page.find(place_of_case);
    if (at == page.npos)
        throw Error(ErrorKind::io, {"the page in one file is damaged", "it has no place for a case", ""});
    page.replace(at + place_of_case.find(nothing), nothing.size(), inert_json(standing));
    return page;
}

}  // namespace stridor::explorer
