# The version as users see it: `git describe` where there is git, else the project's number. It is asked for at each
# build, and written only when it has changed.
cmake_minimum_required(VERSION 3.25)
include_guard()

# As a script, cmake -D SOURCE=. -D NUMBER=0.1.0 -D OUT=version.cpp -P version.cmake: writes the source file.
if(CMAKE_SCRIPT_MODE_FILE)
    set(NOCTULE_ASKED_SOURCE ${SOURCE})
    set(NOCTULE_ASKED_NUMBER ${NUMBER})
else()
    set(NOCTULE_ASKED_SOURCE ${PROJECT_SOURCE_DIR})
    set(NOCTULE_ASKED_NUMBER ${PROJECT_VERSION})
endif()

# Tags of releases are v1.2.3. 0.1.0: on the tag. 0.1.0-7-g1a2b3c4: seven changes later. 0.1.0+g1a2b3c4: no tag yet.
# -dirty: with changes that are in no commit.
function(noctule_describe variable)
    set(version ${NOCTULE_ASKED_NUMBER})
    find_program(NOCTULE_GIT git)
    if(NOCTULE_GIT AND EXISTS ${NOCTULE_ASKED_SOURCE}/.git)
        execute_process(
            COMMAND ${NOCTULE_GIT} -c safe.directory=${NOCTULE_ASKED_SOURCE} -C ${NOCTULE_ASKED_SOURCE} describe --always
                --dirty --abbrev=8 "--match=v[0-9]*"
            OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
        if(NOT failed AND described MATCHES "^v([0-9].*)$")
            set(version ${CMAKE_MATCH_1})
        elseif(NOT failed AND described)
            set(version ${NOCTULE_ASKED_NUMBER}+g${described})
        endif()
    endif()
    set(${variable} ${version} PARENT_SCOPE)
endfunction()

if(CMAKE_SCRIPT_MODE_FILE)
    noctule_describe(version)
    file(CONFIGURE OUTPUT ${OUT} CONTENT "// SPDX-License-Identifier: Apache-2.0
#include \"app/batch/version.h\"

const char* noctule::batch::softwareVersion() {
    return \"${version}\";
}
")
else()
    set(NOCTULE_VERSION_SOURCE ${PROJECT_BINARY_DIR}/version.cpp)
    add_custom_target(noctule_version BYPRODUCTS ${NOCTULE_VERSION_SOURCE}
        COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D NUMBER=${PROJECT_VERSION}
            -D OUT=${NOCTULE_VERSION_SOURCE} -P ${CMAKE_CURRENT_LIST_FILE}
        COMMENT "Asking for the version")
endif()
