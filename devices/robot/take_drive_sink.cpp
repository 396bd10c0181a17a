// SPDX-License-Identifier: Apache-2.0
// Robot rows into a take that exists: a thread writes what waits, some times a second, each time as one short
// transaction. Another program that holds the take makes them wait, at most for kMostWaiting rows; a disk
// that is full or broken ends the writing. Either way the drive goes on, and the record says how many rows
// are lost.
#include <condition_variable>
#include <deque>
#include <thread>

#include "core/recording/take_edit.h"
#include "devices/machine/clock.h"
#include "devices/robot/drive_recorder.h"

namespace noctule::robot_link {
namespace {

constexpr std::chrono::milliseconds kWriteEvery{200}, kLookAgain{50};
constexpr std::chrono::seconds kLongestWaitAtEnd{30};
/// Ten minutes of commands and states at 140 a second: 50 MB.
constexpr int64_t kMostWaiting = 170'000;
constexpr double kPatience_s = 0.2;

class TakeSinkOfDrive : public DriveSink {
public:
    explicit TakeSinkOfDrive(Take take) : take_(std::move(take)) {
        record_.take = take_.path();
        thread_ = std::thread([this] { work(); });
    }
    ~TakeSinkOfDrive() override { finish(); }

    void begin(const RobotDriveRow& drive) override {
        const std::lock_guard lock(mutex_);
        about_ = drive;
    }

    void add(RobotRows rows) override {
        const std::lock_guard lock(mutex_);
        if (closed_)
            return;
        if (gave_up_ || waiting_ + rows.count() > kMostWaiting) {
            record_.lost += rows.count();
            if (!record_.trouble)
                record_.trouble = Error{ErrorKind::kUnreadable,
                                        record_.take + ": another program has held the take for ten minutes",
                                        "Close the other program"};
            return;
        }
        waiting_ += rows.count();
        queue_.push_back(std::move(rows));
    }

    DriveRecord finish() override {
        {
            const std::lock_guard lock(mutex_);
            closed_ = true;
        }
        wake_.notify_all();
        if (thread_.joinable())
            thread_.join();
        return state();
    }

    DriveRecord state() const override {
        const std::lock_guard lock(mutex_);
        return record_;
    }

private:
    void work() {
        try {
            run();
        } catch (const std::exception& mistake) {
            giveUp({ErrorKind::kInternal, record_.take + ": internal error: " + mistake.what(),
                    "Please report it"});
        }
    }

    void run() {
        int64_t end_ns = 0;
        while (true) {
            bool closed = false;
            std::deque<RobotRows> rows;
            {
                std::unique_lock lock(mutex_);
                wake_.wait_for(lock, locked_since_ns_ ? kLookAgain : kWriteEvery, [this] { return closed_; });
                closed = closed_;
                rows = queue_;
            }
            if (closed && end_ns == 0)
                end_ns = steadyNow_ns() + std::chrono::nanoseconds(kLongestWaitAtEnd).count();
            const Status written = rows.empty() ? Status(Done{}) : write(rows);
            noteWait(!written);
            if (written)
                taken(rows);
            else if (!locked_)
                return giveUp(written.error());
            else if (closed && steadyNow_ns() > end_ns)
                return giveUp(written.error());
            if (closed && written)
                return;
            if (closed)
                std::this_thread::sleep_for(kLookAgain);
        }
    }

    /// To be asked while the edit that failed is still there.
    Status failed(const Error& why) {
        locked_ = take_.isLocked();
        return why;
    }

    Status write(const std::deque<RobotRows>& all) {
        auto edit = TakeEdit::begin(take_);
        if (!edit)
            return failed(edit.error());
        int64_t drive = drive_;
        if (drive == 0) {
            const auto added = edit->addRobotDrive(about());
            if (!added)
                return failed(added.error());
            drive = *added;
        }
        for (const RobotRows& rows : all)
            if (Status added = edit->addRobotRows(drive, withLost(rows)); !added)
                return failed(added.error());
        if (Status committed = edit->commit(); !committed)
            return failed(committed.error());
        drive_ = drive;
        return Done{};
    }

    RobotDriveRow about() const {
        const std::lock_guard lock(mutex_);
        return about_;
    }

    RobotRows withLost(RobotRows rows) const {
        const std::lock_guard lock(mutex_);
        rows.lost_rows = record_.lost;
        return rows;
    }

    void taken(const std::deque<RobotRows>& rows) {
        const std::lock_guard lock(mutex_);
        for (const RobotRows& one : rows) {
            record_.written += one.count();
            waiting_ -= one.count();
            queue_.pop_front();
        }
    }

    void noteWait(bool is_locked) {
        const int64_t now_ns = steadyNow_ns();
        const std::lock_guard lock(mutex_);
        if (is_locked && locked_since_ns_ == 0)
            locked_since_ns_ = now_ns;
        if (locked_since_ns_ > 0)
            record_.longest_wait_s =
                std::max(record_.longest_wait_s, static_cast<double>(now_ns - locked_since_ns_) * 1e-9);
        if (!is_locked)
            locked_since_ns_ = 0;
    }

    void giveUp(const Error& why) {
        const std::lock_guard lock(mutex_);
        gave_up_ = true;
        record_.trouble = why;
        record_.lost += waiting_;
        waiting_ = 0;
        queue_.clear();
    }

    Take take_;  ///< of the thread
    int64_t drive_ = 0;
    bool locked_ = false;       ///< the last failure was a lock
    mutable std::mutex mutex_;  ///< of the following
    std::condition_variable wake_;
    std::deque<RobotRows> queue_;
    int64_t waiting_ = 0, locked_since_ns_ = 0;
    RobotDriveRow about_;
    DriveRecord record_;
    bool closed_ = false, gave_up_ = false;
    std::thread thread_;
};

}  // namespace

Result<std::unique_ptr<DriveSink>> sinkIntoTake(const std::string& path) {
    auto take = Take::open(path, Access::kReadWrite, {.patience_s = kPatience_s});
    if (!take)
        return take.error();
    return std::unique_ptr<DriveSink>(std::make_unique<TakeSinkOfDrive>(std::move(*take)));
}

}  // namespace noctule::robot_link
