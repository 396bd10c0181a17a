// SPDX-License-Identifier: Apache-2.0
// Whether anything is cut, in every look: 100 and 150 percent, both themes, in the language of the parameter.
#pragma once

#include "tests/ui/main_window/studio_fixture.h"
#include "tests/ui/support/clipping.h"
#include "tests/ui/support/screen_words.h"
#include "ui/language/language.h"
#include "ui/style/theme.h"

namespace noctule::ui::test {

/// In the language that is the parameter.
class ClippingFixture : public StudioWindow, public testing::WithParamInterface<const char*> {
protected:
    void SetUp() override {
        StudioWindow::SetUp();
        chooseLanguage(studio_->settings(), GetParam());
        applyLanguage(studio_->settings());
        restart();
    }
    void TearDown() override {
        Theme::get().setScale(1);
        Theme::get().setScheme(Scheme::kDark);
        StudioWindow::TearDown();
    }

    template <class Look>
    void inEveryLook(Look look) {
        for (const double scale : {1.0, 1.5})
            for (const Scheme scheme : {Scheme::kDark, Scheme::kLight}) {
                Theme::get().setScale(scale);
                Theme::get().setScheme(scheme);
                look(QStringLiteral("%1, %2 %, %3")
                         .arg(GetParam())
                         .arg(100 * scale)
                         .arg(scheme == Scheme::kDark ? "dark" : "light"));
            }
    }

    void expectWholeAndItsLanguage(const QWidget& widget, const QString& where) {
        expectWhole(widget, where);
        if (QLatin1String(GetParam()) == "de" && Theme::get().scale() == 1)
            for (const QString& text : ScreenWords::notGerman(ScreenWords::of(widget)))
                ADD_FAILURE() << where.toStdString() << " is not German: " << text.toStdString();
    }

    /// A busy machine may take a while to lay out; what stays cut is a fault.
    static void expectWhole(const QWidget& widget, const QString& where) {
        if (QTest::qWaitFor([&] { return Clipping::in(widget).isEmpty(); }, 30'000))
            return;
        for (const QString& cut : Clipping::in(widget))
            ADD_FAILURE() << where.toStdString() << ": " << cut.toStdString();
    }
};

}  // namespace noctule::ui::test
