// SPDX-License-Identifier: Apache-2.0
// noctule-virtual-suit on a rig of calibration, as a program of its own, and its control port.
#pragma once

#include <QProcess>
#include <QTcpSocket>

#include "tests/ui/support/wait.h"

namespace noctule::ui::test {

class RigProgram {
public:
    explicit RigProgram(const QStringList& options) {
        QStringList all{"--tcp", "127.0.0.1:0", "--control", "127.0.0.1:0"};
        program_.setReadChannel(QProcess::StandardOutput);
        program_.start(NOCTULE_PROGRAM "-virtual-suit", all + options);
        waitFor([this] {
            heard_ += program_.readAllStandardOutput();
            return heard_.contains("control: ") && heard_.endsWith('\n');
        });
        for (const QByteArray& line : heard_.split('\n')) {
            if (line.startsWith("studio: "))
                address_ = line.mid(8);
            if (line.startsWith("control: "))
                control_ = line.mid(9);
        }
    }
    ~RigProgram() {
        program_.terminate();
        program_.waitForFinished(5000);
    }

    /// Gone without a word, as a box whose battery is empty.
    void kill() {
        program_.kill();
        program_.waitForFinished(5000);
    }
    bool isThere() const { return !control_.isEmpty(); }
    const QString& address() const { return address_; }
    /// What it answers.
    QByteArray tell(const QByteArray& command) const {
        QTcpSocket socket;
        socket.connectToHost(control_.section(':', 0, 0), control_.section(':', 1).toUShort());
        if (!socket.waitForConnected())
            return "not there";
        socket.write(command + '\n');
        QByteArray answer;
        waitFor([&] {
            answer += socket.readAll();
            return answer.endsWith('\n');
        });
        return answer.trimmed();
    }

private:
    QProcess program_;
    QByteArray heard_;
    QString address_, control_;
};

}  // namespace noctule::ui::test
