#pragma once

#include "stridor/base/error.hpp"

#include <string>
#include <utility>
#include <vector>

namespace stridor::io {

/// Collects what is wrong with a file, so that its user is told all of it at once.
class Complaints {
public:
    /// Was nothing found wrong so far?
    bool empty() const { return all_.empty(); }

    /// Takes up what an error carries; the same complaint once.
    void add(const Error& error);

    /// Runs one part of the reading and takes up the input error it ends in; other errors pass. Did it end in none?
    template <typename Part>
    bool keep(Part&& part) {
        try {
            std::forward<Part>(part)();
            return true;
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::input) throw;
            add(error);
            return false;
        }
    }

    /// Throws all of it as one `Error` (input), if there is any: first what has a line in the file, from top to bottom,
    /// then what is about the whole file, then overrides.
    void throw_any() const;

private:
    std::vector<base::Complaint> all_;
};

}  // namespace stridor::io
