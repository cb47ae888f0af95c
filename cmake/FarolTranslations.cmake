# Translations. A build only ever reads translations/*.ts (lrelease); `cmake --build --preset release --target
# update_translations` is the one thing that writes them (lupdate over ui/, app/ and the tables of what core says), so that
# no build can overwrite a translator's work.
include_guard()

set(FAROL_LANGUAGES en pt es fr de)

# farol_translation_resources(<variable>): a C++ source with every .qm as :/farol/translations/farol_<language>.qm.
# It belongs into the library whose installTranslation() names the resource (Q_INIT_RESOURCE).
function(farol_translation_resources sources)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/translations)
  file(MAKE_DIRECTORY ${folder})
  set(list "<RCC><qresource prefix=\"/farol/translations\">\n")
  set(compiled)
  foreach(language IN LISTS FAROL_LANGUAGES)
    set(ts ${PROJECT_SOURCE_DIR}/translations/farol_${language}.ts)
    set(qm ${folder}/farol_${language}.qm)
    add_custom_command(OUTPUT ${qm} COMMAND Qt6::lrelease -silent ${ts} -qm ${qm} DEPENDS ${ts} VERBATIM)
    list(APPEND compiled ${qm})
    string(APPEND list "  <file>farol_${language}.qm</file>\n")
  endforeach()
  file(CONFIGURE OUTPUT ${folder}/farol_translations.qrc CONTENT "${list}</qresource></RCC>\n" @ONLY)
  add_custom_command(OUTPUT ${folder}/qrc_farol_translations.cpp
    COMMAND Qt6::rcc --name farol_translations -o ${folder}/qrc_farol_translations.cpp ${folder}/farol_translations.qrc
    DEPENDS ${compiled} ${folder}/farol_translations.qrc VERBATIM)
  set(${sources} ${folder}/qrc_farol_translations.cpp PARENT_SCOPE)
endfunction()

# English holds plural forms only: its texts are the ones in the sources.
set(FAROL_FULL_LANGUAGES ${FAROL_LANGUAGES})
list(REMOVE_ITEM FAROL_FULL_LANGUAGES en)
list(TRANSFORM FAROL_FULL_LANGUAGES REPLACE "(.+)" "translations/farol_\\1.ts" OUTPUT_VARIABLE FAROL_FULL_TS)
# Core knows no Qt, so its sentences stand within names of its own. check_collected.py collects in the same way.
set(FAROL_COLLECT -silent -recursive -I ${PROJECT_SOURCE_DIR} -locations none -no-obsolete
                  -tr-function-alias QT_TRANSLATE_NOOP+=SAID,QT_TRANSLATE_N_NOOP+=SAID_OF_MANY)
set(FAROL_WITH_TEXTS ui app core/base/base_sayings.cpp core/building/sentence_table.cpp core/capture/sayings.cpp
                     core/recognition/sayings.cpp core/session/sayings.cpp)
add_custom_target(update_translations
  COMMAND Qt6::lupdate ${FAROL_COLLECT} -pluralonly ${FAROL_WITH_TEXTS} -ts translations/farol_en.ts
  COMMAND Qt6::lupdate ${FAROL_COLLECT} ${FAROL_WITH_TEXTS} -ts ${FAROL_FULL_TS}
  WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
  COMMENT "Collecting texts of ui/, app/ and core into translations/farol_*.ts"
  VERBATIM)
