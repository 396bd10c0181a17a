// SPDX-License-Identifier: Apache-2.0
// The messages of a file of translations (.ts), in the order of the file.
#pragma once

#include <gtest/gtest.h>

#include <QFile>
#include <QStringList>
#include <QXmlStreamReader>
#include <vector>

namespace noctule::ui {

struct Message {
    QString context, source, comment;
    QStringList forms;  ///< one, or two of a plural
    bool plural = false, finished = true;

    QString key() const { return context + '|' + source + '|' + comment; }
};

inline QString translationPath(const QString& name) {
    return QString(NOCTULE_SOURCE_DIR) + "/resources/translations/" + name;
}

inline Message readMessage(QXmlStreamReader& xml, const QString& context) {
    Message message;
    message.context = context;
    message.plural = xml.attributes().value("numerus") == "yes";
    while (xml.readNextStartElement()) {
        if (xml.name() == "source") {
            message.source = xml.readElementText();
        } else if (xml.name() == "comment") {
            message.comment = xml.readElementText();
        } else if (xml.name() == "translation") {
            message.finished = !xml.attributes().hasAttribute("type");
            if (!message.plural)
                message.forms.append(xml.readElementText());
            else
                while (xml.readNextStartElement())
                    message.forms.append(xml.readElementText());
        } else {
            xml.skipCurrentElement();
        }
    }
    return message;
}

inline std::vector<Message> readTs(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    QXmlStreamReader xml(&file);
    std::vector<Message> messages;
    QString context;
    while (!xml.atEnd()) {
        xml.readNext();
        if (!xml.isStartElement())
            continue;
        if (xml.name() == "name")
            context = xml.readElementText();
        else if (xml.name() == "message")
            messages.push_back(readMessage(xml, context));
    }
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    return messages;
}

}  // namespace noctule::ui
