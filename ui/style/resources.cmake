# What is compiled into the studio: tokens, icons, bodies, motions, documents and Debian's Roboto (Apache-2.0). The list is
# written at configure time, so that a new icon is one file and no font lies in this tree.
find_path(NOCTULE_ROBOTO_DIR Roboto-Regular.ttf
    PATHS /usr/share/fonts/truetype/roboto/unhinted/RobotoTTF /usr/share/fonts/truetype/roboto
    NO_DEFAULT_PATH)
if(NOT NOCTULE_ROBOTO_DIR)
    message(FATAL_ERROR "Roboto-Regular.ttf was not found. Install the package fonts-roboto-unhinted, "
        "or set NOCTULE_ROBOTO_DIR to the folder that holds Roboto's TTF files.")
endif()

set(files "")
file(GLOB found CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/resources
    ${PROJECT_SOURCE_DIR}/resources/style/*.json ${PROJECT_SOURCE_DIR}/resources/icons/*.svg
    ${PROJECT_SOURCE_DIR}/resources/bodies/*.glb
    ${PROJECT_SOURCE_DIR}/resources/docs/*.md ${PROJECT_SOURCE_DIR}/resources/docs/*.svg
    ${PROJECT_SOURCE_DIR}/resources/pictures/*.png
    ${PROJECT_SOURCE_DIR}/resources/motions/*.bvh)
foreach(name IN LISTS found)
    string(APPEND files "<file alias=\"${name}\">${PROJECT_SOURCE_DIR}/resources/${name}</file>\n")
endforeach()
foreach(weight Light Regular Medium Bold)
    string(APPEND files "<file alias=\"fonts/Roboto-${weight}.ttf\">${NOCTULE_ROBOTO_DIR}/Roboto-${weight}.ttf</file>\n")
endforeach()
set(studio_qrc ${CMAKE_CURRENT_BINARY_DIR}/studio.qrc)
file(CONFIGURE OUTPUT ${studio_qrc} @ONLY
    CONTENT "<RCC><qresource prefix=\"/noctule\">\n${files}</qresource></RCC>\n")
qt5_add_resources(studio_resources ${studio_qrc})
target_sources(noctule_ui_style PRIVATE ${studio_resources})
