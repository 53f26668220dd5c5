#include "stridor/cluster/hello.hpp"

#include "stridor/base/sha256.hpp"
#include "stridor/base/version.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>

namespace stridor::cluster {

namespace {

std::string build() {
    return fmt::format("stridor {} ({})", base::version(), base::commit());
}

}  // namespace

std::string host_name() {
    std::array<char, 256> name{};
    if (gethostname(name.data(), name.size() - 1) != 0) return "a machine without a name";
    return name.data();
}

Begin begin_of(const crew::Work& work) {
    return {build(), base::sha256_text(work.text), host_name()};
}

Failure mismatch(const Begin& begun, int rank) {
    const std::string where = fmt::format("rank {} on {}", rank, host_name());
    if (begun.build != build())
        return {ErrorKind::input,
                {where + " runs another program than rank 0 on " + begun.host,
                 build() + " there, " + begun.build + " here", "Start the same program everywhere."}};
    return {ErrorKind::input,
            {where + " reads another case or chart than rank 0 on " + begun.host,
             "the file, or one that it names, is not the same there",
             "Give it by a path that leads to one file from everywhere."}};
}

}  // namespace stridor::cluster
