// SPDX-License-Identifier: Apache-2.0
// The lines of a take's notes on a German screen.
#include "ui/views/review/take_notes.h"

#include <gtest/gtest.h>

#include "tests/ui/support/speak.h"

namespace noctule::ui {
namespace {

TEST(TakeNotes, WhatTheBoxSaysIsInTheLanguageOfTheStudio) {
    TakeOverview take;
    take.notes = {{"", "0:06.4 Driver box: the link is too slow, sound was dropped"}};
    test::speak("de");
    const QString german = takeNoteLines(take).value(0);
    test::speak("en");
    EXPECT_TRUE(german.contains("Steuerbox: die Verbindung ist zu langsam, Ton ging verloren"))
        << german.toStdString();
}

}  // namespace
}  // namespace noctule::ui
