// Prints the golden results as tests/golden/golden.txt has them: name and hash of all their bits.

#include "golden/results.hpp"
#include "stridor/base/hash.hpp"
#include "stridor/integration/kernels/exact_kernel.hpp"
#include "stridor/recordings/bytes.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <cstdio>
#include <stdexcept>

namespace stridor::storage {

// files that the test lends
std::string read_file(const std::string& path) {
    std::FILE* file = std::fopen(path.c_str(), "rb");
    if (file == nullptr) throw std::runtime_error("cannot open " + path);
    std::string text;
    for (int letter = std::fgetc(file); letter != EOF; letter = std::fgetc(file))
        text += static_cast<char>(letter);
    std::fclose(file);
    return text;
}

}  // namespace stridor::storage

int main() {
    for (const stridor::golden::Result& result :
         stridor::golden::results(stridor::integration::InstructionSet::baseline))
        std::printf("%s %s %s\n", result.name.c_str(), stridor::base::hash_text(result.values).c_str(),
                    result.extract.c_str());
}
