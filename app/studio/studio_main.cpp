// SPDX-License-Identifier: Apache-2.0
#include "app/studio/studio_main.h"

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QTimer>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "app/batch/program.h"
#include "app/batch/version.h"
#include "app/studio/sample_take.h"
#include "app/studio/speech.h"
#include "app/studio/start_clock.h"
#include "app/studio/tone_player.h"
#include "core/job/heap.h"
#include "devices/machine/clock.h"
#include "ui/main_window/look.h"
#include "ui/main_window/studio_windows.h"
#include "ui/models/end_signals.h"
#include "ui/models/log_file.h"
#include "ui/models/studio.h"
#include "ui/models/studio_log.h"
#include "ui/models/voice.h"
#include "ui/style/theme.h"

namespace noctule::studio {
namespace {

using namespace ui;

constexpr int kNoDisplay = 2;
bool has_display = false;    ///< the application has been made
LogFile* the_log = nullptr;  ///< while the studio runs

[[noreturn]] void endWithoutDisplay() {
    std::fputs(
        "noctule: no display can be reached, and the studio needs one. Start it on a desktop, or run jobs "
        "without a screen: `noctule --batch VERB`; `noctule --help` shows the verbs.\n",
        stderr);
    std::_Exit(kNoDisplay);
}

/// Qt's own way to say that there is no display is to abort with a core dump; until the application has been
/// made, a fatal message is ours. Afterwards Qt's warnings go to standard error only when asked for
/// (NOCTULE_QT_DEBUG=1); categories of our own are silent until a logging rule names them.
void onQtMessage(QtMsgType type, const QMessageLogContext& context, const QString& text) {
    if (type == QtFatalMsg && !has_display)
        endWithoutDisplay();
    if (the_log && type != QtDebugMsg)
        the_log->write(type == QtInfoMsg ? "info" : "warning", text);
    static const bool wanted = qEnvironmentVariableIsSet("NOCTULE_QT_DEBUG");
    const bool ours = context.category && std::strncmp(context.category, "noctule.", 8) == 0;
    if (!wanted && !ours && type != QtFatalMsg)
        return;
    std::fprintf(stderr, "noctule: %s\n", text.toLocal8Bit().constData());
    if (type == QtFatalMsg)
        std::abort();
}

void refuseWithoutDisplay() {
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        if (!qEnvironmentVariableIsEmpty(name))
            return;
    endWithoutDisplay();
}

StudioParts parts() {
    StudioParts parts;
    parts.software = batch::softwareName();
    parts.utc_now = utcNow;
    const QFileInfo virtual_suit(QDir(QCoreApplication::applicationDirPath()), "noctule-virtual-suit");
    if (virtual_suit.isExecutable())
        parts.virtual_suit_program = virtual_suit.absoluteFilePath().toStdString();
    parts.make_sample_take = [software = parts.software](const std::string& path, const JobContext& job) {
        return makeSampleTake(path, utcNow(), software, job);
    };
    parts.make_pair_take = [software = parts.software](const std::string& path, const JobContext& job) {
        return makePairTake(path, utcNow(), software, job);
    };
    parts.make_motion_take = [software = parts.software](const figure::UnderstoodMotion& motion,
                                                         const std::string& scenario, const std::string& path,
                                                         const JobContext& job) {
        return makeMotionTake({motion, scenario, path, utcNow(), software}, job);
    };
    return parts;
}

}  // namespace

int runStudio(int argc, char** argv) {
    shareHeaps();
    refuseWithoutDisplay();
    qInstallMessageHandler(onQtMessage);
    QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
    QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
    QApplication application(argc, argv);
    has_display = true;
    for (const QString& word : application.arguments().mid(1))
        if (word.startsWith("--")) {
            std::fprintf(stderr, "noctule: unknown option %s. `noctule --help` lists what there is.\n",
                         qPrintable(word));
            return 2;
        }
    std::setlocale(LC_NUMERIC, "C");  // Qt takes the user's; files and JSON are the same everywhere
    QApplication::setOrganizationName("Noctule");
    QApplication::setApplicationName("noctule");
    QApplication::setApplicationDisplayName("Noctule");
    QApplication::setApplicationVersion(batch::softwareVersion());
    QApplication::setQuitOnLastWindowClosed(true);
    QGuiApplication::setDesktopFileName("noctule");  // desktops take the window's icon from there
    Theme::install(application);

    LogFile log(stateFolder());
    the_log = &log;
    StudioParts studio_parts = parts();
    studio_parts.log = &log;
    Studio studio(studio_parts);
    const StudioLog follows(studio, log);
    applyLook(studio.settings());
    StudioWindows windows(studio);
    MainWindow& window = windows.show(Step::kStart);
    logFirstFrame(window);
    const std::unique_ptr<Speech> speech = Speech::make();
    if (speech)
        Voice::get().setSpeaker([&speech](const QString& words) { speech->say(words, QLocale()); });
    Tones::get().setPlayer(tonePlayer());
    const EndSignals end_signals;
    QObject::connect(&end_signals, &EndSignals::endWanted, &windows, [&windows] {
        windows.window()->endInGoodOrder();
        if (!windows.window()->isVisible())
            QCoreApplication::quit();  // also where another window would stay
    });
    studio.finder().start();
    studio.remoteStart().begin();
    // Within the event loop, which alone can be left by who closes the window meanwhile, or asks for the end.
    QTimer::singleShot(0, &window, [&window, named = application.arguments().mid(1)] {
        if (!named.isEmpty())
            window.open(QFileInfo(named.first()).absoluteFilePath());
        else
            window.offerTour();
    });
    if (const QString problem = studio.remoteStart().problem(); !problem.isEmpty())
        emit studio.warned(problem, ui::About::kCapture);
    const int code = QApplication::exec();
    Voice::get().setSpeaker({});
    log.write("info", "ended in good order");
    the_log = nullptr;
    return code;
}

}  // namespace noctule::studio
