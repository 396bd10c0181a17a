// SPDX-License-Identifier: Apache-2.0
// "Devices": driver boxes as they are found, the virtual suit, and the way to another address or port.
#pragma once

#include <QLineEdit>
#include <QWidget>

#include "ui/models/capture_context.h"

class QVBoxLayout;

namespace noctule::ui {

class Button;
class DeviceCard;
class Label;
struct DeviceWords;

class DevicesPanel : public QWidget {
    Q_OBJECT
public:
    explicit DevicesPanel(CaptureContext& capture, QWidget* parent = nullptr);

    /// In the order of the finder; the virtual suit comes after them.
    const std::vector<DeviceCard*>& cards() const { return cards_; }
    DeviceCard& virtualCard() { return *virtual_card_; }
    DeviceCard& secondVirtualCard() { return *second_virtual_card_; }
    QLineEdit& addressField() { return *address_; }
    QString addressProblem() const;

private:
    void showDevices();
    void showVirtualSuit();
    void act(const KnownSuit& suit);
    void actOnVirtualSuit();
    void actOnSecondVirtualSuit();
    DeviceWords wordsForVirtual(VirtualSuit& suit) const;
    void addAddressForm(QVBoxLayout& column);
    void askAddress();
    DeviceWords wordsFor(const KnownSuit& suit) const;
    /// Null: it is not connected.
    SuitInUse* wornOf(const KnownSuit& suit) const;
    void nameWearer(const SuitInUse& worn, DeviceWords& words) const;

    CaptureContext& capture_;
    QWidget* list_;
    QVBoxLayout* list_column_;
    std::vector<DeviceCard*> cards_;
    DeviceCard *virtual_card_, *second_virtual_card_;
    Label* nothing_;
    Button* other_;
    QWidget* form_;
    QLineEdit* address_;
    Label* problem_;
};

}  // namespace noctule::ui
