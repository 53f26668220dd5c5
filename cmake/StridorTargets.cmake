# One helper per kind of target. DEPENDS takes names of Stridor modules (`base`, not `stridor::base`);
# LIBRARIES and PUBLIC_LIBRARIES take third-party targets from StridorDependencies.cmake.
#
#   stridor_module(NAME [SOURCES a.cpp ...] [HEADERS only_header.hpp ...] [DEPENDS modules ...]
#                  [LIBRARIES targets ...] [PUBLIC_LIBRARIES targets ...])
#   stridor_program(NAME SOURCES ... [DEPENDS modules ...] [LIBRARIES targets ...])
#   stridor_test(NAME SOURCES ... [DEPENDS modules ...] [LIBRARIES targets ...] [LABEL label]
#                [TIMEOUT seconds] [COST seconds] [PROGRAM] [THREADS])
#   stridor_example(NAME SOURCE main.cpp [DEPENDS modules ...] [ARGUMENTS ...])
#   stridor_benchmark(NAME SOURCES ... [DEPENDS modules ...] [LIBRARIES targets ...] [OWN_MAIN])

# Every option that a translation unit of ours is compiled with.
#
# EIGEN_NO_CPUID: Eigen cuts the products of large matrices into blocks by the caches of the machine, asked of the
# processor, and adds block after block: with more than some 250 numbers to a sum the last bits would depend on the
# machine. So it takes its own usual sizes (32 KiB, 256 KiB, 2 MiB) everywhere.
#
# These are part of the interface (scope PUBLIC), not only of the build: a program that includes our headers compiles
# their inline functions itself, and the linker keeps one copy of each for everyone. Were that copy compiled with fused
# multiply-adds, or with other checks, the library's own bits would change with its user.
function(stridor_compile_options target scope)
    target_compile_features(${target} ${scope} cxx_std_20)
    target_compile_options(${target} ${scope} -ffp-contract=off)
    target_compile_definitions(${target} ${scope} STRIDOR_CHECKS=$<BOOL:${STRIDOR_CHECKS}> EIGEN_NO_CPUID)
    if(scope STREQUAL "INTERFACE")
        return()
    endif()

    set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
    target_compile_options(${target} PRIVATE
        -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion -Wold-style-cast
        $<$<BOOL:${STRIDOR_WARNINGS_AS_ERRORS}>:-Werror>
        # no path of the building machine in messages, and the same bits from every folder
        -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=)
    # GCC 12 warns wrongly about `"text" + std::string` when it inlines it (GCC bug 105651).
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
        target_compile_options(${target} PRIVATE -Wno-restrict)
    endif()
    # GCC notes that it passed vectors otherwise before version 4.6: nobody links with that.
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        target_compile_options(${target} PRIVATE -Wno-psabi)
    endif()
endfunction()

# Programs are wiring: the modules hold the work, so that a long optimisation is worth nothing here. The
# undefined-behaviour sanitizer costs them a third of their compile time and finds its faults in the modules; the
# address sanitizer stays everywhere.
function(stridor_spare_wiring target)
    if(STRIDOR_SANITIZED)
        target_compile_options(${target} PRIVATE -O0 -fno-sanitize=undefined)
    else()
        target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
    endif()
endfunction()

# Tests even more so: what they measure is in the modules, and not optimised at all they compile in two thirds of the
# time. Those of folders that compute themselves (STRIDOR_TESTS_COMPUTE) are kept as programs are.
function(stridor_spare_test target)
    if(STRIDOR_SANITIZED OR STRIDOR_TESTS_COMPUTE)
        stridor_spare_wiring(${target})
        set(headers stridor_computing_test_headers)
    else()
        target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O0>)
        set(headers stridor_test_headers)
    endif()
    # the headers every test includes are parsed once for all
    target_precompile_headers(${target} REUSE_FROM ${headers})
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        target_compile_options(${target} PRIVATE -fpch-preprocess)  # or ccache keeps nothing
    endif()
endfunction()

# Modules that write texts, tables and pictures spend their time in libraries: half optimised they compile in three
# quarters of the time and run as fast; under sanitizers, not optimised, in half of it, with every check.
function(stridor_spare_optimisation target)
    if(STRIDOR_SANITIZED)
        target_compile_options(${target} PRIVATE -O0)
    else()
        # half optimised GCC 12 takes what a constructor fills for uninitialised; clang and sanitizers look after it
        target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1 -Wno-maybe-uninitialized>)
    endif()
endfunction()

# Nor is the undefined-behaviour sanitizer worth its time in sources that do little but call an eigenvalue solver, whose
# templates take half a minute with it.
function(stridor_spare_sources)
    if(STRIDOR_SANITIZED)
        set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_OPTIONS -fno-sanitize=undefined)
    endif()
endfunction()

