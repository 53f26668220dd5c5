#include "stridor/cluster/hello.hpp"

#include "stridor/base/sha256.hpp"
#include "stridor/base/version.hpp"
#include "stridor/sweep/store/store.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>

namespace stridor::cluster {

namespace {

std::string host_name() {
    std::array<char, 256> name{};
    if (gethostname(name.data(), name.size() - 1) != 0) return "a machine without a name";
    return name.data();
}

}  // namespace

Hello hello_of(const sweep::Study& study, std::size_t threads) {
    Hello hello;
    hello.build = fmt::format("stridor {} ({}), results {}", base::version(), base::commit(), sweep::results_version);
    hello.study = base::sha256_text(sweep::canonical_text(study));
    hello.host = host_name();
    hello.threads = static_cast<std::uint32_t>(threads);
    return hello;
}

void expect_same(const Hello& ours, const Hello& theirs, int rank) {
    const std::string where = fmt::format("rank {} on {}", rank, theirs.host);
    if (theirs.build != ours.build)
        throw Error(ErrorKind::input,
                    {where + " runs another program than rank 0 on " + ours.host,
                     theirs.build + " there, " + ours.build + " here", "Start the same program everywhere."});
    if (theirs.study != ours.study)
        throw Error(ErrorKind::input, {where + " reads another chart than rank 0 on " + ours.host,
                                       "the file, or one that it names, is not the same there",
                                       "Give it by a path that leads to one file from everywhere."});
}

}  // namespace stridor::cluster
