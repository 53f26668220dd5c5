#include "stridor/explorer/redirect.hpp"

#include "stridor/storage/system_io.hpp"

#include <fcntl.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

namespace stridor::explorer {

namespace {

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
