#include "stridor/base/error.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/recordings/table/sampled_csv.hpp"
#include "stridor/sweep/ready_charts.hpp"
#include "support/counter_random.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace stridor::io {
namespace {

using support::CounterRandom;

// what tends to go wrong in numbers, keys and encodings
constexpr std::array<std::string_view, 27> pieces{
    "\n",     "\r\n", "\"",           "'''", "[",       "]",    "{",    "}", "=",     ".",
    ",",      ";",    "\t",           "#",   "nan",     "-inf", "-",    "+", "1e999", "0x1f",
    "1e-400", "\xff", "\xEF\xBB\xBF", "é",   "\\u0000", "[[",   "kN/mm"};

std::string mutated(std::string text, CounterRandom& random) {
    const std::size_t count = 1 + random.below(4);
    for (std::size_t k = 0; k < count && !text.empty(); ++k) {
        const std::size_t at = random.below(text.size());
        const std::size_t length = random.below(1 + random.below(40));
        switch (random.below(7)) {
            case 0:  // cut the end
                text.resize(at);
                break;
            case 1:  // flip a bit
                text[at] = static_cast<char>(static_cast<unsigned char>(text[at]) ^ (1U << random.below(8)));
                break;
            case 2:  // insert a piece
                text.insert(at, pieces[random.below(pieces.size())]);
                break;
            case 3:  // lose a piece
                text.erase(at, length);
                break;
            case 4:  // repeat a piece
                text.insert(at, text.substr(random.below(text.size()), length));
                break;
            case 5:  // replace a byte
                text[at] = static_cast<char>(random.next());
                break;
            default:  // replace a piece
                text.replace(at, length, pieces[random.below(pieces.size())]);
                break;
        }
    }
    return text;
}

/// Mutates a valid text again and again; `read` must return or throw an `Error` of the user's kind with a place.
template <typename Read>
void fuzz(const std::string& valid, Read read) {
    const support::Runs runs = support::runs(1500);
    for (std::uint64_t run = runs.first; run < runs.first + runs.count; ++run) {
        CounterRandom random(run);
        const std::string text = mutated(valid, random);
        try {
            read(text);
        } catch (const Error& error) {
            ASSERT_TRUE(error.place()) << "run " << run << ": " << error.what();
            ASSERT_FALSE(error.problem().what.empty()) << "run " << run;
        } catch (const std::exception& error) {
            FAIL() << "run " << run << " threw " << error.what() << " on\n" << text;
        }
    }
}

// what was read must be writable, and read back as the same
void read_and_write_case(const std::string& text) {
    const parameters::Case c = read_case(TomlSource{text, "/nowhere/case.toml", {}});
    const parameters::Case back = read_case(TomlSource{case_toml(c), "/nowhere/case.toml", {}});
    ASSERT_EQ(parameters::canonical_text(back), parameters::canonical_text(c));
}

void read_and_write_study(const std::string& text) {
    const sweep::Study study = read_study(TomlSource{text, "/nowhere/chart.toml", {}});
    const sweep::Study back = read_study(TomlSource{study_toml(study), "/nowhere/chart.toml", {}});
    ASSERT_EQ(sweep::canonical_text(back), sweep::canonical_text(study));
}

TEST(TomlReaderFuzz, EndsInACaseOrAnError) {
    fuzz(case_toml(parameters::paper_case(parameters::PaperCase::squeal)), read_and_write_case);
}

TEST(TomlReaderFuzz, EndsInAShortCaseOrAnError) {
    fuzz(case_toml(parameters::paper_case(parameters::PaperCase::creak), {.comments = Comments::none, .heading = ""}),
         read_and_write_case);
}

TEST(TomlReaderFuzz, EndsInAChartOrAnError) {
    fuzz(study_toml(sweep::figure_8(), {.comments = Comments::none, .heading = ""}), read_and_write_study);
}

TEST(TomlReaderFuzz, TakesAnyOverride) {
    fuzz("contact.preload=\"20 N\"", [](const std::string& text) {
        const parameters::Case c = parameters::paper_case(parameters::PaperCase::squeal);
        read_case(TomlSource{case_toml(c), "case.toml", {text}});
    });
}

TEST(CsvReaderFuzz, EndsInSamplesOrAnError) {
    for (const std::string_view valid :
         {"# lab\ntime [ms],velocity [mm/s]\n0,100\n1,99.5\n2,-98\n3,1e2\n", "0;0,1\n0,5;-0,25\n1;0\n",
          "\xEF\xBB\xBFnote\t\"velocity\"\ttime\r\n-\tm/s\ts\r\na\t0.1\t0\r\n\"b\tc\"\t-0.25\t0.5\r\n"})
        fuzz(std::string(valid), [](const std::string& text) {
            const recordings::SampledMotion motion = recordings::read_sampled_csv(text, "d.csv");
            ASSERT_EQ(motion.times.size(), motion.velocities.size());
            for (std::size_t k = 1; k < motion.times.size(); ++k)
                ASSERT_GT(motion.times[k], motion.times[k - 1]);
        });
}

}  // namespace
}  // namespace stridor::io
