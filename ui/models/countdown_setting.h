// SPDX-License-Identifier: Apache-2.0
// Seconds from pressing Record to the start of a take. One setting for the whole program; Record and
// Preferences both show it.
#pragma once

#include <QObject>

namespace noctule::ui {

class CountdownSetting : public QObject {
    Q_OBJECT
public:
    static constexpr int kChoices_s[] = {0, 3, 5, 10};  ///< 0: none

    static CountdownSetting& get();

    /// Kept in the settings; 3 by default.
    int seconds() const;
    void setSeconds(int seconds);

signals:
    void changed();

private:
    CountdownSetting() = default;
};

}  // namespace noctule::ui
