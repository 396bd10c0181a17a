// SPDX-License-Identifier: Apache-2.0
// The desktop's own speech (speech-dispatcher or another engine that Qt knows) as the speaker of spoken cues.
#pragma once

#include <QLocale>
#include <QThread>
#include <atomic>
#include <memory>

class QTextToSpeech;

namespace noctule::studio {

/// Speaks from a thread of its own: a speech service that hangs must not hold the screen.
class Speech {
public:
    /// Null where no engine is installed.
    static std::unique_ptr<Speech> make();
    /// Waits for a second at most.
    ~Speech();

    /// In the language of the screens. Never waits; cuts off what is being said.
    void say(const QString& words, const QLocale& language);

private:
    Speech();

    QThread* thread_;
    QObject* inside_;          ///< lives in the thread
    QTextToSpeech* engine_{};  ///< made in the thread by the first words; belongs to `inside_`
    std::atomic<int> newest_{0};
};

}  // namespace noctule::studio
