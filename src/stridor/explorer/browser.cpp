#include "stridor/explorer/browser.hpp"

#include "stridor/base/error.hpp"
#include "stridor/storage/system_io.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <system_error>
#include <thread>

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

std::string as_html(std::string_view text) {
    std::string html;
    for (const char c : text)
        html += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
    return html;
}

std::filesystem::path private_folder() {
    std::string name = (std::filesystem::temp_directory_path() / "stridor-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw storage::system_failure("make the folder", name, errno);
    return name;
}

}  // namespace

bool has_screen() {
    return std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
}

void open_browser(const std::string& file) {
    const ::pid_t child = ::fork();
    if (child == 0) {
        constexpr unsigned first = 3;
        ::close_range(first, ~0U, 0);  // a browser must not keep the port
        ::setsid();
        if (std::freopen("/dev/null", "w", stdout) == nullptr || std::freopen("/dev/null", "w", stderr) == nullptr)
            ::_exit(127);
        ::execlp("xdg-open", "xdg-open", file.c_str(), static_cast<char*>(nullptr));
        ::_exit(127);
    }
    if (child < 0) return;
    try {
        std::thread([child] { ::waitpid(child, nullptr, 0); }).detach();
    } catch (const std::system_error&) {
        // without a thread to wait for it a browser that ends keeps its place among the processes until this one ends
        return;
    }
}

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

Redirect::Redirect(const std::string& link) : folder_(private_folder()) {
    const std::string shown = file().string();
    const storage::Descriptor out(::open(shown.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
    if (!out.is_open()) throw storage::system_failure("write", shown, errno);
    const std::string target = as_html(link);
    storage::write_all(out.number(),
                       "<!doctype html><meta charset=\"utf-8\"><title>Stridor</title>"
                       "<meta name=\"referrer\" content=\"no-referrer\">"
                       "<meta http-equiv=\"refresh\" content=\"0; url=" +
                           target + "\"><a href=\"" + target + "\">Open the explorer</a>\n",
                       shown);
}

Redirect::~Redirect() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

}  // namespace stridor::explorer
