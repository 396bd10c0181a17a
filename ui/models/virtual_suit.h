// SPDX-License-Identifier: Apache-2.0
// The virtual suit as a driver box on this computer: the program noctule-virtual-suit, which streams a sample
// take in a loop for the studio to connect to like to any box. The take is made once and kept in the cache.
// Two of them, each with a program of its own, can play the two performers of one take. The program ends with
// the studio, also when that crashes.
#pragma once

#include <QObject>
#include <QPointer>
#include <QProcess>
#include <QString>
#include <functional>
#include <memory>

#include "ui/jobs/jobs.h"
#include "ui/models/wearing.h"

namespace noctule::ui {

class VirtualSuit : public QObject {
    Q_OBJECT
public:
    enum class State {
        kOff,
        kPreparing,  ///< the sample take is being made
        kStarting,
        kOn,
    };
    enum class Role {
        kAlone,
        kFirst,  ///< of two that hear each other
        kSecond,
    };
    struct Parts {
        QString program;       ///< its path; empty: there is none
        QString cache_folder;  ///< for the take
        std::string software;  ///< a take of another version is not used again
        using Maker = std::function<Status(const std::string& path, const JobContext&)>;
        Maker make_take;
        Maker make_pair_take{};  ///< worn by "A" and "B"; null: there is only one virtual suit
    };

    VirtualSuit(Jobs& jobs, Parts parts, QObject* parent = nullptr);
    ~VirtualSuit() override;

    bool isAvailable() const { return !parts_.program.isEmpty(); }
    bool canBeTwo() const { return isAvailable() && parts_.make_pair_take; }
    State state() const { return state_; }
    void start(Role role = Role::kAlone);
    /// As started last.
    Role role() const { return role_; }
    /// Returns at once.
    void stop();

    /// Of kOn: "tcp://127.0.0.1:40123".
    const QString& address() const { return address_; }
    /// Where faults can be asked for (app/README.md): "127.0.0.1:40124".
    const QString& controlAddress() const { return control_; }
    /// What the take knows of who wears it.
    const KnownWearing& known() const { return known_; }
    qint64 processId() const;

signals:
    void changed();
    void started();
    /// Boards slipped or were exchanged: what known() says of their places holds no more.
    void wornOtherwise();
    /// It ended by itself, or did not begin.
    void failed(const QString& what, const QString& remedy);

private:
    void setState(State state);
    void launch(const QString& take);
    void hear();
    void noteWornOtherwise();
    void ended();

    Jobs& jobs_;
    const Parts parts_;
    State state_ = State::kOff;
    Role role_ = Role::kAlone;
    QString address_, control_;
    QByteArray heard_, complaints_;
    KnownWearing known_;
    QPointer<Job> preparing_;
    std::unique_ptr<QProcess> program_;
};

}  // namespace noctule::ui
