#include "arguments.hpp"
#include "commands.hpp"
#include "interrupt.hpp"
#include "stridor/base/error.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/explorer/api.hpp"
#include "stridor/explorer/browser.hpp"
#include "stridor/explorer/gate.hpp"
#include "stridor/explorer/served_world.hpp"
#include "stridor/explorer/server.hpp"
#include "stridor/explorer/typescript.hpp"
#include "stridor/explorer/world.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>
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
    std::optional<std::string> frame;  // origin that may show it in a frame
    int threads = 0;
    bool allow_remote = false;
    bool no_browser = false;
    std::string typescript;  // part of the page to print instead; empty: none
};

// tells the links, one after the other, and opens the first
class Links {
public:
    Links(const ExploreOptions& options, const explorer::FramingSite& frame, std::uint16_t port) : options_(options) {
        // in a frame the session holds only under the name of the page round it
        const std::string host = !frame.host.empty() ? frame.host : explorer::host_in_link(options.address.host);
        base_ = has_port() ? fmt::format("http://{}:{}", host, port) : "http://localhost";
    }

    void tell(const std::string& token) {
        const std::string& fragment = options_.fragment;
        const std::string link = base_ + "/open?token=" + token + (fragment.empty() ? "" : "#" + fragment);
        redirect_.reset();  // it led to the one that was used
        console::print(link + "\n");
        if (std::exchange(is_told_, true)) return;
        if (!has_port()) console::say("listening at " + options_.address.unix_socket.string());
        console::say("Open the link above; it opens once, and a new one follows. Ctrl-C ends.");
        if (!has_port() || options_.no_browser || !explorer::has_screen()) return;
        try {
            explorer::open_browser(redirect_.emplace(link).file().string());
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
    if (!options.allow_remote) explorer::require_loopback(options.address.host);
    const std::vector<std::string> hosts = explorer::host_names(options.address.host, options.host_names);
    const explorer::FramingSite frame =
        options.frame ? explorer::read_framing_site(*options.frame, hosts) : explorer::FramingSite();
    if (explorer::is_link(options.file)) {
        options.fragment = explorer::fragment_of(options.file);
        if (!options.overrides.empty())
            throw Error(ErrorKind::input, {"--set does not go with a link", "the link says the whole case",
                                           "Leave --set out, and change the value in the page."});
    }
    explorer::World world = explorer::world_of(options.library);
    world.threads = options.threads;
    if (!options.file.empty() && !explorer::is_link(options.file))
        world.presets.insert(world.presets.begin(), explorer::preset_of(load_source(options.file, options.overrides)));
    std::optional<explorer::Server> server(std::in_place, options.address, explorer::Limits(), frame.origin);
    std::optional<Links> links(std::in_place, options, frame, server->port());
    explorer::Gate gate(hosts, std::to_string(server->port()), [&](const std::string& token) { links->tell(token); });
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
    command->add_option(
        "file", options->file,
        "case file (TOML), or what Share, Copy link of another page gave (default: the paper's squeal)");
    command->add_option("--set", options->overrides, "override a key of the file (repeatable)")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command->add_option("--port", options->address.port, "port to listen at (default: any free one)")
        ->check(CLI::Range(0, 65535));
    command->add_flag("--no-browser", options->no_browser, "only print the link");
    command
        ->add_option("--unix-socket", options->address.unix_socket,
                     "listen at a socket in the file system instead, which belongs to its owner alone")
        ->type_name("PATH");
    command->add_option("--library", options->library, "noise library to show (default: your own, if there is one)")
        ->type_name("FILE");
    command->add_option("--threads", options->threads, "threads for charts (default: one per processor)")
        ->check(CLI::Range(0, 1024));
    command->add_option("--address", options->address.host, "address of this machine to listen at")
        ->capture_default_str();
    command->add_flag("--allow-remote", options->allow_remote,
                      "let --address be one that other machines reach; the connection is not encrypted");
    command->add_option("--host-name", options->host_names, "name by which other machines ask for it (repeatable)")
        ->type_name("NAME")
        ->allow_extra_args(false);
    command
        ->add_option("--frame", options->frame,
                     "site that may show it in a frame, such as http://localhost:8888; no other may")
        ->type_name("ORIGIN");
    // for who changes the program (explorer/README.md); users have no use for it
    command->add_option("--typescript", options->typescript)
        ->check(one_of(std::vector<std::string>(explorer::typescript_names.begin(), explorer::typescript_names.end())))
        ->group("");
    command->footer(
        "The page is served to this machine alone, to who has the link; nothing is fetched from anywhere. Each link "
        "opens once, and a new one follows.\n"
        "Examples:\n  stridor explore\n  stridor explore door-seal.toml --port 8080 --no-browser\n"
        "  stridor explore 'http://localhost:8080/#preset=squeal&contact.preload=35'\n"
        "  ssh -L 8080:localhost:8080 cluster stridor explore --port 8080 --no-browser");
    command->callback([options] { explore(*options); });
}

}  // namespace stridor::app
