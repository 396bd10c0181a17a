// SPDX-License-Identifier: Apache-2.0
#include "devices/remote/capture_message.h"

#include <QXmlStreamReader>

namespace noctule {
namespace {

/// Where an element's VALUE goes; null: nowhere.
std::string* placeFor(const QStringRef& element, CaptureMessage& message) {
    if (element == QLatin1String("Name"))
        return &message.name;
    if (element == QLatin1String("Notes"))
        return &message.notes;
    if (element == QLatin1String("Description"))
        return &message.description;
    if (element == QLatin1String("PacketID"))
        return &message.packet_id;
    return nullptr;
}

std::optional<CaptureMessage::Kind> kindOf(const QStringRef& element) {
    if (element == QLatin1String("CaptureStart"))
        return CaptureMessage::Kind::kStart;
    if (element == QLatin1String("CaptureStop"))
        return CaptureMessage::Kind::kStop;
    return std::nullopt;
}

/// Up to the end of the document: a message that breaks off is none.
void readElements(QXmlStreamReader& xml, CaptureMessage& message) {
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (std::string* place = placeFor(xml.name(), message))
            *place = xml.attributes().value("VALUE").trimmed().toString().toStdString();
    }
}

}  // namespace

std::optional<CaptureMessage> readCaptureMessage(const QByteArray& datagram) {
    if (datagram.size() > kMostMessageBytes)
        return std::nullopt;
    const int end = datagram.indexOf('\0');
    QXmlStreamReader xml(end < 0 ? datagram : datagram.left(end));
    while (!xml.atEnd() && !xml.isStartElement())
        if (xml.readNext() == QXmlStreamReader::DTD)  // entities could be made there
            return std::nullopt;
    const auto kind = xml.isStartElement() ? kindOf(xml.name()) : std::nullopt;
    if (!kind)
        return std::nullopt;
    CaptureMessage message;
    message.kind = *kind;
    readElements(xml, message);
    return xml.hasError() ? std::nullopt : std::optional(message);
}

}  // namespace noctule
