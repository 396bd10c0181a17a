// SPDX-License-Identifier: Apache-2.0
#include "app/studio/tone_player.h"

#include <QDataStream>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryFile>
#include <cmath>
#include <memory>

namespace noctule::studio {
namespace {

constexpr int kListing_ms = 1000, kToneRate_hz = 44100, kTone_hz = 880;
constexpr double kTone_s = 0.15, kToneLevel = 0.4;

/// A WAV file of 16 bits and one channel.
QByteArray toneFile() {
    const int samples = static_cast<int>(kToneRate_hz * kTone_s);
    QByteArray bytes;
    QDataStream out(&bytes, QIODevice::WriteOnly);
    out.setByteOrder(QDataStream::LittleEndian);
    out.writeRawData("RIFF", 4);
    out << quint32(36 + 2 * samples);
    out.writeRawData("WAVEfmt ", 8);
    out << quint32(16) << quint16(1) << quint16(1) << quint32(kToneRate_hz) << quint32(2 * kToneRate_hz)
        << quint16(2) << quint16(16);
    out.writeRawData("data", 4);
    out << quint32(2 * samples);
    for (int i = 0; i < samples; ++i) {
        const double fades = std::sin(M_PI * i / samples);  // without a click at its ends
        out << qint16(32767 * kToneLevel * fades * std::sin(2 * M_PI * kTone_hz * i / kToneRate_hz));
    }
    return bytes;
}

std::vector<ui::SoundDevice> listDevices() {
    QProcess pactl;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("LC_ALL", "C.UTF-8");
    pactl.setProcessEnvironment(environment);
    pactl.start("pactl", {"list", "sinks"});
    if (!pactl.waitForFinished(kListing_ms))
        return {};
    std::vector<ui::SoundDevice> devices;
    for (const QString& line : QString::fromUtf8(pactl.readAllStandardOutput()).split('\n')) {
        const QString words = line.trimmed();
        if (words.startsWith("Name: "))
            devices.push_back({words.mid(6), words.mid(6)});
        else if (words.startsWith("Description: ") && !devices.empty())
            devices.back().name = words.mid(13);
    }
    return devices;
}

void playOn(const QString& file, const QString& id, const std::function<void()>& failed) {
    auto* player = new QProcess;
    QObject::connect(player, &QProcess::errorOccurred, player, [=](QProcess::ProcessError error) {
        if (error != QProcess::FailedToStart)
            return;
        failed();
        player->deleteLater();
    });
    QObject::connect(player, qOverload<int, QProcess::ExitStatus>(&QProcess::finished), player,
                     [=](int code) {
                         if (code != 0)
                             failed();
                         player->deleteLater();
                     });
    player->start("paplay", {"--device=" + id, file});
}

}  // namespace

ui::Tones::Player tonePlayer() {
    if (QStandardPaths::findExecutable("pactl").isEmpty() ||
        QStandardPaths::findExecutable("paplay").isEmpty())
        return {};
    auto file = std::make_shared<QTemporaryFile>();
    const QByteArray tone = toneFile();
    if (!file->open() || file->write(tone) != tone.size() || !file->flush())
        return {};
    return {listDevices, [file](const QString& id, const std::function<void()>& failed) {
                playOn(file->fileName(), id, failed);
            }};
}

}  // namespace noctule::studio
