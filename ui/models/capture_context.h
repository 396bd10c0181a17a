// SPDX-License-Identifier: Apache-2.0
// The suits that are connected, with their calibrations and checks; how suits are found; the virtual suits.
#pragma once

#include <QCoreApplication>

#include "ui/models/live_suits.h"
#include "ui/models/place_reset.h"
#include "ui/models/remote_start.h"
#include "ui/models/shared_context.h"
#include "ui/models/suit_finder.h"
#include "ui/models/virtual_suit.h"

namespace noctule::ui {

class CaptureContext {
    Q_DECLARE_TR_FUNCTIONS(noctule::ui::CaptureContext)
public:
    /// `shared` outlives it.
    explicit CaptureContext(SharedContext& shared);

    SharedContext& shared() { return shared_; }
    SuitFinder& finder() { return finder_; }
    LiveSuits& suits() { return suits_; }
    /// The one that is looked at, and what belongs to it.
    LiveSuit& suit() { return suits_.current().suit; }
    CalibrationShelf& calibrations() { return suits_.current().calibrations; }
    SuitCheck& check() { return suits_.current().check; }
    /// The last check of the suit that is looked at; empty: none was made.
    const std::optional<CheckedSuit>& checked() const { return suits_.current().checked; }
    void setChecked(const std::optional<CheckedSuit>& checked);
    RemoteStart& remoteStart() { return remote_start_; }
    PlaceReset& placeReset() { return place_reset_; }
    /// Where calibrations of suits are kept beyond sessions.
    QString suitsFolder() const;

    VirtualSuit& virtualSuit() { return virtual_suit_; }
    VirtualSuit& secondVirtualSuit() { return second_virtual_suit_; }
    /// Starts the virtual suit's program and connects it.
    void startVirtualSuit();
    /// Two of them beside each other, that hear each other: the first begins anew.
    void startSecondVirtualSuit();
    /// A take of it that is being recorded ends intact first. With the first goes the second.
    void stopVirtualSuit();
    void stopSecondVirtualSuit();

private:
    void connectSuits();
    void connectVirtualSuits();
    void followSuit(SuitInUse& worn);
    void settleCapture(const SuitInUse& worn);
    void settleCalibration(const SuitInUse& worn);
    void followVirtualSuits();

    SharedContext& shared_;
    SuitFinder finder_;
    LiveSuits suits_;
    VirtualSuit virtual_suit_, second_virtual_suit_;
    RemoteStart remote_start_;
    PlaceReset place_reset_;
    bool virtual_suit_ends_ = false, second_virtual_suit_ends_ = false, second_virtual_suit_waits_ = false;
    QObject here_;  ///< receives what is told; gone before all others
};

}  // namespace noctule::ui