# The sources of a target are compiled several at a time (at most eight): one parse of the headers and one copy of each
# template instead of eight, a third of the time. Not in debug builds, which so stay quick to change. A name in the
# unnamed namespace of a source is its own among those of its folder: there is no list of exceptions. -Wshadow would see
# the names of the neighbours, -Wsubobject-linkage would take each source for a header: debug builds look after both.
function(stridor_join_sources target)
    if(ARGC GREATER 1)
        set(most ${ARGV1})
    else()
        set(most 8)
    endif()
    if(NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
        set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${most})
        target_compile_options(${target} PRIVATE -Wno-shadow -Wno-subobject-linkage)
    endif()
endfunction()

function(stridor_link_modules target scope)
    foreach(module IN LISTS ARGN)
        if(NOT TARGET stridor_${module})
            message(FATAL_ERROR
                "${target} depends on module '${module}', which is not there (a module may depend only on modules "
                "above it in STRIDOR_MODULES). Is src/stridor/${module}/CMakeLists.txt missing or later in the list?")
        endif()
        target_link_libraries(${target} ${scope} stridor::${module})
    endforeach()
endfunction()

function(stridor_check_arguments helper name)
    if(ARG_UNPARSED_ARGUMENTS)
        message(FATAL_ERROR "${helper}(${name}): unknown arguments '${ARG_UNPARSED_ARGUMENTS}'")
    endif()
endfunction()

