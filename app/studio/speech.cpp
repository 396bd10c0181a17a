// SPDX-License-Identifier: Apache-2.0
#include "app/studio/speech.h"

#include <QTextToSpeech>

namespace noctule::studio {

std::unique_ptr<Speech> Speech::make() {
    if (QTextToSpeech::availableEngines().isEmpty())
        return nullptr;
    return std::unique_ptr<Speech>(new Speech);
}

Speech::Speech() : thread_(new QThread), inside_(new QObject) {
    inside_->moveToThread(thread_);
    QObject::connect(thread_, &QThread::finished, inside_, &QObject::deleteLater);
    thread_->setObjectName("speech");
    thread_->start();
}

Speech::~Speech() {
    thread_->quit();
    if (thread_->wait(1000))
        delete thread_;  // else it is left to the end of the process: its service hangs
}

void Speech::say(const QString& words, const QLocale& language) {
    const int turn = ++newest_;
    QMetaObject::invokeMethod(inside_, [this, words, language, turn] {
        if (!engine_)
            engine_ = new QTextToSpeech(inside_);
        if (turn != newest_)
            return;
        engine_->stop();
        engine_->setLocale(language);
        engine_->say(words);
    });
}

}  // namespace noctule::studio
