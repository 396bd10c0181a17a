# `cmake --install` and the Debian package. Only what users need is installed; nothing else is built for it.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
set(helpers ${CMAKE_INSTALL_LIBEXECDIR}/noctule)
set(share ${CMAKE_INSTALL_DATADIR})

install(TARGETS noctule noctule-virtual-suit noctule-virtual-robot RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
if(TARGET noctule-ros-bridge)
    install(TARGETS noctule-ros-bridge RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(TARGETS noctule-read-mesh RUNTIME DESTINATION ${helpers})
install(TARGETS noctule_media_module LIBRARY DESTINATION ${helpers})
install(FILES ${NOCTULE_HELP_DIR}/noctule.bash DESTINATION ${share}/bash-completion/completions RENAME noctule)
install(FILES ${NOCTULE_HELP_DIR}/noctule.bash DESTINATION ${share}/bash-completion/completions
    RENAME noctule-virtual-suit)
install(FILES ${NOCTULE_HELP_DIR}/noctule.bash DESTINATION ${share}/bash-completion/completions
    RENAME noctule-virtual-robot)
install(FILES ${NOCTULE_HELP_DIR}/_noctule DESTINATION ${share}/zsh/vendor-completions)
install(DIRECTORY resources/docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs)
install(DIRECTORY resources/pictures DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY resources/robots DESTINATION ${share}/noctule)
install(DIRECTORY resources/suits DESTINATION ${share}/noctule)
install(DIRECTORY resources/casts DESTINATION ${share}/noctule)
install(FILES resources/motions/sample.bvh DESTINATION ${share}/noctule/motions)
install(DIRECTORY resources/motions/trajectories DESTINATION ${share}/noctule/motions)
install(FILES packaging/debian/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})
if(NOCTULE_STUDIO)
    install(FILES packaging/desktop/noctule.desktop DESTINATION ${share}/applications)
    install(FILES packaging/desktop/org.noctule.Noctule.metainfo.xml DESTINATION ${share}/metainfo)
    install(FILES packaging/desktop/noctule-mime.xml DESTINATION ${share}/mime/packages RENAME noctule.xml)
    install(FILES packaging/desktop/noctule.svg DESTINATION ${share}/icons/hicolor/scalable/apps)
    install(FILES packaging/desktop/application-x-noctule-take.svg
        DESTINATION ${share}/icons/hicolor/scalable/mimetypes)
endif()

# Manual pages and changelog are packed, as Debian wants them.
find_program(NOCTULE_GZIP gzip REQUIRED)
set(packed "")
function(noctule_pack file name)
    set(out ${CMAKE_BINARY_DIR}/packed/${name}.gz)
    add_custom_command(OUTPUT ${out} COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_BINARY_DIR}/packed
        COMMAND ${NOCTULE_GZIP} -9nc ${file} > ${out} DEPENDS ${file} VERBATIM)
    set(packed ${packed} ${out} PARENT_SCOPE)
endfunction()
noctule_pack(${NOCTULE_HELP_DIR}/noctule.1 noctule.1)
noctule_pack(${NOCTULE_HELP_DIR}/noctule-virtual-suit.1 noctule-virtual-suit.1)
noctule_pack(${NOCTULE_HELP_DIR}/noctule-virtual-robot.1 noctule-virtual-robot.1)
noctule_pack(${PROJECT_SOURCE_DIR}/CHANGELOG.md changelog)
add_custom_target(noctule_packed DEPENDS ${packed})
add_dependencies(noctule_packed noctule_help)
install(FILES ${CMAKE_BINARY_DIR}/packed/noctule.1.gz ${CMAKE_BINARY_DIR}/packed/noctule-virtual-suit.1.gz
    ${CMAKE_BINARY_DIR}/packed/noctule-virtual-robot.1.gz
    DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${CMAKE_BINARY_DIR}/packed/changelog.gz DESTINATION ${CMAKE_INSTALL_DOCDIR})

# All that is installed: cmake --build DIR --target installed && cmake --install DIR --prefix /usr/local
add_custom_target(installed)
add_dependencies(installed noctule noctule-virtual-suit noctule-virtual-robot noctule-read-mesh noctule_media_module noctule_packed)

noctule_describe(version)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME noctule)
set(CPACK_PACKAGE_VERSION ${version})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "motion capture with gyroscopes, accelerometers and ultrasound")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Noctule records a suit of small boards and ultrasonic sources, computes the motion
of the body that wears it, shows it live, judges it and exports it as FBX, GLB,
BVH, CSV and OpenSim tables. A virtual suit takes the place of a real one.")
set(CPACK_PACKAGE_CONTACT "The Noctule authors <noctule@localhost>")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Loaded while the program runs, so that no tool finds them: OpenGL through libepoxy, Qt's own words in German.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libegl1, libgl1, qttranslations5-l10n")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libgl1-mesa-dri, qtspeech5-speechd-plugin")
set(CPACK_OUTPUT_FILE_PREFIX ${CMAKE_BINARY_DIR}/packages)
include(CPack)
