// SPDX-License-Identifier: Apache-2.0
#include "ui/models/suit_finder.h"

#include <algorithm>
#include <set>

#include "ui/language/core_words.h"

namespace noctule::ui {
namespace {

constexpr const char* kGroup = "suits";

/// Serial numbers are groups of the settings: slashes would make groups of them.
QString keyFor(const QString& serial) {
    return QString("%1/%2").arg(kGroup, QString::fromLatin1(serial.toUtf8().toPercentEncoding()));
}

QString serialOf(const QString& child) {
    return QString::fromUtf8(QByteArray::fromPercentEncoding(child.toLatin1()));
}

QString wordsOfDevice(const std::string& text) {
    return QString::fromStdString(text);
}

}  // namespace

QString KnownSuit::shownName() const {
    const QString serial = wordsOfDevice(device.serial);
    return !serial.isEmpty() && name == QStringLiteral("Suit ") + serial
               ? SuitFinder::tr("Suit %1", "its serial number").arg(serial)
               : name;
}

SuitFinder::SuitFinder(QSettings& settings, QObject* parent) : QObject(parent), settings_(settings) {
    renew();
}

SuitFinder::~SuitFinder() = default;

void SuitFinder::start(const DiscoveryOptions& options) {
    options_ = options;
    found_.clear();
    discovery_ =
        std::make_unique<Discovery>(options, [this, round = ++round_](const std::vector<FoundDevice>& found) {
            QMetaObject::invokeMethod(
                this,
                [this, round, found] {
                    if (round == round_)
                        take(found);
                },
                Qt::QueuedConnection);
        });
    renew();
}

void SuitFinder::lookAgain() {
    start(options_);
    for (const QString& address : std::exchange(probed_, {}))
        probe(address);
}

QString SuitFinder::probe(const QString& address) {
    if (!discovery_)
        start(options_);
    if (const Status asked = discovery_->probe(address.toStdString()); !asked)
        return coreWords(asked.error());
    if (!probed_.contains(address))
        probed_.append(address);
    return {};
}

void SuitFinder::take(const std::vector<FoundDevice>& found) {
    found_ = found;
    renew();
}

int SuitFinder::colourOf(const QString& key) {
    const QVariant known = settings_.value(key + "/colour");
    if (known.isValid())
        return std::clamp(known.toInt(), 0, kSuitColours - 1);
    std::vector<int> uses(kSuitColours, 0);
    settings_.beginGroup(kGroup);
    for (const QString& child : settings_.childGroups()) {
        const int used = settings_.value(child + "/colour", -1).toInt();
        if (used >= 0 && used < kSuitColours)
            ++uses[static_cast<size_t>(used)];
    }
    settings_.endGroup();
    const int colour = static_cast<int>(std::ranges::min_element(uses) - uses.begin());
    settings_.setValue(key + "/colour", colour);
    return colour;
}

KnownSuit SuitFinder::knownOf(const FoundDevice& device) {
    KnownSuit suit;
    suit.device = device;
    const QString serial = wordsOfDevice(device.serial);
    for (const std::string& name : {device.name, device.serial, device.address})
        if (suit.name.isEmpty())
            suit.name = wordsOfDevice(name);
    if (serial.isEmpty())
        return suit;
    const QString key = keyFor(serial);
    suit.colour = colourOf(key);
    suit.name = settings_.value(key + "/name", suit.name).toString();
    suit.is_room = settings_.value(key + "/room").toBool();
    if (settings_.value(key + "/remembered").toBool()) {
        settings_.setValue(key + "/address", wordsOfDevice(device.address));
        settings_.setValue(key + "/model", wordsOfDevice(device.model));
        settings_.setValue(key + "/box_name", wordsOfDevice(device.name));
        settings_.setValue(key + "/boards", device.boards);
        settings_.setValue(key + "/sources", device.sources);
    }
    return suit;
}

void SuitFinder::sortByAppearance(std::vector<KnownSuit>& suits) {
    std::vector<std::pair<size_t, KnownSuit>> placed;
    for (KnownSuit& suit : suits) {
        const FoundDevice& device = suit.device;
        // A port that is asked has an address first and a serial number once its box has answered.
        auto known = device.serial.empty() ? places_.end() : places_.find(device.serial);
        if (known == places_.end())
            known = places_.find(device.address);
        const size_t place = known == places_.end() ? places_.size() : known->second;
        for (const std::string& key : {device.serial, device.address})
            if (!key.empty())
                places_[key] = place;
        placed.emplace_back(place, std::move(suit));
    }
    std::ranges::stable_sort(placed, {}, &std::pair<size_t, KnownSuit>::first);
    for (size_t i = 0; i < placed.size(); ++i)
        suits[i] = std::move(placed[i].second);
}

void SuitFinder::renew() {
    std::vector<KnownSuit> suits;
    std::set<std::string> addresses, serials;
    for (const FoundDevice& device : found_) {
        if (!addresses.insert(device.address).second)
            continue;
        serials.insert(device.serial);
        suits.push_back(knownOf(device));
    }
    settings_.beginGroup(kGroup);
    const QStringList children = settings_.childGroups();
    settings_.endGroup();
    for (const QString& child : children) {
        const QString serial = serialOf(child), key = keyFor(serial);
        if (!settings_.value(key + "/remembered").toBool() || serials.contains(serial.toStdString()))
            continue;
        FoundDevice device;
        device.serial = serial.toStdString();
        device.address = settings_.value(key + "/address").toString().toStdString();
        device.model = settings_.value(key + "/model").toString().toStdString();
        device.name = settings_.value(key + "/box_name").toString().toStdString();
        device.boards = settings_.value(key + "/boards").toInt();
        device.sources = settings_.value(key + "/sources").toInt();
        KnownSuit absent = knownOf(device);
        absent.present = false;
        suits.push_back(std::move(absent));
    }
    sortByAppearance(suits);
    if (suits == suits_)
        return;
    suits_ = std::move(suits);
    emit changed();
}

std::optional<KnownSuit> SuitFinder::connectable() const {
    const auto found = std::ranges::find_if(suits_, [](const KnownSuit& suit) {
        return suit.present && suit.device.contact == FoundDevice::Contact::kAnswers && !suit.device.busy;
    });
    return found == suits_.end() ? std::nullopt : std::optional(*found);
}

const KnownSuit* SuitFinder::at(const QString& address) const {
    const auto found = std::ranges::find_if(suits_, [&](const KnownSuit& suit) {
        return suit.present && suit.device.address == address.toStdString();
    });
    return found == suits_.end() ? nullptr : &*found;
}

void SuitFinder::rename(const QString& serial, const QString& name) {
    const QString key = keyFor(serial) + "/name";
    if (name.trimmed().isEmpty())
        settings_.remove(key);
    else
        settings_.setValue(key, name.trimmed());
    renew();
}

void SuitFinder::remember(const QString& serial, bool is_room) {
    if (serial.isEmpty())
        return;
    settings_.setValue(keyFor(serial) + "/remembered", true);
    settings_.setValue(keyFor(serial) + "/room", is_room);
    renew();
}

void SuitFinder::forget(const QString& serial) {
    settings_.remove(keyFor(serial));
    renew();
}

}  // namespace noctule::ui
