#include "stridor/explorer/browser.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <system_error>
#include <thread>

namespace stridor::explorer {

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

}  // namespace stridor::explorer
