# What every target of this project is compiled with.
add_library(morphe_flags INTERFACE)
target_include_directories(morphe_flags INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(morphe_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
# Indices are signed, and containers count without sign: g++'s -Wconversion lets that pass.
target_compile_options(morphe_flags INTERFACE $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>)
# g++ 12 warns of overlaps inside its own std::string (GCC bug 105651).
target_compile_options(morphe_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
# … and, behind a precompiled header, of copies inside its own strings.
target_compile_options(morphe_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overread;-Wno-stringop-overflow>)
# a * b - c * d is zero where both products are equal: predicates count on it.
target_compile_options(morphe_flags INTERFACE -ffp-contract=off)
# How Eigen's types lie in memory, and how the heap is asked for theirs, must not depend on the
# processor that a file is compiled for: packages, the library and its users share them.
set(morphe_eigen EIGEN_MAX_ALIGN_BYTES=16 EIGEN_MALLOC_ALREADY_ALIGNED=0)
target_compile_definitions(morphe_flags INTERFACE ${morphe_eigen})
# The library is made of the same objects as the programs; hidden as they are, this costs nothing.
target_compile_options(morphe_flags INTERFACE -fPIC)
# Small dense matrices are most of the work.
if(MORPHE_ARCH)
  target_compile_options(morphe_flags INTERFACE -march=${MORPHE_ARCH})
  # g++ 12 warns of its own vector intrinsics (GCC bug 105593), of AVX-512's even more.
  target_compile_options(morphe_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized;-Wno-array-bounds>)
  if(NOT MORPHE_ARCH STREQUAL default_arch)
    target_compile_options(morphe_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-uninitialized>)
  endif()
endif()
# Packages instantiate the same Eigen templates for other processors: what a program or library shows
# of its own, the loader would hand to them. So everything is hidden, and what namespace std brings
# out again (a std::vector of Eigen's) is kept in when linking; tests/symbols_test.py looks.
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)

# morphe_exports(TARGET MAP): a program or shared library shows what cmake/MAP.map names, nothing else.
function(morphe_exports target map)
  set(script ${PROJECT_SOURCE_DIR}/cmake/${map}.map)
  target_link_options(${target} PRIVATE -Wl,--version-script=${script})
  set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${script})
endfunction()

# What is released ends at a fault of memory, instead of going on with it: checked buffers, guarded
# stacks, tables of the linker that cannot be written, addresses that differ from run to run.
if(NOT MORPHE_SANITIZE)
  target_compile_options(morphe_flags INTERFACE $<$<CONFIG:Release>:-fstack-protector-strong;-U_FORTIFY_SOURCE;-D_FORTIFY_SOURCE=2>)
  target_link_options(morphe_flags INTERFACE $<$<CONFIG:Release>:LINKER:-z,relro,-z,now>
                      $<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:-pie>)
endif()

if(MORPHE_WARNINGS_AS_ERRORS)
  target_compile_options(morphe_flags INTERFACE -Werror)
endif()
if(MORPHE_SANITIZE)
  target_compile_options(morphe_flags INTERFACE -fsanitize=${MORPHE_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(morphe_flags INTERFACE -fsanitize=${MORPHE_SANITIZE})
endif()
# libFuzzer sees which branches an input takes. Checks of every pointer before it is used take a
# tenth to a quarter of the compiler's time: a wrong one is found when it is used, and scripts/test --asan has them.
if(MORPHE_FUZZ)
  target_compile_options(morphe_flags INTERFACE -fsanitize=fuzzer-no-link -fno-sanitize=null,alignment,object-size)
endif()
# The linker sees what every file takes a type for: two of one name are an error.
if(MORPHE_COMPARE_TYPES)
  target_compile_options(morphe_flags INTERFACE -flto)
  target_link_options(morphe_flags INTERFACE -flto=auto -Werror=odr -Werror=lto-type-mismatch)
endif()
# What the precompiled header includes is linked everywhere, so that one fits all; which folder may
# include it says folders.txt.
target_link_libraries(morphe_flags INTERFACE Eigen3::Eigen fmt::fmt nlohmann_json::nlohmann_json)

# A compiler cache is used where there is one; it has to be told that a precompiled header is as
# good as what it was made from.
find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros
      CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${CCACHE})
  target_compile_options(morphe_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
endif()

# morphe_precompiled(TARGET OPTION HEADER…): what nearly every file includes, parsed once for all
# that are compiled with the same options.
file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/precompiled.cpp CONTENT "")
function(morphe_precompiled target option)
  add_library(${target} OBJECT ${CMAKE_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(${target} PRIVATE morphe_flags)
  target_compile_options(${target} PRIVATE ${option})
  target_precompile_headers(${target} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.hpp ${ARGN})
endfunction()
# Folders that folders.txt calls light compute little in loops of their own: the time that compiling them
# with all optimisations takes would hardly come back.
set(morphe_light $<$<CONFIG:Release>:-O1>)
# They are also the ones that read and write JSON.
morphe_precompiled(morphe_precompiled "")
morphe_precompiled(morphe_precompiled_light "${morphe_light}" <nlohmann/json.hpp>)

# g++ ends inlining when a source has grown by 40 %: which of Eigen's functions that cuts off hangs on
# whatever else is in the source. Precompiled headers bring their own parameters with them, so folders
# that folders.txt calls inline do without one.
set(morphe_inline $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:--param=inline-unit-growth=100>)

# morphe_packages(PATH VARIABLE): the CMake targets of the packages that folders.txt gives a folder.
# morphe_folder(PATH): one static library for one folder, morphe_<last name> (robot/files:
# morphe_robot_files), linked as folders.txt says.
set(plan ${PROJECT_SOURCE_DIR}/cmake/folders.txt)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${plan})

function(morphe_target_name path variable)
  string(REGEX REPLACE "^(core|stages|pipeline)/" "" name ${path})
  string(REPLACE "/" "_" name ${name})
  set(${variable} morphe_${name} PARENT_SCOPE)
endfunction()

function(morphe_folder path folders packages)
  morphe_target_name(${path} target)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${path}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
  set(links)
  foreach(folder IN LISTS folders)
    morphe_target_name(${folder} other)
    list(APPEND links ${other})
  endforeach()
  if(sources)
    add_library(${target} STATIC ${sources})
    if(path IN_LIST light_folders)
      target_compile_options(${target} PRIVATE ${morphe_light})
      target_precompile_headers(${target} REUSE_FROM morphe_precompiled_light)
    elseif(path IN_LIST inline_folders)
      target_compile_options(${target} PRIVATE ${morphe_inline})
    else()
      target_precompile_headers(${target} REUSE_FROM morphe_precompiled)
    endif()
    target_link_libraries(${target} PUBLIC morphe_flags ${links} ${packages})
  else()
    add_library(${target} INTERFACE)
    target_link_libraries(${target} INTERFACE morphe_flags ${links} ${packages})
  endif()
endfunction()

# Every folder of the plan.
function(morphe_folders)
  file(STRINGS ${plan} rows REGEX "^(package|light|inline|folder) ")
  foreach(row IN LISTS rows)
    string(REGEX REPLACE " +" ";" words "${row}")
    list(POP_FRONT words kind name)
    if(kind STREQUAL "package")
      list(REMOVE_ITEM words once)
      list(GET words 0 package_${name})
      continue()
    elseif(kind STREQUAL "light")
      list(APPEND light_folders ${name} ${words})
      continue()
    elseif(kind STREQUAL "inline")
      list(APPEND inline_folders ${name} ${words})
      continue()
    endif()
    set(folders)
    set(packages)
    set(part)
    foreach(word IN LISTS words)
      if(word STREQUAL ":")
        set(part ${part}x)
      elseif(part STREQUAL "x")
        list(APPEND folders ${word})
      elseif(DEFINED package_${word})
        list(APPEND packages ${package_${word}})
      else()
        message(FATAL_ERROR "cmake/folders.txt: ${name}: there is no package '${word}'")
      endif()
    endforeach()
    morphe_folder(${name} "${folders}" "${packages}")
    list(APPEND all ${name})
    morphe_target_name(${name} target)
    get_target_property(type ${target} TYPE)
    if(type STREQUAL "STATIC_LIBRARY" AND NOT name IN_LIST light_folders)
      list(APPEND computing $<TARGET_OBJECTS:${target}>)
    endif()
  endforeach()
  set(morphe_all_folders ${all} PARENT_SCOPE)
  set(morphe_computing_objects ${computing} PARENT_SCOPE)
endfunction()
