# What every target of this project is compiled with.
add_library(morphe_flags INTERFACE)
target_include_directories(morphe_flags INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(morphe_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
# g++ 12 warns of overlaps inside its own std::string (GCC bug 105651).
target_compile_options(morphe_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
# a * b - c * d is zero where both products are equal: predicates count on it.
target_compile_options(morphe_flags INTERFACE -ffp-contract=off)
# Small dense matrices are most of the work; packages were compiled for 16-byte alignment.
if(MORPHE_ARCH)
  target_compile_options(morphe_flags INTERFACE -march=${MORPHE_ARCH})
  target_compile_definitions(morphe_flags INTERFACE EIGEN_MAX_ALIGN_BYTES=16)
  # g++ 12 warns of its own vector intrinsics (GCC bug 105593), of AVX-512's even more.
  target_compile_options(morphe_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized;-Wno-array-bounds>)
  if(NOT MORPHE_ARCH STREQUAL default_arch)
    target_compile_options(morphe_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-uninitialized>)
  endif()
endif()
if(MORPHE_WARNINGS_AS_ERRORS)
  target_compile_options(morphe_flags INTERFACE -Werror)
endif()
if(MORPHE_SANITIZE)
  target_compile_options(morphe_flags INTERFACE -fsanitize=${MORPHE_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(morphe_flags INTERFACE -fsanitize=${MORPHE_SANITIZE})
endif()

# morphe_folder(pipeline/store DEPENDS motion LIBRARIES hdf5::hdf5): one target for one folder,
# called after the folder's last name. DEPENDS names other folders, LIBRARIES outside packages.
# Public headers show Eigen (and PUBLIC_LIBRARIES); other packages stay behind the .cpp files.
function(morphe_folder path)
  cmake_parse_arguments(ARG "" "" "DEPENDS;LIBRARIES;PUBLIC_LIBRARIES" ${ARGN})
  get_filename_component(name ${path} NAME)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${path}/*.cpp)
  list(TRANSFORM ARG_DEPENDS PREPEND morphe_)
  if(sources)
    add_library(morphe_${name} STATIC ${sources})
    target_link_libraries(morphe_${name} PUBLIC morphe_flags Eigen3::Eigen ${ARG_DEPENDS} ${ARG_PUBLIC_LIBRARIES}
                                         PRIVATE ${ARG_LIBRARIES})
  else()
    add_library(morphe_${name} INTERFACE)
    target_link_libraries(morphe_${name} INTERFACE morphe_flags Eigen3::Eigen ${ARG_DEPENDS})
  endif()
endfunction()
