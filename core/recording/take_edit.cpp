// SPDX-License-Identifier: Apache-2.0
#include "core/recording/take_edit.h"

#include <algorithm>

namespace noctule {

namespace {

// What does not fit into the cache goes to the file before the commit, and from then on nobody can read the
// take. 512 MiB hold the results of about a quarter of an hour, so that a take can be looked at while it is
// processed. Used only as far as needed.
constexpr const char* kLargeCache = "PRAGMA cache_size=-524288";

constexpr const char* kTablesWithRuns[] = {"derived",     "inertial", "range",   "pose",
                                           "orientation", "clock",    "contact", "relative"};

}  // namespace

TakeEdit::TakeEdit(Take& take, Transaction transaction)
    : TakeTables(take.database_.get(), *take.schema_), take_(&take), transaction_(std::move(transaction)) {}

Result<TakeEdit> TakeEdit::begin(Take& take) {
    if (const Status enlarged = take.database_->execute(kLargeCache); !enlarged)
        return enlarged.error();
    Result<Transaction> transaction = Transaction::begin(*take.database_);
    if (!transaction)
        return transaction.error();
    // Another program may have written since the take was opened.
    if (const Status current = take.load(); !current)
        return current.error();
    take.view(take.viewed());
    TakeEdit edit(take, std::move(*transaction));
    edit.view(take.viewed());
    return edit;
}

Result<int64_t> TakeEdit::highestRun(const std::string& table) {
    if (!schema().has(table, "run"))
        return int64_t{0};
    const auto highest = database().queryInteger("SELECT max(run) FROM " + table +
                                                 " WHERE run<=" + std::to_string(kHighestRun));
    if (!highest)
        return highest.error();
    return highest->value_or(0);
}

/// 0: none was.
Result<int64_t> TakeEdit::highestDropped() {
    if (!schema().has("meta"))
        return int64_t{0};
    const std::string prefix = kDroppedResultKey;
    const std::string number = "CAST(substr(key," + std::to_string(prefix.size() + 1) + ") AS INTEGER)";
    const auto highest =
        database().queryInteger("SELECT max(" + number + ") FROM meta WHERE key GLOB '" + prefix +
                                "[0-9]*' AND " + number + "<=" + std::to_string(kHighestRun));
    if (!highest)
        return highest.error();
    return highest->value_or(0);
}

/// Of results only: nobody counts the others.
Status TakeEdit::noteDropped(int64_t run) {
    if (!schema().has("derived"))
        return Done{};
    const auto results = database().queryInteger("SELECT count(*) FROM derived WHERE kind='pose' AND run=" +
                                                 std::to_string(run));
    if (!results)
        return results.error();
    return results->value_or(0) > 0 ? setMeta(kDroppedResultKey + std::to_string(run), "") : Done{};
}

Result<int64_t> TakeEdit::beginRun(const DerivedRun& run) {
    const auto dropped = highestDropped();
    if (!dropped)
        return dropped.error();
    // Rows without their row in `derived` (somebody deleted it) must not become part of the new run.
    int64_t number = *dropped;
    for (const char* table : kTablesWithRuns) {
        const auto highest = highestRun(table);
        if (!highest)
            return highest.error();
        number = std::max(number, *highest);
    }
    ++number;
    auto insert = insertInto("derived");
    if (!insert)
        return insert.error();
    const std::string settings = run.settings_json.empty() ? "{}" : run.settings_json;
    (*insert)->bind(0, number).bind(1, std::string_view(run.kind)).bind(2, std::string_view(run.name));
    (*insert)->bind(3, std::string_view(run.created_utc)).bind(4, std::string_view(run.software));
    (*insert)->bind(5, std::string_view(settings)).bind(6, run.calibration_id).bind(7, run.actor_id);
    if (const Status done = (*insert)->run(); !done)
        return done.error();
    return number;
}

Status TakeEdit::removeRows(const std::string& table, const std::string& where) {
    if (!schema().has(table))
        return Done{};
    return database().execute("DELETE FROM " + table + where);
}

Status TakeEdit::dropRun(int64_t run) {
    if (run == kPrimaryRun)
        return Error{ErrorKind::kUsage,
                     database().name() + ": run 0 is the recording itself and is never dropped",
                     "Name a derived run"};
    if (const Status noted = noteDropped(run); !noted)
        return noted;
    for (const char* table : kTablesWithRuns)
        if (const Status removed = removeRows(table, " WHERE run=" + std::to_string(run)); !removed)
            return removed;
    return Done{};
}

Status TakeEdit::removeMarker(const MarkerRow& row, int suit) {
    suit = seen(suit);
    const Error none{ErrorKind::kUsage, database().name() + ": there is no such marker any more",
                     "Look at the take again"};
    if (!schema().has("marker"))
        return none;
    const std::string belongs = schema().expression("marker", "suit") + "=" + std::to_string(suit);
    auto find = database().prepare("SELECT rowid FROM marker WHERE sample=? AND kind=? AND label=? AND " +
                                   belongs + " LIMIT 1");
    if (!find)
        return find.error();
    find->bind(0, row.sample).bind(1, std::string_view(row.kind)).bind(2, std::string_view(row.label));
    const auto found = find->step();
    if (!found)
        return found.error();
    const auto id = *found ? find->integer(0) : std::nullopt;
    return id ? removeRows("marker", " WHERE rowid=" + std::to_string(*id)) : Status(none);
}

Status TakeEdit::setContacts(const std::optional<std::vector<FootContacts>>& contacts, int suit) {
    suit = seen(suit);
    const std::string where = " WHERE run=" + std::to_string(kPrimaryRun) + " AND " +
                              schema().expression("contact", "suit") + "=" + std::to_string(suit);
    if (Status removed = removeRows("contact", where); !removed)
        return removed;
    if (Status noted = setMeta(contactsKey(suit), contacts ? kContactsEdited : kContactsDetected); !noted)
        return noted;
    return contacts ? addContacts(kPrimaryRun, *contacts, suit) : Done{};
}

Status TakeEdit::removeMeta(const std::string& key) {
    if (!schema().has("meta"))
        return Done{};
    auto remove = database().prepare("DELETE FROM meta WHERE key=?");
    if (!remove)
        return remove.error();
    return remove->bind(0, std::string_view(key)).run();
}

Status TakeEdit::removeReference(int suit) {
    suit = seen(suit);
    return removeRows("reference",
                      " WHERE " + schema().expression("reference", "suit") + "=" + std::to_string(suit));
}

Status TakeEdit::removeExternalRoot(int suit) {
    suit = seen(suit);
    return removeRows("external_root",
                      " WHERE " + schema().expression("external_root", "suit") + "=" + std::to_string(suit));
}

Status TakeEdit::commit() {
    dropStatements();
    if (const Status committed = transaction_.commit(); !committed)
        return committed;
    return take_->load();
}

}  // namespace noctule
