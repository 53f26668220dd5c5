#include "fuzz/targets/targets.hpp"
#include "stridor/base/error.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/io/library/library_texts.hpp"
#include "stridor/io/sound/json_sound.hpp"
#include "support/counter_random.hpp"
#include "support/runs.hpp"
#include "support/small_stack.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace stridor::fuzz {
namespace {

std::vector<std::string> corpus(std::string_view target) {
    std::vector<std::filesystem::path> files;
    const std::filesystem::path folder = std::filesystem::path(STRIDOR_SOURCE_DIR) / "tests/fuzz/corpus" / target;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<std::string> texts;
    for (const std::filesystem::path& file : files) {
        std::ifstream stream(file, std::ios::binary);
        texts.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
    }
    return texts;
}

void run_corpus() {
    const support::Runs runs = support::runs(300);
    for (const Target& target : targets) {
        const std::vector<std::string> seeds = corpus(target.name);
        ASSERT_FALSE(seeds.empty()) << target.name;
        for (const std::string& seed : seeds)
            target.run(seed);
        for (std::uint64_t run = runs.first; run < runs.first + runs.count; ++run) {
            support::CounterRandom random(run);
            std::string text = seeds[random.below(seeds.size())];
            for (std::size_t edit = 0; edit < 3 && !text.empty(); ++edit) {
                const std::size_t at = random.below(text.size());
                if (random.one_in(3))
                    text.erase(at, random.below(8));
                else
                    text[at] = static_cast<char>(random.next());
            }
            target.run(text);
        }
    }
}

// the corpus itself, and what is a few bytes away from it; on the small stack that `./dev fuzz` has, too
TEST(FuzzTargets, EndWellOnTheCorpusAndAroundIt) {
    support::on_small_stack(run_corpus);
}

// what is in something that is in something
std::string nested(const std::string& open, std::size_t depth, const std::string& close) {
    std::string text;
    for (std::size_t k = 0; k < depth; ++k)
        text += open;
    for (std::size_t k = 0; k < depth; ++k)
        text += close;
    return text;
}

// a header of an archive that names a folder
std::string folder_header() {
    std::string header(512, '\0');
    header.replace(0, 2, "d/");
    header.replace(124, 11, "00000000000");
    header[156] = '5';
    header.replace(257, 5, "ustar");
    return header;
}

TEST(FuzzTargets, EndWellOnWhatIsDeepOrLong) {
    support::on_small_stack([] {
        constexpr std::size_t depth = 20000;
        tar(nested(folder_header(), depth, ""));
        for (const auto& text :
             {nested("[", depth, "]"), nested("{\"a\":", depth, "}"), nested("[{\"a\":", depth, "}]")}) {
            sidecar("{\"schema\":\"stridor.sidecar/1\",\"metadata\":{\"a\":" + text + "}}");
            sidecar(text);
            manifest("{\"schema\":\"stridor.library-archive/1\"}\n{\"system\":" + text + "}\n");
        }
        // a text of an entry that is read as a document once it is shown
        const std::string verdict = nested("[", depth, "]");
        noise_library::Entry entry;
        entry.verdict = verdict;
        require(io::library_json("library.sqlite", std::array{entry}).find("\"" + verdict + "\"") != std::string::npos);
        require(io::without_verdict(entry).verdict.empty());
        for (const auto& text : {nested("[", depth, "]"), nested("{a=", depth, "}"), nested("a.", depth, ""),
                                 nested("[", 64, "]"), nested("{a=", 64, "}"), nested("a.", 64, "")})
            for (const std::string& document : {"a = " + text + "\n", text + "a = 1\n", "[" + text + "]\n"})
                try {
                    static_cast<void>(io::parse_toml({document, "case.toml", {}}));
                } catch (const Error& error) {
                    require(error.kind() == ErrorKind::input);
                }
        riff("RIFF" + std::string(4, '\0') + "WAVE" + nested(std::string("JUNK\0\0\0\0", 8), depth, ""));
        uff58(nested("    -1\n    15\n", depth, "    -1\n"));
        signal_csv(nested("#\n", depth, "\n"));
        signal_csv(nested("\"", depth, ","));
    });
}

}  // namespace
}  // namespace stridor::fuzz