# A static library stridor_NAME, known as stridor::NAME. Its public headers are the .hpp beside each source and the
# HEADERS; both are installed, and each must compile on its own. Without SOURCES the module is header-only.
function(stridor_module name)
    cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "SOURCES;HEADERS;DEPENDS;LIBRARIES;PUBLIC_LIBRARIES")
    stridor_check_arguments(stridor_module ${name})

    set(headers)
    foreach(source IN LISTS ARG_SOURCES)
        string(REGEX REPLACE "\\.cpp$" ".hpp" header "${source}")
        if(NOT header STREQUAL source AND EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/${header}")
            list(APPEND headers "${header}")
        endif()
    endforeach()
    list(REMOVE_ITEM ARG_HEADERS ${headers})

    set(target stridor_${name})
    if(ARG_SOURCES)
        set(scope PUBLIC)
        add_library(${target} STATIC ${ARG_SOURCES})
        # ready to be linked into a Python extension
        set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    else()
        set(scope INTERFACE)
        add_library(${target} INTERFACE)
    endif()
    add_library(stridor::${name} ALIAS ${target})
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
    # a source includes its own header first (the structure test sees to it), which shows that the header compiles on
    # its own; headers without a source are verified by the target all_verify_interface_header_sets
    target_sources(${target} ${scope}
        FILE_SET HEADERS BASE_DIRS "${PROJECT_SOURCE_DIR}/src" FILES ${headers}
        FILE_SET alone TYPE HEADERS BASE_DIRS "${PROJECT_SOURCE_DIR}/src" FILES ${ARG_HEADERS})
    set_target_properties(${target} PROPERTIES INTERFACE_HEADER_SETS_TO_VERIFY alone)

    stridor_compile_options(${target} ${scope})
    if(ARG_SOURCES)
        # sixteen take a sixth less time than eight
        stridor_join_sources(${target} 16)
    endif()
    stridor_link_modules(${target} ${scope} ${ARG_DEPENDS})
    target_link_libraries(${target} ${scope} ${ARG_PUBLIC_LIBRARIES})
    if(ARG_LIBRARIES)
        target_link_libraries(${target} PRIVATE ${ARG_LIBRARIES})
    endif()
    set_property(GLOBAL APPEND PROPERTY STRIDOR_MODULE_TARGETS ${target})
endfunction()

# An executable that users run: built as ${CMAKE_BINARY_DIR}/NAME and installed.
function(stridor_program name)
    cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "SOURCES;DEPENDS;LIBRARIES")
    stridor_check_arguments(stridor_program ${name})
    add_executable(${name} ${ARG_SOURCES})
    set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}")
    target_include_directories(${name} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
    stridor_compile_options(${name} PRIVATE)
    stridor_spare_wiring(${name})
    stridor_join_sources(${name})
    stridor_link_modules(${name} PRIVATE ${ARG_DEPENDS})
    target_link_libraries(${name} PRIVATE ${ARG_LIBRARIES})
    set_property(GLOBAL APPEND PROPERTY STRIDOR_PROGRAM_TARGETS ${name})
endfunction()

# A GoogleTest executable NAME_test, which is one CTest, `NAME`, with one LABEL (default: fast): a start for each of its
# cases would cost more than most of what they test, and cases that share a simulation make it once. In a debug build
# each case is a CTest of its own. The longest (COST, what it takes under sanitizers) start first.
# Sources may include "support/..." from tests/, find the checkout at STRIDOR_SOURCE_DIR (a string literal), and, with
# PROGRAM, start the built program (support/process.hpp). Two targets build some of them: module_tests all without
# PROGRAM, thread_tests what runs on several threads (THREADS); these have the label `threads` as well under sanitizers:
# the thread sanitizer runs these alone.
function(stridor_test name)
    cmake_parse_arguments(PARSE_ARGV 1 ARG "PROGRAM;THREADS" "LABEL;TIMEOUT;COST" "SOURCES;DEPENDS;LIBRARIES")
    stridor_check_arguments(stridor_test ${name})
    if(NOT ARG_LABEL)
        set(ARG_LABEL fast)
    endif()
    if(NOT ARG_TIMEOUT)
        set(ARG_TIMEOUT 1200)
    endif()
    if(NOT ARG_COST)
        set(ARG_COST 1)
    endif()

    set(target ${name}_test)
    add_executable(${target} ${ARG_SOURCES})
    target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}/tests")
    target_compile_definitions(${target} PRIVATE STRIDOR_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    stridor_compile_options(${target} PRIVATE)
    stridor_spare_test(${target})
    stridor_join_sources(${target})
    stridor_link_modules(${target} PRIVATE ${ARG_DEPENDS})
    target_link_libraries(${target} PRIVATE ${ARG_LIBRARIES} GTest::gtest_main rapidcheck)
    if(ARG_THREADS)
        add_dependencies(thread_tests ${target})
    endif()
    if(ARG_PROGRAM)
        add_dependencies(${target} stridor)
        target_link_libraries(${target} PRIVATE stridor_test_program)
    else()
        add_dependencies(module_tests ${target})
    endif()
    if(CMAKE_BUILD_TYPE STREQUAL "Debug")
        gtest_discover_tests(${target}
            DISCOVERY_MODE PRE_TEST
            DISCOVERY_TIMEOUT 60
            PROPERTIES LABELS ${ARG_LABEL} TIMEOUT ${ARG_TIMEOUT})
        return()
    endif()
    set(environment "")
    if(STRIDOR_SANITIZED)
        if(ARG_THREADS)
            list(APPEND ARG_LABEL threads)
        endif()
        list(APPEND environment
            "LSAN_OPTIONS=print_suppressions=0:suppressions=${PROJECT_SOURCE_DIR}/tests/support/leak_sanitizer.supp")
        if(ARG_PROGRAM)
            # looking at frames that returned costs the program a fifth of its time;
            # tests of modules do (CMakePresets.json)
            list(APPEND environment "ASAN_OPTIONS=strict_string_checks=1")
        endif()
    endif()
    add_test(NAME ${name} COMMAND ${target} --gtest_brief=1)
    set_tests_properties(${name} PROPERTIES
        LABELS "${ARG_LABEL}" TIMEOUT ${ARG_TIMEOUT} COST ${ARG_COST} ENVIRONMENT "${environment}")
endfunction()

# A small program that teaches; CTest runs it as example.NAME in its own folder. Without DEPENDS it gets every module.
function(stridor_example name)
    cmake_parse_arguments(PARSE_ARGV 1 ARG "" "SOURCE" "DEPENDS;ARGUMENTS")
    stridor_check_arguments(stridor_example ${name})
    set(target example_${name})
    add_executable(${target} ${ARG_SOURCE})
    stridor_compile_options(${target} PRIVATE)
    if(ARG_DEPENDS)
        stridor_link_modules(${target} PRIVATE ${ARG_DEPENDS})
    else()
        target_link_libraries(${target} PRIVATE stridor::stridor)
    endif()
    set(folder "${CMAKE_CURRENT_BINARY_DIR}/${name}")
    file(MAKE_DIRECTORY "${folder}")
    add_test(NAME example.${name} COMMAND ${target} ${ARG_ARGUMENTS} WORKING_DIRECTORY "${folder}")
    set_tests_properties(example.${name} PROPERTIES LABELS example TIMEOUT 300)
endfunction()

# A Google Benchmark executable NAME_benchmark in ${CMAKE_BINARY_DIR}/benchmarks, where `./dev bench` finds it; with
# OWN_MAIN a program that measures by itself.
function(stridor_benchmark name)
    cmake_parse_arguments(PARSE_ARGV 1 ARG "OWN_MAIN" "" "SOURCES;DEPENDS;LIBRARIES")
    stridor_check_arguments(stridor_benchmark ${name})
    set(target ${name}_benchmark)
    add_executable(${target} ${ARG_SOURCES})
    set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/benchmarks")
    stridor_compile_options(${target} PRIVATE)
    target_compile_definitions(${target} PRIVATE STRIDOR_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    stridor_link_modules(${target} PRIVATE ${ARG_DEPENDS})
    target_link_libraries(${target} PRIVATE ${ARG_LIBRARIES})
    if(NOT ARG_OWN_MAIN)
        target_link_libraries(${target} PRIVATE benchmark::benchmark_main)
    endif()
endfunction()
