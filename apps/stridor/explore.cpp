#include "commands.hpp"
#include "interrupt.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/explorer/api.hpp"
#include "stridor/explorer/gate.hpp"
#include "stridor/explorer/link.hpp"
#include "stridor/explorer/redirect.hpp"
#include "stridor/explorer/server.hpp"
#include "stridor/explorer/typescript.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/noise_library/library.hpp"
#include "stridor/parameters/temperature_table.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

namespace stridor::app {

namespace {

struct ExploreOptions {
    std::string file;      // or a link
    std::string fragment;  // of the link, without "#"; empty: none
    std::vector<std::string> overrides;
    explorer::Address address;
    std::string library;
    std::vector<std::string> host_names;
    int threads = 0;
    bool allow_remote = false;
    bool no_browser = false;
    std::string typescript;  // part of the page to print instead; empty: none
};

void check(const ExploreOptions& options) {
    if (options.allow_remote || explorer::is_loopback(options.address.host)) return;
    throw Error(ErrorKind::input,
                {options.address.host + " can be reached from other machines",
                 "whoever has the link could use the explorer, over a connection that is not encrypted",
                 "Leave --address out and use a tunnel (ssh -L), or add --allow-remote if that is what you want."});
}

// the page's own chart is over the friction, which cannot be set where it follows the temperature
io::AxisTexts axes_over_temperature(const parameters::Case& c) {
    const std::vector<double>& at = c.temperature.at;
    return {"contact.preload=1:80:64:linear",
            "temperature.value=" + base::shortest(at.front()) + ":" + base::shortest(at.back()) + ":64"};
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
    if (options.file.empty() || explorer::is_link(options.file)) return world;
    const io::TomlSource source = load_source(options.file, options.overrides);
    explorer::Preset preset{"file", source.text, source.name, options.overrides};
    const io::SamplesReader keep = [&](const std::string& path) {
        preset.samples_file = path;
        return preset.samples = recordings::read_sampled_file(path);
    };
    const io::TomlDocument document = io::parse_toml(source);
    const parameters::Case c = io::read_case(document, keep);  // likewise
    if (document.find("chart") != nullptr)
        preset.study = io::read_study(source);
    else if (parameters::temperature_column(c, "contact.kinetic_friction") != nullptr)
        preset.study = io::read_study(source, axes_over_temperature(c));
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

bool has_screen() {
    return std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
}

// opens a file that leads to the link; what the opener says is of no interest
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
    if (child > 0) std::thread([child] { ::waitpid(child, nullptr, 0); }).detach();
}

// tells the links, one after the other, and opens the first
class Links {
public:
    Links(const ExploreOptions& options, std::uint16_t port) : options_(options) {
        const std::string& host = options.address.host;
        const std::string name = host.find(':') == std::string::npos ? host : "[" + host + "]";
        base_ = has_port() ? fmt::format("http://{}:{}", name, port) : "http://localhost";
    }

    void tell(const std::string& token) {
        const std::string& fragment = options_.fragment;
        const std::string link = base_ + "/open?token=" + token + (fragment.empty() ? "" : "#" + fragment);
        redirect_.reset();  // it led to the one that was used
        console::print(link + "\n");
        if (std::exchange(is_told_, true)) return;
        if (!has_port()) console::say("listening at " + options_.address.unix_socket.string());
        console::say("Open the link above; it opens once, and a new one follows. Ctrl-C ends.");
        if (!has_port() || options_.no_browser || !has_screen()) return;
        try {
            open_browser(redirect_.emplace(link).file().string());
        } catch (const Error& error) {
            console::say_error(error);  // the link above works without
        }
    }

private:
    bool has_port() const { return options_.address.unix_socket.empty(); }

    const ExploreOptions& options_;
    std::string base_;
    std::optional<explorer::Redirect> redirect_;
    bool is_told_ = false;
};

void explore(ExploreOptions options) {
    if (!options.typescript.empty()) return console::print(explorer::typescript(options.typescript));
    check(options);
    if (explorer::is_link(options.file)) {
        options.fragment = explorer::fragment_of(options.file);
        if (!options.overrides.empty())
            throw Error(ErrorKind::input, {"--set does not go with a link", "the link says the whole case",
                                           "Leave --set out, and change the value in the page."});
    }
    const explorer::World world = world_of(options);
    std::optional<explorer::Server> server(std::in_place, options.address);
    std::optional<Links> links(std::in_place, options, server->port());
    explorer::Gate gate(hosts_of(options), std::to_string(server->port()),
                        [&](const std::string& token) { links->tell(token); });
    const Interrupt interrupt;
    const std::size_t stuck =
        server->serve([&](const explorer::HttpRequest& request,
                          const std::stop_token& stop) { return explorer::answer(world, request, stop); },
                      interrupt.token(), [&](const explorer::HttpRequest& request) { return gate.stop(request); });
    if (stuck == 0) return;
    // their threads still use what is here: all that is left behind is taken away, and they end with the program
    links.reset();
    server.reset();
    console::say(fmt::format("{} did not stop and {} ended with the program",
                             stuck == 1 ? "1 run" : fmt::format("{} runs", stuck), stuck == 1 ? "is" : "are"));
    std::_Exit(0);
}

}  // namespace

void add_explore(CLI::App& program) {
    auto options = std::make_shared<ExploreOptions>();
    CLI::App* command = program.add_subcommand(
        "explore",
        "Play with the rubbing system in a browser: sliders, charts, motion, sound, and what keeps it quiet.");
    command->add_option("file", options->file,
                        "case file (TOML) or link of the page to begin with (default: the paper's squeal)");
    command->add_option("--set", options->overrides, "override a key of the file (repeatable)")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command->add_option("--port", options->address.port, "port to listen at (default: any free one)")
        ->check(CLI::Range(0, 65535));
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
    // for who changes the program (explorer/README.md); users have no use for it
    command->add_option("--typescript", options->typescript)
        ->check(CLI::IsMember(
            std::vector<std::string>(explorer::typescript_names.begin(), explorer::typescript_names.end())))
        ->group("");
    command->footer(
        "The page is served to this machine alone, to who has the link; nothing is fetched from anywhere.\n"
        "Examples:\n  stridor explore\n  stridor explore door-seal.toml --port 8080 --no-browser\n"
        "  stridor explore 'http://localhost:8080/#preset=squeal&contact.preload=35'\n"
        "  ssh -L 8080:localhost:8080 cluster stridor explore --port 8080 --no-browser");
    command->callback([options] { explore(*options); });
}

}  // namespace stridor::app
