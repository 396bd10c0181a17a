// SPDX-License-Identifier: Apache-2.0
#include "core/processing/survey_room.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "core/math/rotation.h"
#include "core/processing/room_evidence.h"
#include "core/recording/take_edit.h"
#include "core/report/calibration_documents.h"
#include "core/report/room_document.h"
#include "core/suit/calibration_entries.h"
#include "core/suit/placed_suit.h"

namespace noctule {
namespace {

/// Misfit of file and survey against the room's size up to which they agree.
constexpr double kSameRoom = 0.35;

/// By its id.
Result<size_t> anchorNamed(const std::string& id, const std::string& option,
                           const room_survey::Evidence& evidence) {
    std::string names;
    for (size_t i = 0; i < evidence.anchors.size(); ++i) {
        if (evidence.anchors[i].id == id)
            return i;
        names += (names.empty() ? "" : ", ") + evidence.anchors[i].id;
    }
    return Error{ErrorKind::kUsage, option + " names anchor '" + id + "', which the room does not have",
                 "Its anchors are " + names};
}

Status addHeights(const RoomRequest& request, room_survey::Evidence& evidence) {
    for (const auto& [id, height_m] : request.heights_m) {
        const auto anchor = anchorNamed(id, "--height", evidence);
        if (!anchor)
            return anchor.error();
        evidence.heights.push_back({static_cast<int>(*anchor), height_m});
    }
    return Done{};
}

/// By id or number, each once.
Result<std::vector<size_t>> leftOut(const RoomRequest& request, const room_survey::Evidence& evidence) {
    std::set<size_t> anchors;
    for (const std::string& word : request.without) {
        const auto anchor = anchorNamed(word, "--without", evidence);
        const char* end = word.data() + word.size();
        size_t number = 0;
        if (anchor)
            anchors.insert(*anchor);
        else if (std::from_chars(word.data(), end, number).ptr == end && number >= 1 &&
                 number <= evidence.anchors.size())
            anchors.insert(number - 1);
        else
            return anchor.error();
    }
    return std::vector<size_t>(anchors.begin(), anchors.end());
}

/// By how much the room's file is turned about the vertical against the survey; nothing when both are not
/// alike.
std::optional<double> turnOfFile(const room_survey::RoomSurvey& survey,
                                 const room_survey::Evidence& evidence) {
    Vector3d old_middle = Vector3d::Zero(), middle = Vector3d::Zero();
    double count = 0;
    for (size_t i = 0; i < survey.anchors.size(); ++i)
        if (survey.anchors[i].placed) {
            old_middle += evidence.anchors[i].rough_m, middle += survey.anchors[i].place_m;
            ++count;
        }
    old_middle /= count, middle /= count;
    double along = 0, across = 0, size = 0;
    const auto each = [&](const auto& see) {
        for (size_t i = 0; i < survey.anchors.size(); ++i)
            if (survey.anchors[i].placed)
                see(Vector3d(evidence.anchors[i].rough_m - old_middle),
                    Vector3d(survey.anchors[i].place_m - middle));
    };
    each([&](const Vector3d& a, const Vector3d& b) {
        along += a.x() * b.x() + a.z() * b.z();
        across += a.z() * b.x() - a.x() * b.z();
        size += b.squaredNorm();
    });
    const double turn_rad = std::atan2(across, along);
    double misfit = 0;
    each([&](const Vector3d& a, const Vector3d& b) {
        misfit += (axisAngle(Vector3d::UnitY(), turn_rad) * a - b).squaredNorm();
    });
    return misfit < kSameRoom * kSameRoom * size ? std::optional(turn_rad) : std::nullopt;
}

/// The turn about the vertical with which an anchor faces a point.
double turnTowards(const Vector3d& normal, const Vector3d& from_m, const Vector3d& to_m) {
    const Vector3d way = to_m - from_m;
    return std::atan2(way.x(), way.z()) - std::atan2(normal.x(), normal.z());
}

/// The room's file with the places found. Housings turn with the room, or face where the performer was.
Suit surveyedRoom(const RoomEvidence& take, const room_survey::RoomSurvey& survey,
                  std::vector<std::string>& warnings) {
    const Suit old = placedSuit(take.room.suit, take.room.calibration);
    const auto turn_rad = turnOfFile(survey, take.evidence);
    Vector3d middle_m = Vector3d::Zero();
    for (const Vector3d& walked_m : survey.walked_m)
        middle_m += walked_m / static_cast<double>(survey.walked_m.size());
    if (!turn_rad)
        warnings.push_back(
            "The room's file had the anchors elsewhere: they are believed to face where the performer "
            "walked.");
    Suit room = old;
    room.boards.clear(), room.sources.clear();
    for (size_t a = 0; a < survey.anchors.size(); ++a) {
        const room_survey::SurveyedAnchor& anchor = survey.anchors[a];
        if (!anchor.placed)
            continue;
        const auto [b, s] = take.parts[a];
        const Vector3d normal = s >= 0
                                    ? old.sources[static_cast<size_t>(s)].normal_segment
                                    : old.boards[static_cast<size_t>(b)].q_segment_board * Vector3d::UnitZ();
        const Quaterniond turn = axisAngle(
            Vector3d::UnitY(), turn_rad ? *turn_rad : turnTowards(normal, anchor.place_m, middle_m));
        if (b >= 0) {
            Board board = old.boards[static_cast<size_t>(b)];
            board.q_segment_board = turn * board.q_segment_board;
            board.p_segment_board_m = anchor.microphone_m - board.q_segment_board * board.p_board_mic_m;
            room.boards.push_back(std::move(board));
        }
        if (s >= 0) {
            Source source = old.sources[static_cast<size_t>(s)];
            source.normal_segment = turn * source.normal_segment;
            source.p_segment_source_m = anchor.source_m;
            room.sources.push_back(std::move(source));
        }
    }
    return room;
}

/// Of one moment: the take may still be recorded.
Result<RoomEvidence> gatherNow(Take& take, const std::string& performer, const JobContext& job) {
    const auto moment = take.snapshot();
    if (!moment)
        return moment.error();
    return gatherRoom(take, performer, job);
}

/// What the survey says, as a document and for machines.
void describe(SurveyedTake& surveyed, const std::string& created_utc, const std::vector<std::string>& takes) {
    CalibrationResult& result = surveyed.result;
    result.document = documentOf(surveyed.survey);
    result.document.created_utc = created_utc;
    result.document.takes = takes;
    result.json = toJson(surveyed.survey);
    result.json["procedure"] = "room";
    result.json["takes"] = takes;
    result.json.update(findingsJson(surveyed.survey.findings));
}

}  // namespace

Result<SurveyedTake> calibrateRoom(const RoomRequest& request, const JobContext& job) {
    auto take = Take::open(request.take_path, Access::kRead, {job.cancel});
    if (!take)
        return take.error();
    auto gathered = gatherNow(*take, request.performer, job);
    if (!gathered)
        return gathered.error();
    if (Status heights = addHeights(request, gathered->evidence); !heights)
        return heights.error();
    const auto without = leftOut(request, gathered->evidence);
    if (!without)
        return without.error();
    auto survey = room_survey::surveyRoom(gathered->evidence, {}, job);
    if (!survey) {
        Error error = survey.error();
        error.message = request.take_path + ": " + error.message;
        return error;
    }
    SurveyedTake surveyed;
    surveyed.before = placedSuit(gathered->room.suit, gathered->room.calibration);
    CalibrationResult& result = surveyed.result;
    result.room = surveyedRoom(*gathered, *survey, gathered->warnings);
    result.calibration = gathered->room.calibration;
    result.warnings = std::move(gathered->warnings);
    surveyed.survey = std::move(*survey);
    describe(surveyed, request.created_utc, {request.take_path});
    return withoutAnchors(std::move(surveyed), *without);
}

Result<SurveyedTake> withoutAnchors(SurveyedTake surveyed, const std::vector<size_t>& anchors) {
    if (Status left_out = room_survey::leaveOut(surveyed.survey, anchors); !left_out)
        return left_out.error();
    const auto is_out = [&](const std::string& id) {
        return std::ranges::any_of(surveyed.survey.anchors, [&](const room_survey::SurveyedAnchor& anchor) {
            return anchor.left_out && anchor.id == id;
        });
    };
    Suit& room = *surveyed.result.room;
    std::set<std::string> boards, sources;
    for (const auto& [b, s] : anchorParts(room)) {
        const std::string board = b >= 0 ? room.boards[static_cast<size_t>(b)].id : std::string();
        const std::string source = s >= 0 ? room.sources[static_cast<size_t>(s)].id : std::string();
        if (!is_out(b >= 0 ? board : source))
            continue;
        boards.insert(board);
        sources.insert(source);
    }
    std::erase_if(room.boards, [&](const Board& board) { return boards.contains(board.id); });
    std::erase_if(room.sources, [&](const Source& source) { return sources.contains(source.id); });
    const CalibrationDocument before = surveyed.result.document;
    describe(surveyed, before.created_utc, before.takes);
    return surveyed;
}

Status placeAnchors(const std::string& take_path, const Suit& room, const std::string& created_utc,
                    std::vector<std::string>& warnings) {
    auto take = Take::open(take_path, Access::kReadWrite);
    if (!take)
        return take.error();
    auto of_take = roomOfTake(*take);
    if (!of_take)
        return of_take.error();
    Calibration& calibration = of_take->calibration;
    std::string lacking;
    size_t placed = 0;
    for (const Board& board : of_take->suit.boards)
        if (const int b = room.findBoard(board.id); b >= 0) {
            BoardCalibration& entry = entryOf(calibration, board);
            entry.p_segment_board_m = room.boards[static_cast<size_t>(b)].p_segment_board_m;
            entry.q_segment_board = room.boards[static_cast<size_t>(b)].q_segment_board;
            entry.sigma_mounting_rad.reset();
            ++placed;
        } else {
            lacking += (lacking.empty() ? "" : ", ") + board.id;
        }
    for (const Source& source : of_take->suit.sources)
        if (const int s = room.findSource(source.id); s >= 0) {
            entryOf(calibration, source).p_segment_source_m =
                room.sources[static_cast<size_t>(s)].p_segment_source_m;
            ++placed;
        } else if (source.board.empty()) {
            lacking += (lacking.empty() ? "" : ", ") + source.id;
        }
    if (placed == 0)
        return Error{ErrorKind::kUsage,
                     take_path + ": the room's file has none of its anchors (" + lacking + ")",
                     "Give the file of this room"};
    if (!lacking.empty())
        warnings.push_back("The room's file lacks " + lacking + ": their places stay as they were.");
    calibration.created_utc = created_utc;
    auto edit = TakeEdit::begin(*take);
    if (!edit)
        return edit.error();
    if (auto added = edit->addCalibration(calibration, of_take->subject.suit()); !added)
        return added.error();
    return edit->commit();
}

}  // namespace noctule
