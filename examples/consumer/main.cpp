// The smallest user of the installed library: says which Stridor it was linked with.

#include "stridor/base/version.hpp"

#include <iostream>

int main() {
    std::cout << "Stridor " << stridor::base::version() << ", commit " << stridor::base::commit() << '\n';
}
