# cmake -D FOLDER=ir/diag/explain -D OUTPUT=explain_pages.inc -P ExplainPages.cmake
# Writes the explain pages as initialisers {code, text}, in the order of the codes. (GCC 12 has no #embed.)
cmake_policy(VERSION 3.25)

file(GLOB pages ${FOLDER}/F*.md)
list(SORT pages)
set(rows "")
foreach(page IN LISTS pages)
    get_filename_component(code "${page}" NAME_WE)
    file(READ "${page}" text)
    string(APPEND rows "{\"${code}\", R\"page(${text})page\"},\n")
endforeach()
file(WRITE ${OUTPUT} "${rows}")
