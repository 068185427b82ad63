# Warnings, sanitizers and the one way in which a layer becomes a target.

add_library(fagorc_options INTERFACE)
target_compile_options(fagorc_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Werror)
# GCC 12 warns falsely about `"text" + std::string` in optimised builds (GCC bug 105651).
target_compile_options(fagorc_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
# GCC packs the two coordinates of a point into one register and reads both at once what was stored one by one: each such
# load waits for the stores (15 cycles), and points are everywhere.
target_compile_options(fagorc_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
if(FAGORC_SANITIZE)
    # Without the checks for null: with them GCC takes no address of a function for a constant (GCC bug 71962), which the
    # tables are made of; the address sanitizer sees a null pointer anyway.
    add_compile_options(-fsanitize=address,undefined -fno-sanitize=null,nonnull-attribute,returns-nonnull-attribute
                        -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
    add_link_options(-fsanitize=address,undefined)
endif()

# fagorc_layer(NAME LINKS target...): all .cpp files below the current folder, as library fagorc_NAME.
function(fagorc_layer name)
    cmake_parse_arguments(ARG "" "" "LINKS;PRIVATE" ${ARGN})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    add_library(fagorc_${name} STATIC ${sources})
    target_include_directories(fagorc_${name} PUBLIC ${PROJECT_SOURCE_DIR})
    target_link_libraries(fagorc_${name} PUBLIC ${ARG_LINKS} PRIVATE fagorc_options ${ARG_PRIVATE})
endfunction()
