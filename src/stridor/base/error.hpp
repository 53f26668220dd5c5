#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace stridor::base {

/// What kind of thing went wrong; the program's exit code follows from it.
enum class ErrorKind {
    input,        // exit 2: the user's file, option or combination of values
    numerical,    // exit 3: a computation that has no valid answer
    interrupted,  // exit 4: stopped on request; running the same command again goes on
    io,           // exit 5: a file, disk, pipe or other program failed
};

/// Where in a user's text a problem stands. Line and column count from 1; zero means unknown.
struct Place {
    std::string file;         // file name as the user gave it, or "--set" for an override
    int line = 0;             // [1]
    int column = 0;           // [1]
    std::string source_line;  // the line itself, shown with a caret; may be empty
};

/// A problem in the three parts a user can act on: what is wrong, why it is wrong, what to do.
struct Problem {
    std::string what;        // "mu_d = 0.9 exceeds mu_s = 0.8"
    std::string why;         // "kinetic friction may not be larger than static"; may be empty
    std::string suggestion;  // "Swap them?"; may be empty
};

/// A problem and where it stands.
struct Complaint {
    Problem problem;
    std::optional<Place> place{};
};

/// An error that a user, a file or the machine caused. It is thrown at the edges and never inside stepping. An error
/// about a whole file may carry several complaints.
///
/// `what()` reads *problem (why). suggestion? [file:line:column]*, a line per complaint.
class Error : public std::runtime_error {
public:
    /// Makes an error of one complaint, with its place in a file if it has one.
    Error(ErrorKind kind, Problem problem, std::optional<Place> place = std::nullopt);

    /// Makes an error of several complaints of one kind, in the order in which they are told. At least one is needed.
    static Error of(ErrorKind kind, std::vector<Complaint> complaints) { return {std::move(complaints), kind}; }

    /// Returns the kind, which decides the exit code.
    ErrorKind kind() const { return kind_; }
    /// Returns all complaints; at least one.
    const std::vector<Complaint>& complaints() const { return complaints_; }

    /// Returns the problem of the first complaint.
    const Problem& problem() const { return complaints_.front().problem; }
    /// Returns the place of the first complaint, or `std::nullopt` if that has no place in a file.
    const std::optional<Place>& place() const { return complaints_.front().place; }

private:
    Error(std::vector<Complaint> complaints, ErrorKind kind);

    ErrorKind kind_;
    std::vector<Complaint> complaints_;
};

/// Throws an `Error` (input) of one complaint.
[[noreturn]] void refuse(std::string what, std::string why, std::string suggestion);

/// Returns the program's exit code for an error of this kind: 2, 3, 4 or 5.
int exit_code(ErrorKind kind);

/// Returns "file:line:column" as far as the place is known.
std::string describe(const Place& place);

}  // namespace stridor::base

namespace stridor {
using base::Error;
using base::ErrorKind;
}  // namespace stridor
