# What `cmake --install` puts where, and the Debian package of it (cpack).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

if(BUILD_SHARED_LIBS)
  set(installed oblast_shared)
else()
  set(installed oblast_core)
endif()
set(cmake_folder ${CMAKE_INSTALL_LIBDIR}/cmake/oblast)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/oblast DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(TARGETS ${installed} EXPORT oblastTargets)
install(EXPORT oblastTargets NAMESPACE oblast:: DESTINATION ${cmake_folder})
configure_package_config_file(cmake/oblastConfig.cmake.in oblastConfig.cmake INSTALL_DESTINATION ${cmake_folder})
write_basic_package_version_file(oblastConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/oblastConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/oblastConfigVersion.cmake
  DESTINATION ${cmake_folder})

# pkg-config: a static library brings oneTBB to the link. A shared one has it in its own list of libraries, and whoever
# uses it needs no headers of oneTBB; as Requires.private they would have to be there, for pkg-config looks for them.
if(NOT BUILD_SHARED_LIBS)
  set(requires "Requires: tbb")
endif()
configure_file(cmake/oblast.pc.in oblast.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/oblast.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

if(OBLAST_BUILD_PROGRAM)
  install(TARGETS oblast_program RUNTIME)
  find_program(HELP2MAN help2man)
  find_package(Python3 COMPONENTS Interpreter)
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/generated)
  file(MAKE_DIRECTORY ${generated})
  if(HELP2MAN AND NOT CMAKE_CROSSCOMPILING)
    add_custom_command(OUTPUT ${generated}/oblast.1
      COMMAND ${HELP2MAN} --no-info --name "${PROJECT_DESCRIPTION}" --output ${generated}/oblast.1
              $<TARGET_FILE:oblast_program>
      DEPENDS oblast_program VERBATIM)
    add_custom_target(oblast_man ALL DEPENDS ${generated}/oblast.1)
    install(FILES ${generated}/oblast.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  endif()
  if(Python3_FOUND AND NOT CMAKE_CROSSCOMPILING)
    add_custom_command(OUTPUT ${generated}/oblast.bash ${generated}/_oblast ${generated}/oblast.fish
      COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/tools/completions $<TARGET_FILE:oblast_program> ${generated}
      DEPENDS oblast_program ${PROJECT_SOURCE_DIR}/tools/completions VERBATIM)
    add_custom_target(oblast_completions ALL DEPENDS ${generated}/oblast.bash)
    install(FILES ${generated}/oblast.bash RENAME oblast DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
    install(FILES ${generated}/_oblast DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
    install(FILES ${generated}/oblast.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
  endif()
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME oblast)
set(CPACK_PACKAGE_CONTACT "the oblast developers <oblast@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}: program, library and headers")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "librsvg2-2")  # loaded when a picture is drawn as PNG
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "g++, pkg-config, cmake")
include(CPack)
