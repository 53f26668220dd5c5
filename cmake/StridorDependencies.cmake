# Third-party packages. They are imported targets, whose headers the compiler treats as system headers.
# A package that a module links must also stand in stridorConfig.cmake.in: a static library passes it on.

find_package(PkgConfig REQUIRED)
find_package(Eigen3 3.4 REQUIRED)         # small matrices: Eigen3::Eigen
find_package(fmt REQUIRED)                # text: fmt::fmt
find_package(TBB REQUIRED)                # threads: TBB::tbb
find_package(SQLite3 REQUIRED)            # stores and library: SQLite::SQLite3
find_package(nlohmann_json 3.11 REQUIRED) # JSON: nlohmann_json::nlohmann_json
find_package(Boost 1.74 REQUIRED)         # Beast, the explorer's server: Boost::headers
find_package(CLI11 REQUIRED)              # command line: CLI11::CLI11
pkg_check_modules(netcdf REQUIRED IMPORTED_TARGET netcdf)                   # exports: PkgConfig::netcdf
pkg_check_modules(sndfile REQUIRED IMPORTED_TARGET sndfile)                 # recordings: PkgConfig::sndfile
pkg_check_modules(tomlplusplus REQUIRED IMPORTED_TARGET tomlplusplus>=3.3)  # cases: PkgConfig::tomlplusplus
pkg_check_modules(cairo REQUIRED IMPORTED_TARGET cairo>=1.16)               # figures: PkgConfig::cairo
pkg_check_modules(pangocairo REQUIRED IMPORTED_TARGET pangocairo>=1.50)     # their text: PkgConfig::pangocairo
# optional: compressed recordings; the libraries are opened while the program runs, so only headers are needed
pkg_check_modules(ffmpeg QUIET libavformat>=59.27 libavcodec>=59.37 libavutil>=57.28 libswresample>=4.7)
if(NOT ffmpeg_FOUND)
    message(STATUS "No ffmpeg libraries: recordings in AAC, AMR and WebM are not read")
endif()
# optional: MAT files; opened while the program runs, by the name of the version whose headers these are
pkg_check_modules(matio QUIET matio>=1.5)
if(matio_FOUND)
    find_library(matio_FILE NAMES matio HINTS ${matio_LIBRARY_DIRS})
    file(REAL_PATH "${matio_FILE}" matio_path)
    string(REGEX MATCH "libmatio\\.so\\.[0-9]+" matio_NAME "${matio_path}")
endif()
if(NOT matio_NAME)
    set(matio_FOUND FALSE)
    message(STATUS "No libmatio: MAT files are not read")
endif()

if(STRIDOR_TESTS)
    find_package(GTest REQUIRED)
    find_package(rapidcheck REQUIRED)
    include(GoogleTest)
endif()
if(STRIDOR_BENCHMARKS)
    find_package(benchmark REQUIRED)
    find_package(SUNDIALS 6 QUIET COMPONENTS cvode nvecserial sunnonlinsolfixedpoint)  # a peer, CVODE; optional
endif()
