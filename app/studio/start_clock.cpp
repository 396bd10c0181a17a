// SPDX-License-Identifier: Apache-2.0
#include "app/studio/start_clock.h"

#include <unistd.h>

#include <QEvent>
#include <QFile>
#include <QLoggingCategory>
#include <QTimer>
#include <QWindow>
#include <ctime>

namespace noctule::studio {
namespace {

Q_LOGGING_CATEGORY(startup, "noctule.startup", QtWarningMsg)

/// Painting is part of handling the exposure; a timer that was set before fires afterwards.
class FirstExposure : public QObject {
public:
    explicit FirstExposure(QWindow& window) : QObject(&window) { window.installEventFilter(this); }

    bool eventFilter(QObject* object, QEvent* event) override {
        auto& window = static_cast<QWindow&>(*object);
        if (event->type() == QEvent::Expose && window.isExposed()) {
            window.removeEventFilter(this);
            QTimer::singleShot(0, this, [this] {
                qCInfo(startup, "first frame %.0f ms after the start of the process", msSinceProcessStart());
                deleteLater();
            });
        }
        return false;
    }
};

}  // namespace

double msSinceProcessStart() {
    constexpr int kStartTime =
        19;  // proc(5): field 22, the third being the first behind the name in brackets
    QFile file(QStringLiteral("/proc/self/stat"));
    if (!file.open(QIODevice::ReadOnly))
        return -1;
    const QByteArray text = file.readAll();
    const QList<QByteArray> fields = text.mid(text.lastIndexOf(')') + 2).split(' ');
    timespec now{};
    if (fields.size() <= kStartTime || clock_gettime(CLOCK_BOOTTIME, &now) != 0)
        return -1;
    const double start_s = fields[kStartTime].toDouble() / static_cast<double>(sysconf(_SC_CLK_TCK));
    return (static_cast<double>(now.tv_sec) - start_s) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

void logFirstFrame(QWidget& window) {
    if (startup().isInfoEnabled() && window.windowHandle())
        new FirstExposure(*window.windowHandle());
}

}  // namespace noctule::studio
