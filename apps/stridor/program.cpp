#include "program.hpp"

#include "arguments.hpp"
#include "help.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/process.hpp"
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
#include <system_error>
#include <utility>
#include <vector>

namespace stridor::app {

namespace {

constexpr int bad_usage = 2;

void build(CLI::App& program, const Program& content) {
    program.formatter(std::make_shared<HelpFormatter>());
    program.set_version_flag("-v,--version", fmt::format("{} {} ({})", content.name, base::version(), base::commit()));
    program.require_subcommand(1);
    for (const auto add : content.commands)
        add(program);
    program.footer(content.footer);  // at last: commands take over what stands before them
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

}  // namespace

int run(const Program& content, int argc, char** argv) {
    CLI::App program(content.description, content.name);
    build(program, content);
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
    } catch (const std::system_error& error) {
        if (error.code() == std::errc::resource_unavailable_try_again)
            console::say_error(base::no_thread(error));
        else
            console::say(std::string("stridor: error: ") + error.what());
        return base::exit_code(ErrorKind::io);
    } catch (const std::exception& error) {
        console::say(std::string("stridor: error: ") + error.what());
        return base::exit_code(ErrorKind::io);
    }
}

void begin_process() {
    console::open_standard_streams();
    // a closed pipe and a file beyond its size limit are error returns, not silent deaths
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace stridor::app
