// SPDX-License-Identifier: Apache-2.0
// Adds to a take that exists: derived runs, a newer calibration or actor, a reference. All of it is one
// transaction: unless commit() succeeds, also after a crash, the file stays as it was. The Take must have
// been opened kReadWrite, must stay where it is, and may be read meanwhile.
#pragma once

#include <string>

#include "core/recording/take.h"
#include "core/recording/take_tables.h"

namespace noctule {

class TakeEdit : public TakeTables {
public:
    static Result<TakeEdit> begin(Take& take);

    /// A new run; `run.run` is ignored, the number comes back. `settings_json` empty: "{}".
    Result<int64_t> beginRun(const DerivedRun& run);
    /// Removes a run and its rows; kUsage for primary rows (run 0).
    Status dropRun(int64_t run);
    /// One such marker; kUsage when there is none.
    Status removeMarker(const MarkerRow& row, int suit = kSuitInView);
    /// What the operator says of the feet; nothing: what each run has found holds again.
    Status setContacts(const std::optional<std::vector<FootContacts>>& contacts, int suit = kSuitInView);
    /// Nothing happens when there is no such entry.
    Status removeMeta(const std::string& key);
    Status removeReference(int suit = kSuitInView);
    Status removeExternalRoot(int suit = kSuitInView);

    /// Writes it; the Take then shows it. On an error nothing was changed.
    Status commit();

private:
    TakeEdit(Take& take, Transaction transaction);
    Status removeRows(const std::string& table, const std::string& where);
    Result<int64_t> highestRun(const std::string& table);
    Result<int64_t> highestDropped();
    Status noteDropped(int64_t run);

    Take* take_;
    Transaction transaction_;
};

}  // namespace noctule
