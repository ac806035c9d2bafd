# libmorphe: what the headers in pipeline/library, core/motion, store and verify show, with
# everything that it takes inside. Its packages are its own business; who links it sees Eigen alone.
set(shown)
foreach(folder motion store verify library)
  list(APPEND shown $<TARGET_OBJECTS:morphe_${folder}>)
endforeach()
add_library(libmorphe SHARED ${shown})
target_link_libraries(libmorphe PRIVATE morphe_library PUBLIC Eigen3::Eigen)
morphe_exports(libmorphe exports_library)
target_compile_features(libmorphe INTERFACE cxx_std_20)
# core/motion/geometry.hpp refuses anything else.
target_compile_definitions(libmorphe INTERFACE ${morphe_eigen})
# Otherwise the linker looks into our packages, finds that they call functions of Eigen that the
# program has, too, and shows them its own.
target_link_options(libmorphe INTERFACE LINKER:--allow-shlib-undefined)
target_include_directories(libmorphe INTERFACE $<INSTALL_INTERFACE:include> $<INSTALL_INTERFACE:include/morphe>)
# Until 1.0 each minor version may change what is shown.
set_target_properties(libmorphe PROPERTIES
  OUTPUT_NAME morphe EXPORT_NAME morphe LINKER_LANGUAGE CXX
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Morphe)
install(TARGETS morphe DESTINATION bin)
install(TARGETS libmorphe EXPORT Morphe LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT Morphe NAMESPACE Morphe:: FILE MorpheTargets.cmake DESTINATION ${config_folder})
configure_package_config_file(cmake/MorpheConfig.cmake.in ${CMAKE_BINARY_DIR}/MorpheConfig.cmake
  INSTALL_DESTINATION ${config_folder} NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/MorpheConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/MorpheConfig.cmake ${CMAKE_BINARY_DIR}/MorpheConfigVersion.cmake
  DESTINATION ${config_folder})
install(FILES pipeline/library/morphe.hpp DESTINATION include/morphe)
install(DIRECTORY core/motion DESTINATION include/morphe/core FILES_MATCHING PATTERN *.hpp
  # functions of Eigen's types, which would have to be shown
  PATTERN goal_interpolation.hpp EXCLUDE PATTERN bounding_box.hpp EXCLUDE PATTERN find_world_frames.hpp EXCLUDE
  PATTERN revisit.hpp EXCLUDE)
install(FILES core/store/demonstration_file.hpp core/store/plan_file.hpp DESTINATION include/morphe/core/store)
install(FILES stages/verify/verify.hpp stages/verify/violation.hpp DESTINATION include/morphe/stages/verify)
# Where core/files/data_files.hpp looks, from bin and from lib.
install(DIRECTORY configs datasets DESTINATION share/morphe)
# What a shell and man(1) find: the program itself says what they show.
set(completion pipeline/commands/completion)
install(FILES ${completion}/morphe.bash DESTINATION share/bash-completion/completions RENAME morphe)
install(FILES ${completion}/_morphe DESTINATION share/zsh/vendor-completions)
install(FILES ${completion}/morphe.fish DESTINATION share/fish/vendor_completions.d)
add_custom_command(TARGET morphe POST_BUILD BYPRODUCTS morphe.1.gz
  COMMAND sh -c "$<TARGET_FILE:morphe> --man | gzip -9n > morphe.1.gz" VERBATIM)
install(FILES ${CMAKE_BINARY_DIR}/morphe.1.gz DESTINATION share/man/man1)
install(FILES LICENSE DESTINATION share/doc/morphe RENAME copyright)
install(FILES README.md CITATION.cff DESTINATION share/doc/morphe)
install(DIRECTORY docs DESTINATION share/doc/morphe)
# The reader for Python, where Debian's Python looks below /usr.
install(DIRECTORY python/morphe DESTINATION lib/python3/dist-packages FILES_MATCHING PATTERN *.py PATTERN py.typed
  PATTERN __pycache__ EXCLUDE)

# cpack: one package for Debian with all of this. What it needs is read off the files themselves.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME morphe)
set(CPACK_PACKAGE_CONTACT "The Morphe authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DESCRIPTION "Morphe reads recordings of people who reach and grasp, and writes
trajectories of a robot arm with a hand that look alike, keep all limits and
collide with nothing, each with a certificate that a second command verifies.
The package contains the program, a C++ library, a reader of the plans for
Python, robots and recordings.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libeigen3-dev (>= 3.4), python3-h5py")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "python3-matplotlib")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_SOURCE_DIR}/cmake/what_cpack_needs.cmake)
include(CPack)
