#pragma once

#include "stridor/console/command.hpp"

#include <CLI/CLI.hpp>

#include <string>

namespace stridor::app {

/// Help that fits the terminal: as wide as COLUMNS or the terminal behind stdout, 100 columns at most, else 80. The
/// value of an option, its choices and its default are part of its sentence. Lines of a footer that begin with blanks
/// (examples) stay as they are.
class HelpFormatter final : public CLI::Formatter {
public:
    HelpFormatter();

    std::string make_usage(const CLI::App* command, std::string name) const override;
    std::string make_description(const CLI::App* command) const override;
    std::string make_footer(const CLI::App* command) const override;
    std::string make_subcommand(const CLI::App* command) const override;
    std::string make_option(const CLI::Option* option, bool is_positional) const override;

private:
    std::string entry(const std::string& name, const std::string& sentence) const;

    std::size_t columns_;
};

/// Returns the description of a command and of all commands below it, for help, manual page and completion.
console::Command described(const CLI::App& app);

}  // namespace stridor::app
