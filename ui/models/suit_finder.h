// SPDX-License-Identifier: Apache-2.0
// The devices around: driver boxes in the network and on serial ports, as discovery sees them, and what the
// operator knows of them. On the interface's thread.
#pragma once

#include <QObject>
#include <QSettings>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "devices/discovery/discovery.h"

namespace noctule::ui {

/// A device with what is remembered of it by its serial number.
struct KnownSuit {
    FoundDevice device;
    QString name;          ///< the operator's own, else the box's, else its serial number or address
    int colour = -1;       ///< which of kSuitColours, the same at every meeting; -1: nobody has answered yet
    bool present = true;   ///< false: remembered, not here now
    bool is_room = false;  ///< anchors that nobody wears, as it was when it was connected last

    /// The name in the language of the studio, where it is the one that boxes give themselves.
    QString shownName() const;

    bool operator==(const KnownSuit&) const = default;
};

class SuitFinder : public QObject {
    Q_OBJECT
public:
    static constexpr int kSuitColours = 6;

    /// Looks from start() on.
    explicit SuitFinder(QSettings& settings, QObject* parent = nullptr);
    ~SuitFinder() override;
    void start(const DiscoveryOptions& options = {});
    bool isLooking() const { return discovery_ != nullptr; }

    /// In order of appearance, so that none moves because another one goes or comes back.
    const std::vector<KnownSuit>& suits() const { return suits_; }
    /// A box that answers and that no other studio uses, the first of them.
    std::optional<KnownSuit> connectable() const;
    /// Null when none has this address now.
    const KnownSuit* at(const QString& address) const;
    /// Asks at an address or a serial port who is there; the list tells. In words what is wrong with it, else
    /// empty.
    QString probe(const QString& address);
    /// From nothing: what is gone is gone at once, what was probed is asked again.
    void lookAgain();
    void rename(const QString& serial, const QString& name);
    /// Shows it also when it is not here.
    void remember(const QString& serial, bool is_room = false);
    void forget(const QString& serial);

signals:
    void changed();

private:
    void take(const std::vector<FoundDevice>& found);
    void renew();
    void sortByAppearance(std::vector<KnownSuit>& suits);
    KnownSuit knownOf(const FoundDevice& device);
    int colourOf(const QString& key);

    QSettings& settings_;
    DiscoveryOptions options_;
    std::vector<FoundDevice> found_;
    std::vector<KnownSuit> suits_;
    std::map<std::string, size_t> places_;  ///< in the list, by serial number and by address
    QStringList probed_;
    int round_ = 0;                         ///< what an earlier discovery still tells is void
    std::unique_ptr<Discovery> discovery_;  ///< last: it goes first
};

}  // namespace noctule::ui
