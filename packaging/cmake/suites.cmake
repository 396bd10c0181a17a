# SPDX-License-Identifier: Apache-2.0
# Script: writes OUT, which adds to CTest each suite of the built test program PROGRAM as PREFIX/suite. A suite is one
# process: its tests share what they prepare, and a thousand starts less are a tenth of the time of all tests.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE " *#[^\n]*" "" listed "${listed}")  # values of parameters, which may hold brackets
string(REPLACE "\n" ";" lines "${listed}")
set(suites "")
foreach(line IN LISTS lines)
    if(line MATCHES "^([^ ]+)\\.$")
        set(suite "${CMAKE_MATCH_1}")
        list(APPEND suites "${suite}")
        set(count_of_${suite} 0)
    elseif(line MATCHES "^ +[^ ]")
        math(EXPR count_of_${suite} "${count_of_${suite}} + 1")
    endif()
endforeach()
if(NOT suites)
    message(FATAL_ERROR "${PROGRAM} lists no tests")
endif()
set(text "")
foreach(suite IN LISTS suites)
    # The suites with the most tests begin first, so that none is waited for at the end.
    string(APPEND text "add_test([==[${PREFIX}/${suite}]==] [==[${PROGRAM}]==] [==[--gtest_filter=${suite}.*]==])\n"
        "set_tests_properties([==[${PREFIX}/${suite}]==] PROPERTIES TIMEOUT 3600 COST ${count_of_${suite}})\n")
endforeach()
file(WRITE ${OUT} "${text}")
