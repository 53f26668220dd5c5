# Third-party packages. They are imported targets, whose headers the compiler treats as system headers.
# A package that a module links must also stand in stridorConfig.cmake.in: a static library passes it on.

find_package(PkgConfig REQUIRED)
find_package(Eigen3 3.4 REQUIRED)         # small matrices: Eigen3::Eigen
find_package(Spectra 1.0 REQUIRED)        # modes of large matrices: Spectra::Spectra
find_package(fmt REQUIRED)                # text: fmt::fmt
find_package(TBB REQUIRED)                # threads: TBB::tbb
find_package(SQLite3 REQUIRED)            # stores and library: SQLite::SQLite3
find_package(nlohmann_json 3.11 REQUIRED) # JSON: nlohmann_json::nlohmann_json
find_package(Boost 1.74 REQUIRED)         # Beast, the explorer's server: Boost::headers
find_package(CLI11 REQUIRED)              # command line: CLI11::CLI11
pkg_check_modules(sndfile REQUIRED IMPORTED_TARGET sndfile)                 # recordings: PkgConfig::sndfile
pkg_check_modules(tomlplusplus REQUIRED IMPORTED_TARGET tomlplusplus>=3.3)  # cases: PkgConfig::tomlplusplus

pkg_check_modules(netcdf REQUIRED IMPORTED_TARGET netcdf)                   # exports: PkgConfig::netcdf
pkg_check_modules(cairo REQUIRED IMPORTED_TARGET cairo>=1.16)               # figures: PkgConfig::cairo
pkg_check_modules(pangocairo REQUIRED IMPORTED_TARGET pangocairo>=1.50)     # their text: PkgConfig::pangocairo
pkg_check_modules(libarchive REQUIRED IMPORTED_TARGET libarchive>=3.6)      # archives: PkgConfig::libarchive
find_path(metis_INCLUDE_DIRS metis.h REQUIRED DOC "Headers of METIS")       # orders the rows of large parts
find_library(metis_LIBRARY metis REQUIRED DOC "METIS")

# Optional libraries are opened while the program runs (base/opened_library): a machine may lack them. To build, only
# their headers are needed, and the name by which the loader finds the version they belong to.
#
# Sets RESULT to that name of the library NAME of the package: "libmatio.so.11"; empty where it is not found.
function(stridor_find_opened_library package name result)
    find_library(file NAMES ${name} HINTS ${${package}_LIBRARY_DIRS} NO_CACHE)
    file(REAL_PATH "${file}" path)
    string(REGEX MATCH "lib${name}\\.so\\.[0-9]+" soname "${path}")
    set(${result} "${soname}" PARENT_SCOPE)
endfunction()

# optional: compressed recordings
pkg_check_modules(ffmpeg QUIET libavformat>=59.27 libavcodec>=59.37 libavutil>=57.28 libswresample>=4.7)
if(NOT ffmpeg_FOUND)
    message(STATUS "No ffmpeg libraries: recordings in AAC, AMR and WebM are not read")
else()
    foreach(library IN ITEMS avformat avcodec avutil swresample)
        stridor_find_opened_library(ffmpeg ${library} ${library}_NAME)
        list(APPEND ffmpeg_NAMES ${${library}_NAME})
    endforeach()
endif()
# optional: MAT files
pkg_check_modules(matio QUIET matio>=1.5)
if(matio_FOUND)
    stridor_find_opened_library(matio matio matio_NAME)
endif()
if(NOT matio_NAME)
    set(matio_FOUND FALSE)
    message(STATUS "No libmatio: MAT files are not read")
endif()

# optional: MUMPS without MPI, for large solids. Its interface is of one version, which the library's name holds as well
option(STRIDOR_MUMPS "Let parts be factorised by MUMPS, where its headers and its sequential library are found" ON)
find_path(mumps_INCLUDE_DIRS dmumps_c.h DOC "Headers of MUMPS")
set(mumps_NAME "")
if(STRIDOR_MUMPS AND mumps_INCLUDE_DIRS)
    file(STRINGS "${mumps_INCLUDE_DIRS}/dmumps_c.h" mumps_version REGEX "define MUMPS_VERSION \"" LIMIT_COUNT 1)
    string(REGEX MATCH "[0-9]+\\.[0-9]+" mumps_version "${mumps_version}")
    find_library(mumps_LIBRARY "libdmumps_seq-${mumps_version}.so" DOC "MUMPS without MPI; used when found")
    if(mumps_LIBRARY)
        set(mumps_NAME "libdmumps_seq-${mumps_version}.so")
    endif()
endif()
if(mumps_NAME)
    set(mumps_FOUND TRUE)
else()
    set(mumps_FOUND FALSE)
    set(mumps_INCLUDE_DIRS "")
    message(STATUS "No sequential MUMPS: large finite-element parts are factorised by Eigen alone")
endif()

# optional: MPI, for stridor-mpi alone
set(STRIDOR_MPI AUTO CACHE STRING "Build stridor-mpi, for charts on a cluster: AUTO (where MPI is found), ON or OFF")
set_property(CACHE STRIDOR_MPI PROPERTY STRINGS AUTO ON OFF)
set(MPI_C_FOUND FALSE)
if(NOT STRIDOR_MPI STREQUAL "OFF")
    enable_language(C)  # FindMPI looks for the interface of C, which is the one that is used
    if(STRIDOR_MPI STREQUAL "AUTO")
        find_package(MPI QUIET COMPONENTS C)
    else()
        find_package(MPI REQUIRED COMPONENTS C)
    endif()
    if(NOT MPI_C_FOUND)
        message(STATUS "No MPI: stridor-mpi, for charts on a cluster, is not built. Install libopenmpi-dev?")
    endif()
endif()

if(STRIDOR_TESTS)
    find_package(GTest REQUIRED)
    find_package(rapidcheck REQUIRED)
    include(GoogleTest)
endif()
if(STRIDOR_BENCHMARKS)
    find_package(benchmark REQUIRED)
    find_package(SUNDIALS 6 QUIET COMPONENTS cvode nvecserial sunnonlinsolfixedpoint sunlinsoldense
        sunmatrixdense)  # a peer, CVODE; optional
endif()
