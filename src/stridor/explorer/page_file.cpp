#include "stridor/explorer/page_file.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/json.hpp"
#include "stridor/explorer/world.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <array>
#include <string_view>
#include <system_error>

namespace stridor::explorer {

namespace {

constexpr std::string_view place_of_case = R"(<script type="application/json" id="stridor-case">null</script>)";
constexpr std::string_view nothing = "null";

// the element's text: no letter of it is markup, whatever the case says
std::string inert_json(const std::string& text) {
    const std::string json = base::Json(text).dump(-1, ' ', true, base::Json::error_handler_t::replace);
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

std::string standing_alone(const io::TomlSource& source) {
    const io::TomlDocument document = io::parse_toml(source);
    const std::string text = document.find("chart") != nullptr ? io::study_toml(io::read_study(document))
                                                               : io::case_toml(io::read_case(document));
    static_cast<void>(preset_of({text, source.name, {}}, readers_of_page()));
    return text;
}

std::string page_with_case(std::string page, const std::string& toml) {
    const std::size_t at = page.find(place_of_case);
    if (at == page.npos)
        throw Error(ErrorKind::io, {"the page in one file is damaged", "it has no place for a case", ""});
    page.replace(at + place_of_case.find(nothing), nothing.size(), inert_json(toml));
    return page;
}

}  // namespace stridor::explorer
