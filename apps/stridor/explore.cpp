#include "commands.hpp"
#include "interrupt.hpp"
#include "stridor/base/error.hpp"
#include "stridor/explorer/api.hpp"
#include "stridor/explorer/gate.hpp"
#include "stridor/explorer/server.hpp"
#include "stridor/io/toml_case.hpp"
#include "stridor/io/toml_document.hpp"
#include "stridor/noise_library/library.hpp"
#include "terminal.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <memory>
#include <thread>
#include <utility>

namespace stridor::app {

namespace {

struct ExploreOptions {
    std::string file;
    std::vector<std::string> overrides;
    explorer::Address address;
    std::string library;
    std::vector<std::string> host_names;
    int threads = 0;
    bool allow_remote = false;
    bool no_browser = false;
};

void check(const ExploreOptions& options) {
    if (options.allow_remote || explorer::is_loopback(options.address.host)) return;
    throw Error(ErrorKind::input,
                {options.address.host + " can be reached from other machines",
                 "whoever has the link could use the explorer, over a connection that is not encrypted",
                 "Leave --address out and use a tunnel (ssh -L), or add --allow-remote if that is what you want."});
}

explorer::World world_of(const ExploreOptions& options) {
    explorer::World world;
    world.threads = options.threads;
    world.presets = explorer::paper_presets();
    world.library = options.library.empty() ? noise_library::default_library() : std::filesystem::path(options.library);
    std::error_code ignored;
    if (!options.library.empty())
        static_cast<void>(
            noise_library::Library(world.library));  // what is wrong with it is said here and not in the page
    else if (!std::filesystem::exists(world.library, ignored))
        world.library.clear();
    if (options.file.empty()) return world;
    const io::TomlSource source = io::load_toml(options.file, options.overrides);
    explorer::Preset preset{"file", source.text, source.name, options.overrides};
    const io::SamplesReader keep = [&](const std::string& path) {
        preset.samples_file = path;
        return preset.samples = io::read_sampled_file(path);
    };
    static_cast<void>(io::read_case(io::parse_toml(source), keep));  // likewise
    world.presets.insert(world.presets.begin(), std::move(preset));
    return world;
}

// names under which the explorer may be asked for; addresses cannot be made to point elsewhere as names can
std::vector<std::string> hosts_of(const ExploreOptions& options) {
    std::vector<std::string> hosts{"localhost", "127.0.0.1", "[::1]"};
    const std::string& host = options.address.host;
    hosts.push_back(host.find(':') == std::string::npos ? host : "[" + host + "]");
    hosts.insert(hosts.end(), options.host_names.begin(), options.host_names.end());
    return hosts;
}

// opens the link, if there is a screen to open it on; what the opener says is of no interest
void open_browser(const std::string& link) {
    const bool has_screen = std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
    if (!has_screen) return;
    const ::pid_t child = ::fork();
    if (child == 0) {
        ::setsid();
        if (std::freopen("/dev/null", "w", stdout) == nullptr || std::freopen("/dev/null", "w", stderr) == nullptr)
            ::_exit(127);
        ::execlp("xdg-open", "xdg-open", link.c_str(), static_cast<char*>(nullptr));
        ::_exit(127);
    }
    if (child > 0) std::thread([child] { ::waitpid(child, nullptr, 0); }).detach();
}

void explore(const ExploreOptions& options) {
    check(options);
    const explorer::World world = world_of(options);
    explorer::Server server(options.address);
    const std::string host =
        options.address.host.find(':') == std::string::npos ? options.address.host : "[" + options.address.host + "]";
    const bool has_port = options.address.unix_socket.empty();
    const std::string base = has_port ? fmt::format("http://{}:{}", host, server.port()) : "http://localhost";
    bool is_first = true;
    explorer::Gate gate(hosts_of(options), std::to_string(server.port()), [&](const std::string& token) {
        const std::string link = base + "/open?token=" + token;
        print(link + "\n");
        if (!is_first) return;
        is_first = false;
        if (!has_port) say("listening at " + options.address.unix_socket.string());
        say("Open the link above; it opens once, and a new one follows. Ctrl-C ends.");
        if (has_port && !options.no_browser) open_browser(link);
    });
    const Interrupt interrupt;
    server.serve(
        [&](const explorer::Request& request, const std::stop_token& stop) {
            std::optional<explorer::Response> stopped = gate.stop(request);
            return stopped ? std::move(*stopped) : explorer::answer(world, request, stop);
        },
        interrupt.token());
}

}  // namespace

void add_explore(CLI::App& program) {
    auto options = std::make_shared<ExploreOptions>();
    CLI::App* command = program.add_subcommand(
        "explore",
        "Play with the rubbing system in a browser: sliders, charts, motion, sound, and what keeps it quiet.");
    command->add_option("file", options->file, "case file (TOML) to begin with (default: the paper's squeal)");
    command->add_option("--set", options->overrides, "override a key of the file (repeatable)")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command->add_option("--port", options->address.port, "port to listen at (default: any free one)");
    command->add_flag("--no-browser", options->no_browser, "only print the link");
    command->add_option("--unix-socket", options->address.unix_socket, "listen at a socket in the file system instead")
        ->type_name("PATH");
    command->add_option("--library", options->library, "noise library to show (default: your own, if there is one)")
        ->type_name("FILE");
    command->add_option("--threads", options->threads, "threads for charts (default: one per processor)")
        ->check(CLI::Range(0, 1024));
    command->add_option("--address", options->address.host, "address of this machine to listen at")
        ->capture_default_str();
    command->add_flag("--allow-remote", options->allow_remote, "let --address be one that other machines reach");
    command->add_option("--host-name", options->host_names, "name by which other machines ask for it (repeatable)")
        ->type_name("NAME")
        ->allow_extra_args(false);
    command->footer(
        "The page is served to this machine alone, to who has the link; nothing is fetched from anywhere.\n"
        "Examples:\n  stridor explore\n  stridor explore door-seal.toml --port 8080 --no-browser\n"
        "  ssh -L 8080:localhost:8080 cluster stridor explore --port 8080 --no-browser");
    command->callback([options] { explore(*options); });
}

}  // namespace stridor::app
