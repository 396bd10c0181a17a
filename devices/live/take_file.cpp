// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <system_error>

#include "core/session/take_folder.h"
#include "devices/device/random_uuid.h"
#include "devices/live/take_sink.h"

namespace noctule {
namespace {

class TakeFile : public TakeSink {
public:
    TakeFile(TakeWriter writer, std::string path, int board_count, bool compress)
        : writer_(std::move(writer)),
          path_(std::move(path)),
          board_count_(board_count),
          compress_(compress) {}

    const std::string& path() const override { return path_; }
    Status write(const LiveItem& item) override {
        return std::visit([this](const auto& row) { return add(row); }, item);
    }
    Result<bool> ready() override { return writer_.ready(); }
    Status commit() override { return writer_.commit(); }
    Status rollBack() override { return writer_.rollBack(); }
    Status finish() override { return writer_.finish(); }
    bool leftLog() const override { return writer_.leftLog(); }
    std::optional<int64_t> freeBytes() const override {
        std::error_code error;
        const auto space = std::filesystem::space(std::filesystem::path(path_).parent_path(), error);
        return error ? std::nullopt : std::optional(static_cast<int64_t>(space.available));
    }

private:
    Status add(const ArrivedBlock& block) {
        return writer_.addBlock({block.firstSample(), block.sound->values}, board_count_, 1, compress_);
    }
    Status add(const std::vector<Pulse>& pulses) {
        for (const Pulse& pulse : pulses) {
            const auto id = writer_.addPulse(pulse.sample, pulse.source);
            if (!id)
                return id.error();
            require(*id == pulse.id, "pulses are numbered in the order in which they are recorded");
        }
        return Done{};
    }
    Status add(const GapRow& row) { return writer_.addGap(row); }
    Status add(const StatusRow& row) { return writer_.addStatus(row); }
    Status add(const MarkerRow& row) { return writer_.addMarker(row); }
    Status add(const NoteRow& row) { return writer_.addNote(row); }
    Status add(const RobotDriveRow& row) {
        const auto drive = writer_.addRobotDrive(row);
        drive_ = drive ? *drive : 0;
        return drive ? Status(Done{}) : Status(drive.error());
    }
    Status add(const RobotRows& rows) {
        require(drive_ > 0, "a robot's rows come after the drive they belong to");
        return writer_.addRobotRows(drive_, rows);
    }

    TakeWriter writer_;
    std::string path_;
    int board_count_;
    bool compress_;
    int64_t drive_ = 0;  ///< that began last
};

Status describe(TakeWriter& writer, const TakePlan& plan) {
    if (const auto suit = writer.addSuit(plan.suit); !suit)
        return suit.error();
    if (plan.calibration)
        if (const auto id = writer.addCalibration(*plan.calibration); !id)
            return id.error();
    if (plan.actor)
        if (const auto id = writer.addActor(*plan.actor, plan.header.created_utc); !id)
            return id.error();
    for (const auto& [key, value] : plan.meta)
        if (const Status set = writer.setMeta(key, value); !set)
            return set;
    for (const MarkerRow& marker : plan.markers)
        if (const Status added = writer.addMarker(marker); !added)
            return added;
    return writer.commit();
}

}  // namespace

Result<std::unique_ptr<TakeSink>> makeTakeFile(const TakePlan& plan) {
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
    if (const Status described = describe(*writer, plan); !described) {
        writer->abandon();
        return described.error();
    }
    return std::unique_ptr<TakeSink>(
        std::make_unique<TakeFile>(std::move(*writer), path.string(), header.board_count, plan.compress));
}

}  // namespace noctule
