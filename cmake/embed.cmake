# cmake -DFILES=a;b -DOUTPUT=file.inc [-DLIST=name] -P embed.cmake: files as arrays of bytes,
# named after them (index.html: index_html), and their names with them in the array `name`.
set(text "")
set(entries "")
foreach(file IN LISTS FILES)
    get_filename_component(file_name "${file}" NAME)
    string(MAKE_C_IDENTIFIER "${file_name}" name)
    file(READ "${file}" bytes HEX)
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
    string(APPEND text "constexpr unsigned char ${name}[] = {${bytes}};\n")
    string(APPEND entries "    {\"${file_name}\", ${name}, sizeof ${name}},\n")
endforeach()
if(LIST)
    string(APPEND text "struct EmbeddedFile {\n    const char* name;\n    const unsigned char* bytes;\n"
        "    unsigned long size;\n};\nconstexpr EmbeddedFile ${LIST}[] = {\n${entries}};\n")
endif()
file(WRITE "${OUTPUT}" "${text}")
