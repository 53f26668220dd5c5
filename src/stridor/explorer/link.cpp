#include "stridor/explorer/link.hpp"

#include "stridor/base/error.hpp"

#include <algorithm>

namespace stridor::explorer {

namespace {

constexpr std::size_t longest_fragment = 8000;  // a whole case and one it is compared with take some 4000

bool may_stand(char c) {
    constexpr std::string_view others = "-._~!$&'()*+,;=:@/?%";  // RFC 3986, fragment
    const bool is_word = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    return is_word || others.find(c) != std::string_view::npos;
}

[[noreturn]] void refuse(const std::string& what, const std::string& why) {
    throw Error(ErrorKind::input, {what, why, "Copy the link anew: Share, Copy link."});
}

// what stands between "preset=" and "&"; empty where no preset is named
std::string_view preset_in(std::string_view fragment) {
    constexpr std::string_view key = "preset=";
    while (!fragment.empty()) {
        const std::string_view part = fragment.substr(0, fragment.find('&'));
        if (part.starts_with(key)) return part.substr(key.size());
        fragment.remove_prefix(std::min(fragment.size(), part.size() + 1));
    }
    return {};
}

}  // namespace

bool is_link(std::string_view text) {
    return text.starts_with('#') || text.starts_with("http://") || text.starts_with("https://");
}

std::string fragment_of(std::string_view link) {
    const std::size_t at = link.find('#');
    if (at == std::string_view::npos) refuse("the link holds no case", "there is no \"#\" in it");
    const std::string_view fragment = link.substr(at + 1);
    if (fragment.size() > longest_fragment) refuse("the link is too long", "no case needs so many characters");
    if (!std::all_of(fragment.begin(), fragment.end(), may_stand))
        refuse("the link is damaged", "it holds a character that no link holds");
    const std::string_view preset = preset_in(fragment);
    if (preset.empty()) refuse("the link holds no case", "there is no \"preset=\" in it");
    if (preset == "file")
        refuse("the link leans on a file of the machine it came from", "it was copied from the address of a page");
    return std::string(fragment);
}

}  // namespace stridor::explorer
