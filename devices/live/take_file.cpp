// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <mutex>
#include <system_error>

#include "core/session/take_folder.h"
#include "devices/live/arrival_clock.h"
#include "devices/live/take_sink.h"
#include "devices/machine/random_uuid.h"

namespace noctule {
namespace {

/// The clock of a suit is better known after its row was written.
class ClockedWriter : public TakeWriter {
public:
    explicit ClockedWriter(TakeWriter writer) : TakeWriter(std::move(writer)) {}

    Status setSuitClock(int suit, const SuitClock& clock) {
        auto update = database().prepare("UPDATE suit SET clock_offset_ns=?,clock_rate=? WHERE id=?");
        if (!update)
            return update.error();
        return update->bind(0, clock.offset_ns).bind(1, clock.rate).bind(2, int64_t{suit}).run();
    }
};

/// A take that is being recorded. Whoever uses it holds the mutex.
struct OpenTake {
    struct OfSuit {
        int board_count = 0;
        bool compress = false;
        ArrivalClock arrivals;
        SuitClock noted = {};     ///< as it stands in the file
        int64_t robot_drive = 0;  ///< that began last
    };

    OpenTake(TakeWriter take, std::string where) : writer(std::move(take)), path(std::move(where)) {}

    bool isOfSeveral() const { return suits.size() > 1; }
    OfSuit& of(int suit) { return suits[static_cast<size_t>(suit - 1)]; }
    /// What failed for one suit has failed for all: what others wrote since the last commit is lost, too.
    Status checked(const Status& done) {
        if (!done && !failure)
            failure = done.error();
        return done;
    }
    /// Against the first suit, whose time is the take's.
    SuitClock clockOf(const OfSuit& suit) const {
        const auto first_ns = suits.front().arrivals.start_ns(), start_ns = suit.arrivals.start_ns();
        return {first_ns && start_ns ? static_cast<double>(*start_ns - *first_ns) : 0, 1};
    }
    /// Later, while another program holds the take.
    Status noteClocks() {
        for (size_t i = 1; i < suits.size(); ++i) {
            const SuitClock clock = clockOf(suits[i]);
            if (clock.offset_ns == suits[i].noted.offset_ns)
                continue;
            const auto ready = writer.ready();
            if (!ready || !*ready)
                return ready ? Status(Done{}) : Status(ready.error());
            if (const Status set = writer.setSuitClock(static_cast<int>(i + 1), clock); !set)
                return set;
            suits[i].noted = clock;
        }
        return Done{};
    }

    std::mutex mutex;
    ClockedWriter writer;
    std::string path;
    std::vector<OfSuit> suits;
    size_t unfinished = 0;
    std::optional<Error> failure;  ///< nothing more is written
    std::optional<Status> back;    ///< what became of going back to the last commit
    bool complete = false;
};

class TakeFile : public TakeSink {
public:
    TakeFile(std::shared_ptr<OpenTake> take, int suit)
        : take_(std::move(take)), path_(take_->path), suit_(suit) {}
    ~TakeFile() override {
        const auto lock = hold();
        if (!finished_)
            --take_->unfinished;
    }

    const std::string& path() const override { return path_; }
    /// After a yes nobody else uses the file until what follows is written: another suit's commit would end
    /// the transaction that was promised.
    Result<bool> ready() override {
        auto lock = hold();
        if (take_->failure)
            return *take_->failure;
        Result<bool> ready = take_->writer.ready();
        if (!ready)
            take_->failure = ready.error();
        else if (*ready)
            held_ = std::move(lock);
        return ready;
    }
    Status write(const LiveItem& item) override {
        const auto lock = hold();
        if (take_->failure)
            return *take_->failure;
        return take_->checked(std::visit([this](const auto& row) { return add(row); }, item));
    }
    Status commit() override {
        const auto lock = hold();
        return commitAll();
    }
    Status rollBack() override {
        const auto lock = hold();
        if (!take_->back)
            take_->back = take_->writer.rollBack();
        return *take_->back;
    }
    Status finish() override {
        const auto lock = hold();
        finished_ = true;
        if (--take_->unfinished > 0)
            return take_->failure ? Status(Done{}) : commitAll();
        if (const Status noted = take_->failure ? Status(Done{}) : take_->noteClocks(); !noted)
            return noted;
        take_->complete = true;
        return take_->writer.finish();
    }
    bool leftLog() const override { return take_->complete && take_->writer.leftLog(); }
    std::optional<int64_t> freeBytes() const override {
        std::error_code error;
        const auto space = std::filesystem::space(std::filesystem::path(path_).parent_path(), error);
        return error ? std::nullopt : std::optional(static_cast<int64_t>(space.available));
    }

private:
    /// The lock that ready() kept, or one of its own.
    std::unique_lock<std::mutex> hold() {
        return held_.owns_lock() ? std::move(held_) : std::unique_lock(take_->mutex);
    }
    Status commitAll() {
        if (take_->failure)
            return *take_->failure;
        const Status noted = take_->checked(take_->noteClocks());
        return noted ? take_->checked(take_->writer.commit()) : noted;
    }

