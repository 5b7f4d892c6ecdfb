# Debian packages: `cpack --config build/release/CPackConfig.cmake -B DIR` writes boxprobe (the program) and
# libboxprobe-dev (headers and libraries), with what Debian's policy asks for beside them; of a build with BOXPROBE_PYTHON
# python3-boxprobe, too.
set(packages boxprobe libboxprobe-dev)
set(components Program Development)
if(NOT BOXPROBE_APP)
  set(packages libboxprobe-dev)
  set(components Development)
endif()
if(BOXPROBE_PYTHON)
  list(APPEND packages python3-boxprobe)
  list(APPEND components Python)
endif()
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
foreach(package component IN ZIP_LISTS packages components)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${package})
  file(CONFIGURE OUTPUT ${folder}/changelog.Debian @ONLY CONTENT
"${package} (${PROJECT_VERSION}-1) unstable; urgency=medium

  * ${PROJECT_VERSION}: see changelog.gz.

 -- Boxprobe <boxprobe@noreply.invalid>  ${date}
")
  configure_file(${PROJECT_SOURCE_DIR}/CHANGELOG.md ${folder}/changelog COPYONLY)
  file(READ ${PROJECT_SOURCE_DIR}/LICENSE license)
  string(REGEX MATCH "Copyright[^\n]*" holder "${license}")
  string(REPLACE "\n\n" "\n.\n" license "${license}")
  string(REPLACE "\n" "\n " license " ${license}")
  file(CONFIGURE OUTPUT ${folder}/copyright @ONLY CONTENT
"Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: Boxprobe

Files: *
Copyright: ${holder}
License: BSD-3-Clause
${license}
")
  execute_process(COMMAND gzip -9nf ${folder}/changelog ${folder}/changelog.Debian COMMAND_ERROR_IS_FATAL ANY)
  install(FILES ${folder}/changelog.gz ${folder}/changelog.Debian.gz ${folder}/copyright
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component})
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME boxprobe)
set(CPACK_PACKAGE_CONTACT "Boxprobe <boxprobe@noreply.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL ${components})
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME boxprobe)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "libgl1-mesa-dri, fonts-dejavu-core")
# Qt's own texts in the languages of the window.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "qttranslations5-l10n | qt6-translations-l10n")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "reflection probe editor with box projection
Places reflection probes in models, bakes them, draws them with box
projection in physically based shading, and explains any reflected pixel.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libboxprobe-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libvtk9-dev, libglm-dev, libtbb-dev, libopenexr-dev, nlohmann-json3-dev,
 libdraco-dev, libmeshoptimizer-dev, libwebp-dev, libpng-dev, libjpeg-dev, libtinygltf-dev, libstb-dev, libxxhash-dev, libexpat1-dev, zlib1g-dev,
 liblz4-dev, liblzma-dev")
string(REPLACE "\n" "" CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS}")
if(BOXPROBE_FIT)
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", libembree-dev")
endif()
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "reflection probes for VTK programs: libraries and headers
Static libraries, headers, shaders and a CMake package, to light the actors
of a VTK renderer by box-projected reflection probes.")
if(BOXPROBE_PYTHON)
  # An extension is made for one version of Python.
  math(EXPR next_minor "${BOXPROBE_PYTHON_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-boxprobe)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= 3.${BOXPROBE_PYTHON_MINOR}), python3 (<< 3.${next_minor}), python3-vtk9")
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "reflection probes for VTK programs in Python
The package boxprobe, which lights the actors of a VTK renderer by
box-projected reflection probes, beside VTK's own Python modules.")
endif()
include(CPack)
