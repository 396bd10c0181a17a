// SPDX-License-Identifier: Apache-2.0
// Qt's own words on a German screen: buttons of its dialogs, menus of text fields, names of keys, and why a
// link failed. They stand in a package of Debian's, which packaging/dependencies.sh and our package bring.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QFile>
#include <QFileDialog>
#include <QKeySequence>
#include <QLabel>
#include <QLibraryInfo>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <memory>

#include "tests/ui/support/speak.h"

namespace noctule::ui {
namespace {

class QtWords : public testing::Test {
protected:
    void SetUp() override {
        const QString folder = QLibraryInfo::location(QLibraryInfo::TranslationsPath);
        for (const char* name : {"qtbase_de.qm", "qtserialport_de.qm", "qtwebsockets_de.qm"})
            ASSERT_TRUE(QFile::exists(folder + '/' + name))
                << "cannot run: " << folder.toStdString() << " has no " << name
                << ". Install qttranslations5-l10n; packaging/dependencies.sh does.";
        test::speak("de");
    }
    void TearDown() override { test::speak("en"); }

    static QStringList textsOf(const QMenu& menu) {
        QStringList texts;
        for (const QAction* action : menu.actions())
            if (!action->isSeparator())
                texts << QString(action->text()).remove('&').section('\t', 0, 0);
        return texts;
    }
};

TEST_F(QtWords, ButtonsOfDialogsAreGerman) {
    const QDialogButtonBox box(QDialogButtonBox::Yes | QDialogButtonBox::No | QDialogButtonBox::Cancel |
                               QDialogButtonBox::Save | QDialogButtonBox::Discard | QDialogButtonBox::Close);
    QStringList texts;
    for (const QAbstractButton* button : box.buttons())
        texts << QString(button->text()).remove('&');
    texts.sort();
    EXPECT_EQ(texts.join(' ').toStdString(), "Abbrechen Ja Nein Schließen Speichern Verwerfen");
}

TEST_F(QtWords, MenusOfTextFieldsAreGerman) {
    QLineEdit line;
    const std::unique_ptr<QMenu> of_line(line.createStandardContextMenu());
    const QStringList wanted{"Rückgängig", "Wiederherstellen", "Ausschneiden",   "Kopieren",
                             "Einfügen",   "Löschen",          "Alles auswählen"};
    EXPECT_EQ(textsOf(*of_line).join(' ').toStdString(), wanted.join(' ').toStdString());
    QPlainTextEdit area;
    const std::unique_ptr<QMenu> of_area(area.createStandardContextMenu());
    EXPECT_EQ(textsOf(*of_area).join(' ').toStdString(), wanted.join(' ').toStdString());
}

TEST_F(QtWords, FileDialogsAreGerman) {
    QFileDialog dialog;
    dialog.setOption(QFileDialog::DontUseNativeDialog);
    dialog.setAcceptMode(QFileDialog::AcceptOpen);
    QStringList texts;
    for (const QLabel* label : dialog.findChildren<QLabel*>())
        texts << QString(label->text()).remove('&');
    EXPECT_TRUE(texts.contains("Dateien des Typs:")) << texts.join(' ').toStdString();
    EXPECT_FALSE(texts.contains("Files of type:"));
}

TEST_F(QtWords, KeysAreThoseOfAGermanKeyboard) {
    const auto written = [](const char* keys) {
        return QKeySequence(keys).toString(QKeySequence::NativeText).toStdString();
    };
    EXPECT_EQ(written("Ctrl+R"), "Strg+R");
    EXPECT_EQ(written("Ctrl+Shift+M"), "Strg+Umschalt+M");
    EXPECT_EQ(written("Del"), "Entf");
    EXPECT_EQ(QCoreApplication::translate("noctule::ui::words", "Enter", "a key").toStdString(), "Eingabe");
    EXPECT_EQ(QKeySequence("Ctrl+,"), QKeySequence(int{Qt::CTRL} + Qt::Key_Comma))
        << "keys are still understood";
}

TEST_F(QtWords, WhyALinkFailedIsGerman) {
    EXPECT_EQ(QCoreApplication::translate("QNativeSocketEngine", "Connection refused").toStdString(),
              "Verbindung verweigert");
    EXPECT_NE(QCoreApplication::translate("QSerialPort", "Permission error while locking the device"),
              "Permission error while locking the device");
}

TEST_F(QtWords, AreEnglishAgainAfterwards) {
    test::speak("en");
    const QDialogButtonBox box(QDialogButtonBox::Cancel);
    EXPECT_EQ(QString(box.buttons().first()->text()).remove('&'), "Cancel");
}

}  // namespace
}  // namespace noctule::ui
