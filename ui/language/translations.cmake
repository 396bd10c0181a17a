# The languages of the studio, compiled in. English has plural forms only, German everything;
# what core says is matched as it stands in core_de.ts (core_words.h).
qt5_add_translation(translations ${PROJECT_SOURCE_DIR}/resources/translations/noctule_en.ts
    ${PROJECT_SOURCE_DIR}/resources/translations/noctule_de.ts)
set(entries "<file alias=\"core_de.ts\">${PROJECT_SOURCE_DIR}/resources/translations/core_de.ts</file>\n")
foreach(file IN LISTS translations)
    get_filename_component(name ${file} NAME)
    string(APPEND entries "<file alias=\"${name}\">${file}</file>\n")
endforeach()
set(translations_qrc ${CMAKE_CURRENT_BINARY_DIR}/translations.qrc)
file(CONFIGURE OUTPUT ${translations_qrc} @ONLY
    CONTENT "<RCC><qresource prefix=\"/noctule/translations\">\n${entries}</qresource></RCC>\n")
qt5_add_resources(translation_resources ${translations_qrc})
target_sources(noctule_ui_language PRIVATE ${translation_resources})
