#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/verification/quantities.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// Results that others published, held against this program's: `stridor verify --published`, docs/methods/published.md.
/// Ours is computed anew each time, from a case file in cases/published.
namespace stridor::verification {

/// How the published numbers were found.
enum class Origin : std::uint8_t { formula, computation, measurement };

inline constexpr std::array<std::string_view, 3> origin_names{"formula", "computation", "measurement"};

/// The unit of a row whose numbers are categories (`classification::category_names`).
inline constexpr std::string_view category_unit = "category";

/// The unit of a row whose numbers are motions (`motion_names`).
inline constexpr std::string_view motion_unit = "motion";

/// One published number.
struct PublishedNumber {
    std::string quantity;          // "amplitude, g = 1.5, r = 0.2"
    std::string_view unit;         // as in the field table, `category_unit` or `motion_unit`
    std::vector<std::string> set;  // what the case changes for it, as `--set`
    QuantityOfCase measure;        // computes ours
    std::string about;             // for `measure`
    double theirs = 0.0;           // [unit]
    double tolerance = 0.0;        // [unit] from the precision of theirs, never from ours
    std::string_view precision;    // where the tolerance comes from
};

/// Says whether a number stands for a word: it has no size, and no tolerance.
bool is_word(const PublishedNumber& number);

/// A system that others published numbers of.
struct PublishedSystem {
    std::string_view source;  // who, when, where it was read
    std::string_view system;  // what moves
    Origin origin = Origin::formula;
    std::string_view file;     // in cases/published, or the name of a case that `stridor init` writes
    std::string_view assumed;  // what the source does not say, or this model does otherwise; empty: nothing
    std::vector<PublishedNumber> numbers;
};

/// A published result that this program does not reproduce, and the reason.
struct NotReproduced {
    std::string_view source;
    std::string_view what;
    std::string_view why;
};

/// Returns all systems, in the order of the table.
const std::vector<PublishedSystem>& published_systems();

/// Returns what is known and was not reproduced.
const std::vector<NotReproduced>& not_reproduced();

/// Returns the text of a system's case file.
std::string case_text(const PublishedSystem& system);

/// Returns the case of a number. Throws `Error` (input) for a file or a change that cannot be read.
parameters::Case case_of(const PublishedSystem& system, const PublishedNumber& number);

/// A published number with ours.
struct HeldNumber {
    const PublishedNumber* published = nullptr;
    double ours = 0.0;  // [unit]

    /// Returns ours less theirs [unit].
    double difference() const { return ours - published->theirs; }
    /// Says whether the difference lies within the tolerance.
    bool agrees() const;
};

/// A system with what the engines found.
struct HeldSystem {
    const PublishedSystem* published = nullptr;
    std::vector<HeldNumber> numbers;
};

/// Computes ours of each number of a system.
HeldSystem held(const PublishedSystem& system);

/// Returns a number as the table writes it: nine digits, or the word of a category or a motion.
std::string number_text(const PublishedNumber& number, double value);

/// Returns the JSON document of the table, schema stridor.published/1.
std::string published_json(const std::vector<HeldSystem>& systems);

}  // namespace stridor::verification
