# The explorer's page: TypeScript in explorer/, bundled by esbuild, put into the program as bytes.
# Needs Node.js 18 or later with npm; without them, or with STRIDOR_PAGE=OFF, the program says that it has no page.

find_program(STRIDOR_NODE node DOC "Node.js; bundles the explorer's page")
find_program(STRIDOR_NPM npm DOC "npm; fetches what the bundle is made with")
if(STRIDOR_NODE AND STRIDOR_NPM)
    set(stridor_page_default ON)
else()
    set(stridor_page_default OFF)
endif()
option(STRIDOR_PAGE "Build the page of `stridor explore` into the program" ${stridor_page_default})

# Defines the rule for FILE, a header with the page's files as arrays named index_html, page_js and so on.
function(stridor_page file)
    set(folder "${PROJECT_SOURCE_DIR}/explorer")
    set(bundle "${CMAKE_CURRENT_BINARY_DIR}/page")
    set(names index.html page.js chunk.js later.js microphone.js page.css)
    set(embed "${PROJECT_SOURCE_DIR}/cmake/embed.cmake")
    list(TRANSFORM names PREPEND "${bundle}/" OUTPUT_VARIABLE files)
    if(NOT STRIDOR_PAGE)
        file(WRITE "${bundle}/index.html"
            "<!doctype html><title>stridor</title><p>This stridor was built without its page "
            "(Node.js was missing, or STRIDOR_PAGE off). Install nodejs and npm, and build or install it once more.\n")
        foreach(name page.js chunk.js later.js microphone.js page.css)
            file(WRITE "${bundle}/${name}" "\n")
        endforeach()
        add_custom_command(OUTPUT "${file}"
            COMMAND ${CMAKE_COMMAND} "-DFILES=${files}" "-DOUTPUT=${file}" -P "${embed}"
            DEPENDS "${embed}" VERBATIM)
        return()
    endif()
    # one folder of packages serves every build folder
    set(packages "${folder}/node_modules/.package-lock.json")
    add_custom_command(OUTPUT "${packages}"
        COMMAND ${STRIDOR_NPM} ci --no-audit --no-fund --loglevel=error
        COMMAND ${CMAKE_COMMAND} -E touch "${packages}"
        WORKING_DIRECTORY "${folder}"
        DEPENDS "${folder}/package-lock.json" "${folder}/package.json"
        COMMENT "Fetch what the explorer's page is bundled with" VERBATIM)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${folder}/src/*")
    add_custom_command(OUTPUT ${files}
        COMMAND ${STRIDOR_NODE} build.mjs "${bundle}"
        WORKING_DIRECTORY "${folder}"
        DEPENDS ${sources} "${folder}/build.mjs" "${packages}"
        COMMENT "Bundle the explorer's page" VERBATIM)
    add_custom_command(OUTPUT "${file}"
        COMMAND ${CMAKE_COMMAND} "-DFILES=${files}" "-DOUTPUT=${file}" -P "${embed}"
        DEPENDS ${files} "${embed}" VERBATIM)
endfunction()
