// SPDX-License-Identifier: Apache-2.0
#include "ui/views/connect/devices_panel.h"

#include <QVBoxLayout>

#include "ui/style/performer_disc.h"
#include "ui/views/connect/device_card.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/label.h"

namespace noctule::ui {
namespace {

QString qt(const std::string& text) {
    return QString::fromStdString(text);
}

bool isSerialPort(const FoundDevice& device) {
    return device.address.starts_with("serial:");
}

/// Of the suit that is connected.
void tellLink(const LiveSuit& live, DeviceWords& words) {
    const bool lost = live.status()->link == LinkState::kLost;
    words.state = lost ? DevicesPanel::tr("link broken") : DevicesPanel::tr("connected");
    words.tone = lost ? Tone::kWarn : Tone::kOk;
}

}  // namespace

DevicesPanel::DevicesPanel(CaptureContext& capture, QWidget* parent)
    : QWidget(parent),
      capture_(capture),
      list_(new QWidget),
      list_column_(makeColumn(list_, {}, 8)),
      virtual_card_(new DeviceCard),
      second_virtual_card_(new DeviceCard),
      nothing_((new Label(tr("No driver box is found. Switch one on, or connect it by USB."),
                          TextRole::kSecondary, Ink::kHint))
                   ->wrapped()),
      other_(makeButton(ButtonKind::kText, tr("Other address or port"), "new")),
      form_(new QWidget) {
    auto* column = makeColumn(this, {12, 8, 12, 12}, 8);
    column->addWidget(nothing_);
    column->addWidget(list_);
    column->addWidget(virtual_card_);
    column->addWidget(second_virtual_card_);
    addRow(column)->addWidget(other_, 0, Qt::AlignLeft);
    addAddressForm(*column);
    connect(virtual_card_, &DeviceCard::activated, this, &DevicesPanel::actOnVirtualSuit);
    connect(second_virtual_card_, &DeviceCard::activated, this, &DevicesPanel::actOnSecondVirtualSuit);
    connect(&capture_.finder(), &SuitFinder::changed, this, &DevicesPanel::showDevices);
    connect(&capture_.suits(), &LiveSuits::changed, this, &DevicesPanel::showDevices);
    connect(&capture_.virtualSuit(), &VirtualSuit::changed, this, &DevicesPanel::showVirtualSuit);
    connect(&capture_.secondVirtualSuit(), &VirtualSuit::changed, this, &DevicesPanel::showVirtualSuit);
    connect(&capture_.suits(), &LiveSuits::changed, this, &DevicesPanel::showVirtualSuit);
    showDevices();
    showVirtualSuit();
}

void DevicesPanel::addAddressForm(QVBoxLayout& column) {
    auto* rows = makeColumn(form_, {}, 4);
    address_ = new QLineEdit;
    address_->setPlaceholderText(QStringLiteral("tcp://10.0.0.7:41941"));
    address_->setAccessibleName(tr("Address or port of a driver box"));
    auto* row = addRow(rows, 8);
    row->addWidget(address_, 1);
    auto* ask = makeButton(ButtonKind::kOutlined, tr("Ask"));
    row->addWidget(ask);
    problem_ = (new Label({}, TextRole::kSecondary, Ink::kError))->wrapped();
    problem_->hide();
    rows->addWidget(problem_);
    rows->addWidget(
        (new Label(tr("In the network tcp://ADDRESS:PORT, at a serial port serial:///dev/ttyACM0."),
                   TextRole::kSecondary, Ink::kHint))
            ->wrapped());
    form_->hide();
    column.addWidget(form_);
    connect(other_, &QPushButton::clicked, this, [this] {
        form_->setVisible(form_->isHidden());
        problem_->hide();
        if (form_->isVisible())
            address_->setFocus(Qt::OtherFocusReason);
    });
    connect(ask, &QPushButton::clicked, this, &DevicesPanel::askAddress);
    connect(address_, &QLineEdit::returnPressed, this, &DevicesPanel::askAddress);
    connect(address_, &QLineEdit::textEdited, problem_, &QWidget::hide);
}

/// What is asked for appears in the list, and says there whether it answers.
void DevicesPanel::askAddress() {
    const QString why = capture_.finder().probe(address_->text().trimmed());
    problem_->setText(why);
    problem_->setVisible(!why.isEmpty());
    if (why.isEmpty())
        form_->hide();
}

QString DevicesPanel::addressProblem() const {
    return problem_->isHidden() ? QString() : problem_->text();
}

/// Null for a box that is gone and to whose address another one has come.
SuitInUse* DevicesPanel::wornOf(const KnownSuit& suit) const {
    SuitInUse* worn = capture_.suits().at(qt(suit.device.address));
    const QString wanted = qt(suit.device.serial), there = worn ? worn->suit.serial() : QString();
    return !wanted.isEmpty() && !there.isEmpty() && wanted != there ? nullptr : worn;
}

/// Of several suits: whose it is.
void DevicesPanel::nameWearer(const SuitInUse& worn, DeviceWords& words) const {
    if (worn.suit.suit().isFixed())
        words.detail = tr("%1, anchors of the room", "a device").arg(words.detail);
    else if (capture_.suits().areSeveral())
        words.detail = tr("%1, worn by %2 %3", "a device, letter and name of a performer")
                           .arg(words.detail, performerLetter(capture_.suits().letterOf(worn)),
                                capture_.suits().nameOf(worn));
}

void DevicesPanel::showDevices() {
    const auto& suits = capture_.finder().suits();
    while (cards_.size() > suits.size()) {
        delete cards_.back();
        cards_.pop_back();
    }
    while (cards_.size() < suits.size()) {
        auto* card = new DeviceCard;
        const size_t index = cards_.size();
        connect(card, &DeviceCard::activated, this, [this, index] {
            // A copy: what it does changes the list.
            const KnownSuit suit = capture_.finder().suits().at(index);
            act(suit);
        });
        connect(card, &DeviceCard::named, &capture_.finder(), &SuitFinder::rename);
        // Later: the card itself may go with it.
        connect(card, &DeviceCard::forgotten, &capture_.finder(), &SuitFinder::forget, Qt::QueuedConnection);
        cards_.push_back(card);
        list_column_->addWidget(card);
    }
    for (size_t i = 0; i < suits.size(); ++i)
        cards_[i]->setWords(wordsFor(suits[i]));
    list_->setVisible(!suits.empty());
    nothing_->setVisible(suits.empty());
}

DeviceWords DevicesPanel::wordsFor(const KnownSuit& suit) const {
    const FoundDevice& device = suit.device;
    DeviceWords words;
    words.icon = isSerialPort(device) ? "usb" : "net";
    words.colour = suit.colour;
    words.name = suit.shownName();
    words.serial = qt(device.serial);
    const QString where = isSerialPort(device) ? tr("Driver box on USB") : tr("Driver box on the network");
    const QString holds = device.boards > 0 ? tr("%1, %2", "where a device is; what it has")
                                                  .arg(where, tr("%n board(s)", nullptr, device.boards))
                                            : where;
    words.detail = holds;
    if (const SuitInUse* worn = wornOf(suit)) {
        const LiveSuit::Phase phase = worn->suit.phase();
        words.chosen = worn == &capture_.suits().current();
        nameWearer(*worn, words);
        words.action = tr("Disconnect");
        if (phase == LiveSuit::Phase::kRefused) {
            words.tone = Tone::kError;
            words.detail = tr("does not answer");
            words.action = tr("Try again");
        } else if (phase == LiveSuit::Phase::kConnecting) {
            words.detail = tr("is being connected");
        } else {
            tellLink(worn->suit, words);
        }
    } else if (!suit.present) {
        words.state = tr("not here");
        words.can_be_forgotten = true;
    } else if (device.contact == FoundDevice::Contact::kAsking) {
        words.state = tr("asking");
    } else if (device.contact == FoundDevice::Contact::kSilent) {
        words.state = tr("silent");
        words.tone = Tone::kWarn;
        words.detail = tr("%1: no driver box answers", "an address").arg(qt(device.address));
        words.action = tr("Ask again");
    } else if (device.contact == FoundDevice::Contact::kNotAsked) {
        words.detail = tr("A serial port; a driver box may be connected there");
        words.action = tr("Ask");
    } else if (device.busy) {
        words.state = tr("busy");
        words.tone = Tone::kWarn;
        words.detail = tr("Another studio uses it");
    } else if (const SuitInUse* lost = capture_.suits().lost(words.serial)) {
        words.chosen = lost == &capture_.suits().current();
        tellLink(lost->suit, words);
        words.detail = tr("Answers at another address now");
        words.action = tr("Connect again");
    } else {
        words.action = capture_.suits().connected().empty() ? tr("Connect")
                       : suit.is_room                       ? tr("Add these anchors")
                                                            : tr("Add this suit");
    }
    return words;
}

void DevicesPanel::act(const KnownSuit& suit) {
    problem_->hide();  // another box was chosen
    const QString address = qt(suit.device.address);
    if (SuitInUse* worn = wornOf(suit); worn && worn->suit.phase() == LiveSuit::Phase::kRefused)
        worn->suit.connectTo(address);
    else if (worn)
        worn->suit.disconnectSuit();
    else if (suit.device.contact != FoundDevice::Contact::kAnswers)
        capture_.finder().probe(address);
    else if (SuitInUse* lost = capture_.suits().lost(qt(suit.device.serial)))
        lost->suit.connectTo(address);
    else
        capture_.suits().add(address);
}

void DevicesPanel::showVirtualSuit() {
    VirtualSuit &first = capture_.virtualSuit(), &second = capture_.secondVirtualSuit();
    DeviceWords words = wordsForVirtual(first);
    words.name = tr("Virtual suit");
    virtual_card_->setWords(words);
    virtual_card_->setVisible(first.isAvailable());
    words = wordsForVirtual(second);
    words.name = tr("Second virtual suit");
    if (second.state() == VirtualSuit::State::kOff)
        words.action = tr("Add");
    second_virtual_card_->setWords(words);
    const bool can_be_added = capture_.suits().at(first.address()) && !capture_.suits().isFull();
    second_virtual_card_->setVisible(first.canBeTwo() &&
                                     (can_be_added || second.state() != VirtualSuit::State::kOff));
}

DeviceWords DevicesPanel::wordsForVirtual(VirtualSuit& suit) const {
    const SuitInUse* worn =
        suit.state() == VirtualSuit::State::kOn ? capture_.suits().at(suit.address()) : nullptr;
    DeviceWords words;
    words.icon = "play";
    words.detail = tr("A simulated performer, no hardware");
    switch (suit.state()) {
        case VirtualSuit::State::kOff:
            words.action = tr("Start");
            break;
        case VirtualSuit::State::kPreparing:
            words.detail = tr("Its motion is being prepared, once");
            words.action = tr("Stop");
            break;
        case VirtualSuit::State::kStarting:
            words.state = tr("starting");
            break;
        case VirtualSuit::State::kOn:
            if (worn) {
                tellLink(worn->suit, words);
                nameWearer(*worn, words);
            }
            words.action = worn ? tr("Stop") : tr("Connect");
            words.chosen = worn == &capture_.suits().current();
    }
    return words;
}

void DevicesPanel::actOnVirtualSuit() {
    const VirtualSuit& suit = capture_.virtualSuit();
    const bool elsewhere = suit.state() == VirtualSuit::State::kOn && !capture_.suits().at(suit.address());
    if (suit.state() == VirtualSuit::State::kOff || elsewhere)
        capture_.startVirtualSuit();
    else
        capture_.stopVirtualSuit();
}

void DevicesPanel::actOnSecondVirtualSuit() {
    const VirtualSuit& suit = capture_.secondVirtualSuit();
    const bool elsewhere = suit.state() == VirtualSuit::State::kOn && !capture_.suits().at(suit.address());
    if (suit.state() == VirtualSuit::State::kOff || elsewhere)
        capture_.startSecondVirtualSuit();
    else
        capture_.stopSecondVirtualSuit();
}

}  // namespace noctule::ui
