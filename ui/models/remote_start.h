// SPDX-License-Identifier: Apache-2.0
// Other programs on the network begin and end recordings, when the operator allows it: which port is listened
// to is remembered.
#pragma once

#include <QObject>
#include <QSettings>
#include <memory>

#include "devices/remote/remote_trigger.h"

namespace noctule::ui {

class RemoteStart : public QObject {
    Q_OBJECT
public:
    static constexpr int kUsualPort = 6030;  ///< below 1024 a program needs rights

    explicit RemoteStart(QSettings& settings, QObject* parent = nullptr);

    /// Listens where the settings say, if they do.
    void begin();
    bool isAllowed() const;
    void setAllowed(bool allowed);
    int port() const;
    void setPort(int port);
    /// Why nothing is heard although it should be; empty: nothing stands in the way.
    const QString& problem() const { return problem_; }
    bool isListening() const { return trigger_ != nullptr; }

signals:
    void changed();
    /// `name` and `notes` as the other program has them, possibly empty.
    void startWanted(const QString& name, const QString& notes);
    void stopWanted();

private:
    void hear(const CaptureMessage& message);

    QSettings& settings_;
    std::unique_ptr<RemoteTrigger> trigger_;
    QString problem_;
};

}  // namespace noctule::ui
