// SPDX-License-Identifier: Apache-2.0
// Runs the tests of the studio's rooms: one application, a settings folder of its own, C numbers. A test in
// which an icon was missing fails, and one in which a phase followed another that does not lead to it.
#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <clocale>

namespace {

QtMessageHandler usual_handler = nullptr;

void failOnOwnFaults(QtMsgType type, const QMessageLogContext& context, const QString& message) {
    if (qstrcmp(context.category, "noctule.icons") == 0 || qstrcmp(context.category, "noctule.phases") == 0)
        ADD_FAILURE() << message.toStdString();
    else
        usual_handler(type, context, message);
}

}  // namespace

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    if (testing::GTEST_FLAG(list_tests))
        return RUN_ALL_TESTS();
    const QTemporaryDir home;  // programs that run side by side share no files
    qputenv("HOME", home.path().toLocal8Bit());
    QStandardPaths::setTestModeEnabled(true);
    QApplication application(argc, argv);
    usual_handler = qInstallMessageHandler(failOnOwnFaults);
    std::setlocale(LC_NUMERIC, "C");
    QApplication::setOrganizationName("Noctule");
    QApplication::setApplicationName("noctule-test");
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, home.path());
    return RUN_ALL_TESTS();
}
