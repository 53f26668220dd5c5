#include "crews.hpp"

#include "stridor/base/check.hpp"
#include "stridor/crew/thread_crew.hpp"

namespace stridor::app {

crew::CrewMaker crews(int threads) {
    return crew::thread_crews(threads);
}

bool only_helps() {
    return false;
}

void help_with(const crew::Work&, int) {
    STRIDOR_EXPECT(only_helps());
}

}  // namespace stridor::app
