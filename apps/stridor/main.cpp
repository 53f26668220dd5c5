#include "arguments.hpp"
#include "commands.hpp"
#include "help.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/version.hpp"
#include "stridor/console/terminal.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <new>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace stridor::app {

namespace {

constexpr int bad_usage = 2;

constexpr const char* footer =
    "First steps:\n"
    "  stridor init squeal -o squeal.toml     write a commented case file\n"
    "  stridor simulate squeal.toml           does it squeal?\n"
    "  stridor stability squeal.toml --over contact.kinetic_friction=0:0.8\n"
    "  stridor init noise-chart -o pair.toml && stridor chart pair.toml --out pair\n"
    "\n"
    "`stridor help COMMAND` lists the options of a command.\n"
    "Exit codes: 0 done, 2 bad input or usage, 3 numerical failure, 4 interrupted (run the same command again), 5 a "
    "file, disk or other program failed. Data goes to stdout, messages to stderr.";

void build(CLI::App& program) {
    program.formatter(std::make_shared<HelpFormatter>());
    program.set_version_flag("-v,--version", fmt::format("stridor {} ({})", base::version(), base::commit()));
    program.require_subcommand(1);
    for (const auto add : add_commands)
        add(program);
    program.footer(footer);  // at last: commands take over what stands before them
}

void parse(CLI::App& program, std::vector<std::string> arguments) {
    check_commands(program, arguments);
    std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the end
    try {
        program.parse(std::move(arguments));
    } catch (const CLI::Success& asked) {  // --help, --version
        std::ostringstream text;
        program.exit(asked, text, text);
        console::print(text.str());
    }
}

int run(int argc, char** argv) {
    CLI::App program("Predicts whether a rubbing contact squeals, squeaks, creaks or stays quiet.", "stridor");
    build(program);
    try {
        parse(program, arguments_of(argc, argv));
        return 0;
    } catch (const CLI::ParseError& error) {
        say_usage_error(program, error);
        return bad_usage;
    } catch (const Error& error) {
        console::say_error(error);
        return base::exit_code(error.kind());
    } catch (const std::bad_alloc&) {
        console::say("stridor: error: out of memory");
        return base::exit_code(ErrorKind::io);
    } catch (const std::exception& error) {
        console::say(std::string("stridor: error: ") + error.what());
        return base::exit_code(ErrorKind::io);
    }
}

}  // namespace

}  // namespace stridor::app

int main(int argc, char** argv) {
    stridor::console::open_standard_streams();
    // a closed pipe and a file beyond its size limit are error returns, not silent deaths
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    return stridor::app::run(argc, argv);
}
