// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "app/batch/devices/record_report.h"
#include "app/batch/devices/record_together.h"
#include "app/batch/files.h"
#include "app/batch/program.h"
#include "devices/machine/clock.h"

namespace noctule::batch {
namespace {

constexpr double kBytesPerMegabyte = 1e6;

/// Of all suits alike.
StreamRequest sharedRequestOf(const Arguments& arguments) {
    StreamRequest request;
    request.take = RecordingRequest{};
    request.take->folder = arguments.text("out-dir");
    request.take->name = arguments.text("name");
    request.take->take_kind = arguments.text("kind");
    request.take->pre_roll_s = *arguments.number("pre-roll");
    request.take->reserve_bytes = std::llround(*arguments.number("reserve-mb") * kBytesPerMegabyte);
    request.software = softwareName();
    request.created_utc = utcNow();
    request.rest_s = *arguments.number("rest-seconds");
    request.keep_results = arguments.given("keep-results");
    return request;
}

Result<StreamRequest> streamRequestOf(const Arguments& arguments) {
    StreamRequest request = sharedRequestOf(arguments);
    if (const Status read = readGiven(arguments, "suit", readSuit, request.suit); !read)
        return read.error();
    if (const Status read = readGiven(arguments, "calibration", readCalibration, request.calibration); !read)
        return read.error();
    if (const Status read = readGiven(arguments, "actor", readActor, request.actor); !read)
        return read.error();
    if (request.actor)
        request.take->meta["actor_name"] = request.actor->name;
    if (arguments.given("subject"))
        request.take->meta["performer"] = arguments.text("subject");
    // Without a calibration nothing is known of distances, and poses would mislead.
    request.process = request.calibration.has_value() || request.keep_results;
    return request;
}

Status checkTrigger(const Arguments& arguments) {
    for (const char* option : {"trigger-from", "pre-roll"})
        if (arguments.given(option) && !arguments.given("trigger"))
            return Error{ErrorKind::kUsage, std::string("--") + option + " belongs to --trigger",
                         "Give a --trigger port as well, or leave it out"};
    return Done{};
}

Result<RecordReport> record(const VerbContext& context, std::unique_ptr<Device> device,
                            const StreamRequest& request) {
    const Arguments& arguments = context.arguments;
    const auto seconds = arguments.number("seconds");
    const auto port = arguments.whole("trigger");
    if (!port)
        return recordTake(std::move(device), request, seconds, context.job());
    return recordWhenTriggered(std::move(device), request,
                               {static_cast<uint16_t>(*port), arguments.text("trigger-from")}, seconds,
                               context.job());
}

Result<Outcome> runRecord(const VerbContext& context) {
    const Arguments& arguments = context.arguments;
    if (const Status checked = checkTrigger(arguments); !checked)
        return checked.error();
    if (arguments.texts("device").size() > 1)
        return recordSeveral(context, sharedRequestOf(arguments));
    if (const Status checked = checkPerDevice(arguments); !checked)
        return checked.error();
    const auto request = streamRequestOf(arguments);
    if (!request)
        return request.error();
    auto device = makeDevice(arguments.text("device"));
    if (!device)
        return device.error();
    const auto report = record(context, std::move(*device), *request);
    if (!report)
        return report.error();
    for (const std::string& warning : report->stream.warnings)
        context.console.warn(warning);
    if (report->stream.lacks_poses)
        context.console.warn(
            "The take has no poses yet: the live view skipped part of the sound. Process it.");
    Outcome outcome{recordingJson(*report), recordingText(*report), std::nullopt};
    for (const std::optional<Error>& trouble : {report->stream.recording->trouble, report->stream.trouble})
        if (trouble && !outcome.failure) {
            context.console.error(*trouble);
            outcome.json["error"] = errorJson(*trouble);
            outcome.failure = trouble;
        }
    return outcome;
}

}  // namespace

Verb recordVerb() {
    Verb verb;
    verb.name = "record";
    verb.summary = kRecordSummary;
    verb.example =
        "noctule --batch record --device tcp://127.0.0.1:41941 --out-dir takes --name walk --seconds 10";
    verb.options = {
        texts("device", "ADDRESS",
              "tcp://HOST:PORT, serial:///dev/ttyACM0 or replay:T.noctule; again for each further suit")
            .needed(),
        text("out-dir", "D", "folder of the take; made if it is missing").needed(),
        text("name", "N", "the take becomes the next free N_###").orElse("take"),
        number("seconds", "S", 0.01, 1e6, "how long; until Ctrl-C when not given"),
        whole("trigger", "PORT", 1, 65535,
              "wait for CaptureStart on this UDP port, and end on CaptureStop; the take has its name"),
        text("trigger-from", "ADDRESS", "listen to this computer alone, such as 10.0.0.5"),
        number("pre-roll", "S", 0, LiveSession::kLongestPreRoll_s,
               "with --trigger: the take begins so long before CaptureStart")
            .orElse("0"),
        choice("kind", {"motion", "jig", "level", "turntable"}, "what is recorded").orElse("motion"),
        inputFiles("suit", "S.json", "the suit as it is worn, matched by serial numbers; once per device"),
        inputFiles("calibration", "C.json",
                   "goes into the take; with it poses are made while recording; once per device"),
        inputFiles("actor", "A.json", "the performer; goes into the take; once per device"),
        texts("subject", "NAME", "who wears the suit; once per device"),
        number("rest-seconds", "S", 0, 3600, "the performer holds the rest pose so long at the beginning")
            .orElse("0"),
        flag("keep-results", "write the poses made while recording into the take"),
        number("reserve-mb", "MB", 0, 1e9, "the take ends when no more than this is free on the disk")
            .orElse("256")};
    verb.remarks = {
        "Ctrl-C ends the recording in good order, and the take is complete. A box that restarts and a disk "
        "that fills up end it too; the exit code is then 5 or 6, and what was recorded is safe. "
        "A box whose sound breaks off and does not come back leaves a gap to the end; the exit code is 5.",
        "Several suits, a --device each, go into one take, numbered in this order; a set of anchors in the "
        "room is a suit, too. --suit, --calibration, --actor and --subject then name one per device in the "
        "same order, `none` where a device has none. A box that is lost does not end the recording of the "
        "others."};
    verb.run = runRecord;
    return verb;
}

}  // namespace noctule::batch
