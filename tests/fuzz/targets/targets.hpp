#pragma once

#include <array>
#include <cstdlib>
#include <string_view>

/// Readers of bytes that nobody vouches for. Each returns, whatever it is given: an `Error` of the user's
/// kind is an end as good as a value, anything else is a finding. libFuzzer drives them (`./dev fuzz`), the
/// tests replay the corpus.
namespace stridor::fuzz {

void signal_csv(std::string_view bytes);
void uff58(std::string_view bytes);
void sidecar(std::string_view bytes);
void calibration(std::string_view bytes);
void riff(std::string_view bytes);
void tar(std::string_view bytes);
void manifest(std::string_view bytes);
void requests(std::string_view bytes);
void store(std::string_view bytes);
void library(std::string_view bytes);
void case_file(std::string_view bytes);
void compressed_audio(std::string_view bytes);
void mat(std::string_view bytes);
void structure(std::string_view bytes);
void numpy(std::string_view bytes);
void calculix(std::string_view bytes);
void nastran(std::string_view bytes);
void abaqus(std::string_view bytes);
void ansys(std::string_view bytes);
void matrix_market(std::string_view bytes);

struct Target {
    std::string_view name;  // of its folder in the corpus
    void (*run)(std::string_view bytes);
};

inline constexpr std::array targets{Target{"signal_csv", signal_csv},
                                    Target{"uff58", uff58},
                                    Target{"sidecar", sidecar},
                                    Target{"calibration", calibration},
                                    Target{"riff", riff},
                                    Target{"tar", tar},
                                    Target{"manifest", manifest},
                                    Target{"store", store},
                                    Target{"library", library},
                                    Target{"case_file", case_file},
                                    Target{"requests", requests},
                                    Target{"compressed_audio", compressed_audio},
                                    Target{"mat", mat},
                                    Target{"structure", structure},
                                    Target{"numpy", numpy},
                                    Target{"calculix", calculix},
                                    Target{"nastran", nastran},
                                    Target{"abaqus", abaqus},
                                    Target{"ansys", ansys},
                                    Target{"matrix_market", matrix_market}};

/// Stops the program where a promise is broken, in every build.
inline void require(bool promise) {
    if (!promise) std::abort();
}

}  // namespace stridor::fuzz
