# Writes the source file behind stridor/base/version.hpp, so that every result can name its program and commit.

set(STRIDOR_COMMIT "unknown")
find_package(Git QUIET)

# An archive unpacked inside another repository must not report that repository's commit: ask for our own .git.
if(GIT_FOUND AND EXISTS "${PROJECT_SOURCE_DIR}/.git")
    execute_process(
        COMMAND "${GIT_EXECUTABLE}" rev-parse --verify --quiet HEAD
        WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
        OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET
        RESULT_VARIABLE status)
    if(status EQUAL 0)
        set(STRIDOR_COMMIT "${commit}")
    endif()

    # Configure again when a commit or a checkout moves HEAD. The log of HEAD also moves when the branch is packed.
    execute_process(
        COMMAND "${GIT_EXECUTABLE}" symbolic-ref --quiet HEAD
        WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
        OUTPUT_VARIABLE branch OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    foreach(name IN ITEMS HEAD logs/HEAD ${branch})
        execute_process(
            COMMAND "${GIT_EXECUTABLE}" rev-parse --git-path ${name}
            WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
            OUTPUT_VARIABLE path OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
        get_filename_component(path "${path}" ABSOLUTE BASE_DIR "${PROJECT_SOURCE_DIR}")
        if(EXISTS "${path}" AND NOT IS_DIRECTORY "${path}")
            set_property(DIRECTORY "${PROJECT_SOURCE_DIR}" APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${path}")
        endif()
    endforeach()
endif()

set(STRIDOR_VERSION_SOURCE "${PROJECT_BINARY_DIR}/generated/version.cpp")
configure_file("${PROJECT_SOURCE_DIR}/cmake/version.cpp.in" "${STRIDOR_VERSION_SOURCE}" @ONLY)
