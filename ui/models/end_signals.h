// SPDX-License-Identifier: Apache-2.0
// Log-out, shutdown, Ctrl-C and a polite kill reach the studio as a Qt signal, so that it ends as if its
// window were closed. The handler itself only writes a byte into a pipe.
#pragma once

#include <QObject>
#include <memory>

class QSocketNotifier;

namespace noctule::ui {

class EndSignals : public QObject {
    Q_OBJECT
public:
    /// Once in a process. SIGTERM, SIGINT and SIGHUP; a second one ends the program at once.
    explicit EndSignals(QObject* parent = nullptr);
    ~EndSignals() override;

signals:
    void endWanted();

private:
    std::unique_ptr<QSocketNotifier> notifier_;
};

}  // namespace noctule::ui
