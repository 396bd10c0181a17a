// SPDX-License-Identifier: Apache-2.0
// The language changes while the studio runs: the window is made anew, what is open stays open.
#include "ui/language/language.h"

#include <QComboBox>
#include <QMenuBar>
#include <QPointer>
#include <QProcess>

#include "tests/ui/main_window/studio_fixture.h"
#include "tests/ui/support/screen_words.h"
#include "ui/main_window/preferences_dialog.h"
#include "ui/main_window/studio_windows.h"
#include "ui/main_window/top_bar.h"
#include "ui/style/words.h"

namespace noctule::ui {
namespace {

using test::ScreenWords;

class Language : public test::StudioWindow {
protected:
    void SetUp() override {
        StudioWindow::SetUp();
        openSampleTake();
        window_.reset();
        windows_ = std::make_unique<StudioWindows>(*studio_);
        windows_->show(Step::kReview);
    }
    void TearDown() override {
        windows_.reset();
        StudioWindow::TearDown();
    }

    static PreferencesDialog* preferences() {
        return qobject_cast<PreferencesDialog*>(QApplication::activeModalWidget());
    }
    /// As the operator does it; the preferences that open in the new language are closed again.
    void choose(const char* code) {
        const QPointer<MainWindow> before = windows_->window();
        bool chosen = false, closed = false;
        QTimer looking;
        QObject::connect(&looking, &QTimer::timeout, [&] {
            PreferencesDialog* dialog = preferences();
            if (dialog && before && !chosen) {
                chosen = true;
                QComboBox& box = dialog->language();
                box.setCurrentIndex(box.findData(code));
                emit box.activated(box.currentIndex());
            } else if (dialog && !before) {
                closed = true;
                preferences_title_ = dialog->windowTitle();
                looking.stop();
                dialog->accept();
            }
        });
        looking.start(20);
        windows_->window()->showPreferences();
        ASSERT_TRUE(waitFor([&] { return closed; }));
    }
    QString firstMenu() const { return windows_->window()->topBar().menuBar().actions().first()->text(); }

    std::unique_ptr<StudioWindows> windows_;
    QString preferences_title_;
};

TEST_F(Language, ChangesAtRunTimeAndKeepsWhatIsOpen) {
    EXPECT_EQ(firstMenu(), "&File");
    const QString take = studio_->take().path();
    choose("de");
    EXPECT_EQ(preferences_title_, "Einstellungen");
    EXPECT_EQ(firstMenu(), "&Datei");
    EXPECT_EQ(windows_->window()->step(), Step::kReview);
    EXPECT_TRUE(studio_->session().isOpen());
    EXPECT_EQ(studio_->take().path(), take);
    EXPECT_EQ(numberText(1.5, 1), "1,5");
    choose("en");
    EXPECT_EQ(firstMenu(), "&File");
    EXPECT_EQ(numberText(1.5, 1), "1.5");
}

TEST_F(Language, NoMenuIsCutOff) {
    choose("de");
    MainWindow& window = *windows_->window();
    for (const int width : {1200, 1280, 1360, 1440, 1600}) {
        window.resize(width, 800);
        QTest::qWait(50);
        const QMenuBar& menus = window.topBar().menuBar();
        EXPECT_TRUE(window.topBar().isFolded() ||
                    menus.actionGeometry(menus.actions().last()).right() <= menus.width())
            << width;
    }
    EXPECT_FALSE(window.topBar().isFolded()) << "there is room for them";
}

TEST_F(Language, KeysAreThoseOfAGermanKeyboard) {
    choose("de");
    const QStringList words = ScreenWords::of(*windows_->window());
    EXPECT_TRUE(words.contains("Öffnet Aufnehmen (Strg+R)")) << "is qttranslations5-l10n installed?";
    EXPECT_TRUE(words.contains("Anfang an den Zeiger setzen (Strg+I)"));
    EXPECT_EQ(keysText(QKeySequence("Ctrl+Shift+Z")), "Strg+Umschalt+Z");
}

TEST_F(Language, ASessionMadeByDateHasAPerformerInTheOperatorsLanguage) {
    choose("de");
    studio_->session().close();
    ASSERT_TRUE(studio_->session().makeSure());
    EXPECT_EQ(studio_->session().session().current_performer, "Darsteller 1");
    ASSERT_EQ(studio_->session().session().performers.size(), 1u);
    EXPECT_EQ(studio_->session().session().performers[0].name, "Darsteller 1");
}

TEST_F(Language, EveryPageSpeaksGerman) {
    studio_->jobs().clearEnded();  // what was said before stays as it was said
    choose("de");
    for (const Step step : test::kEveryStep) {
        windows_->window()->goTo(step);
        QCoreApplication::processEvents();
        const QStringList words = ScreenWords::of(*windows_->window());
        for (const QString& text : ScreenWords::notGerman(words))
            ADD_FAILURE() << text.toStdString();
    }
}

/// The system's locale is read once by a program: this one starts itself on a German desktop.
class DesktopLanguage : public test::StudioWindow {
protected:
    static constexpr const char* kOnGermanDesktop = "DesktopLanguage.OnAGermanDesktopTheStudioIsGerman";
};

TEST_F(DesktopLanguage, OnAGermanDesktopTheStudioIsGerman) {
    if (qEnvironmentVariable("LANGUAGE") != "de")
        GTEST_SKIP() << "started by the next test";
    EXPECT_EQ(window_->topBar().menuBar().actions().first()->text(), "&Datei");
}

TEST_F(DesktopLanguage, TheDesktopsLanguageIsChosenAtFirst) {
    QProcessEnvironment german = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"LC_ALL", "LC_MESSAGES", "GTEST_TOTAL_SHARDS", "GTEST_SHARD_INDEX"})
        german.remove(name);
    german.insert("LANG", "en_US.UTF-8");
    german.insert("LANGUAGE", "de");
    QProcess studio;
    studio.setProcessEnvironment(german);
    studio.start(QCoreApplication::applicationFilePath(), {QString("--gtest_filter=") + kOnGermanDesktop});
    ASSERT_TRUE(studio.waitForFinished(-1));
    EXPECT_EQ(studio.exitCode(), 0) << studio.readAllStandardOutput().toStdString();
}

}  // namespace
}  // namespace noctule::ui
