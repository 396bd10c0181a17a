// SPDX-License-Identifier: Apache-2.0
// The tone of countdowns, takes and wizards: the desktop's bell, or one played on a sound device that the
// operator chose. One for the whole program.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <vector>

namespace noctule::ui {

struct SoundDevice {
    QString id, name;
};

class Tones : public QObject {
    Q_OBJECT
public:
    /// How the computer lists its devices and plays on one. `play` calls `failed` when it cannot, also later.
    struct Player {
        std::function<std::vector<SoundDevice>()> devices;
        std::function<void(const QString& id, std::function<void()> failed)> play;
    };

    static Tones& get();

    /// Without one there is only the desktop's bell.
    void setPlayer(Player player) { player_ = std::move(player); }
    std::vector<SoundDevice> devices() const;
    /// Kept in the settings. An empty id: as the desktop, the default.
    SoundDevice device() const;
    void setDevice(const SoundDevice& device);
    void play();

signals:
    /// The desktop's bell stands in for the chosen device. Once, until the device is chosen anew.
    void fellBack(const QString& device_name);

private:
    Tones() = default;
    void fallBack();

    Player player_;
    bool has_told_ = false;
};

}  // namespace noctule::ui