    Status add(const ArrivedBlock& block) {
        OpenTake::OfSuit& suit = take_->of(suit_);
        suit.arrivals.note(block);
        return take_->writer.addBlock({block.firstSample(), block.sound->values}, suit.board_count, suit_,
                                      suit.compress);
    }
    Status add(const std::vector<Pulse>& pulses) {
        for (const Pulse& pulse : pulses) {
            const auto id = take_->writer.addPulse(pulse.sample, pulse.source, suit_);
            if (!id)
                return id.error();
            require(take_->isOfSeveral() || *id == pulse.id,
                    "pulses are numbered in the order in which they are recorded");
        }
        return Done{};
    }
    Status add(const GapRow& row) { return take_->writer.addGap(row, suit_); }
    Status add(const StatusRow& row) { return take_->writer.addStatus(row, suit_); }
    Status add(const MarkerRow& row) { return take_->writer.addMarker(row, suit_); }
    Status add(const NoteRow& row) {
        if (!take_->isOfSeveral())
            return take_->writer.addNote(row);
        return take_->writer.addNote({row.created_utc, "Suit " + std::to_string(suit_) + ": " + row.text});
    }
    Status add(const RobotDriveRow& row) {
        const auto drive = take_->writer.addRobotDrive(row);
        take_->of(suit_).robot_drive = drive ? *drive : 0;
        return drive ? Status(Done{}) : Status(drive.error());
    }
    Status add(const RobotRows& rows) {
        const int64_t drive = take_->of(suit_).robot_drive;
        require(drive > 0, "a robot's rows come after the drive they belong to");
        return take_->writer.addRobotRows(drive, rows);
    }

    std::shared_ptr<OpenTake> take_;
    std::string path_;
    int suit_;  ///< counts from 1
    bool finished_ = false;
    std::unique_lock<std::mutex> held_;  ///< from a ready() that said yes to what is written then
};

/// What the take format has one of stands there for suit 1.
std::string metaKey(const std::string& key, int suit) {
    if (suit == 1)
        return key;
    return (key.starts_with("x_") ? "" : "x_") + key + "_" + std::to_string(suit);
}

Status describe(TakeWriter& writer, const TakePlan& plan, int suit) {
    const auto id = writer.addSuit(plan.suit);
    if (!id)
        return id.error();
    require(*id == suit, "suits are numbered in the order of their plans");
    if (plan.calibration)
        if (const auto added = writer.addCalibration(*plan.calibration, suit); !added)
            return added.error();
    if (plan.actor)
        if (const auto added = writer.addActor(*plan.actor, plan.header.created_utc, suit); !added)
            return added.error();
    for (const auto& [key, value] : plan.meta)
        if (const Status set = writer.setMeta(metaKey(key, suit), value); !set)
            return set;
    for (const MarkerRow& marker : plan.markers)
        if (const Status added = writer.addMarker(marker, suit); !added)
            return added;
    return Done{};
}

Status describeAll(TakeWriter& writer, const std::vector<TakePlan>& plans) {
    for (size_t i = 0; i < plans.size(); ++i)
        if (const Status described = describe(writer, plans[i], static_cast<int>(i + 1)); !described)
            return described;
    return writer.commit();
}

}  // namespace

Result<std::vector<std::unique_ptr<TakeSink>>> makeTakeFiles(const std::vector<TakePlan>& plans) {
    require(!plans.empty(), "a take needs a suit");
    const TakePlan& plan = plans.front();
    std::error_code error;
    std::filesystem::create_directories(plan.folder, error);
    if (error)
        return Error{ErrorKind::kDisk, plan.folder.string() + ": cannot be made: " + error.message(),
                     "Check that you may write there"};
    const std::filesystem::path path = nextTakePath(plan.folder, plan.name);
    TakeHeader header = plan.header;
    header.name = path.stem().string();
    header.uuid = randomUuid();
    auto writer = TakeWriter::create(path.string(), header, {false, TakeWriter::Journal::kWal});
    if (!writer)
        return writer.error();
    if (const Status described = describeAll(*writer, plans); !described) {
        writer->abandon();
        return described.error();
    }
    const auto take = std::make_shared<OpenTake>(std::move(*writer), path.string());
    take->unfinished = plans.size();
    std::vector<std::unique_ptr<TakeSink>> sinks;
    for (const TakePlan& of : plans) {
        take->suits.push_back(
            {of.header.board_count, of.compress, ArrivalClock(static_cast<int>(of.header.sample_rate_hz))});
        sinks.push_back(std::make_unique<TakeFile>(take, static_cast<int>(sinks.size() + 1)));
    }
    return sinks;
}

Result<std::unique_ptr<TakeSink>> makeTakeFile(const TakePlan& plan) {
    auto sinks = makeTakeFiles({plan});
    if (!sinks)
        return sinks.error();
    return std::move(sinks->front());
}

void discardTakeFile(const std::string& path) {
    std::error_code ignored;
    for (const char* ending : {"", "-wal", "-shm"})
        std::filesystem::remove(path + ending, ignored);
}

}  // namespace noctule
