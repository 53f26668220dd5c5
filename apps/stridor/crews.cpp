#include "crews.hpp"

#include "stridor/sweep/thread_crew.hpp"

namespace stridor::app {

sweep::CrewMaker crews(int threads) {
    return sweep::thread_crews(threads);
}

bool helps_with(const sweep::Study&, int) {
    return false;
}

}  // namespace stridor::app
