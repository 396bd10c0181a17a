// SPDX-License-Identifier: Apache-2.0
// Damaged recordings into every reader: each is refused or read, never crashes, throws or grows.
#include <cmath>

#include "core/import/import_format.h"
#include "core/import/markers.h"
#include "core/math/json.h"
#include "tests/core/import/example_files.h"
#include "tests/support/fuzzing.h"

namespace noctule::test {
namespace {

constexpr int64_t kMostImportGrowth_kb = 64 * 1024;
constexpr int64_t kFewInputs = 1500;

void expectWhole(const Result<ImportedRecording>& read) {
    if (!read) {
        EXPECT_FALSE(read.error().remedy.empty()) << read.error().message;
        EXPECT_NE(read.error().kind, ErrorKind::kInternal);
        return;
    }
    for (const ImportedSensor& sensor : read->sensors) {
        EXPECT_EQ(sensor.samples.accel_m_per_s2.size(), sensor.samples.size());
        EXPECT_TRUE(sensor.q_world_sensor.empty() || sensor.q_world_sensor.size() == sensor.samples.size());
        EXPECT_TRUE(sensor.samples.rate_hz >= 1 && sensor.samples.rate_hz <= 10'000)
            << sensor.samples.rate_hz;
        EXPECT_TRUE(sensor.offset_s >= 0);
        for (const Vector3d& rate : sensor.samples.gyro_rad_per_s)
            EXPECT_FALSE(rate.allFinite() && rate.norm() > 2000) << rate.transpose();
    }
}

void feedFormat(const char* name, const std::string& path, const std::vector<std::string>& examples,
                const ImportChoice& choice = {}) {
    const ImportFormat* format = findImportFormat(name);
    ASSERT_TRUE(format);
    feedDamaged(examples, kFewInputs, kMostImportGrowth_kb, [&](const std::string& bytes, int64_t) {
        expectWhole(readImport(*format, {{path, bytes}}, choice, {}));
    });
}

TEST(FuzzImport, XsensText) {
    feedFormat("mt", "MT_1_00B42D4B.txt",
               {xsensExample({65533, 65534, 65535, 0, 1, 2}, '\t', true),
                xsensExample({1, 2, 5, 6}, ' ', false), xsensExample({1, 2, 3}, ';', true, "\r\n")});
}
TEST(FuzzImport, Mvnx) {
    feedFormat("mvnx", "walk.mvnx", {mvnxExample(4)});
}
TEST(FuzzImport, Ximu3Stream) {
    feedFormat("ximu3", "a.ximu3", {ximu3Binary()});
}
TEST(FuzzImport, Ximu3Csv) {
    feedFormat("ximu3", "pelvis/Inertial.csv", {ximu3Csv(12)});
}
TEST(FuzzImport, Sto) {
    feedFormat("sto", "a.sto", {stoExample()});
}
TEST(FuzzImport, Csv) {
    ImportChoice choice;
    choice.map =
        nlohmann::json::parse(R"({"time":{"column":1,"unit":"ms"},"sensors":[{"id":"a","accel":[2,3,4],
        "accel_unit":"g","gyro":[2,3,4],"gyro_unit":"deg/s","quaternion":[1,2,3,4]}]})");
    feedFormat("csv", "a.csv",
               {"t;x;y;z\n0;0;0;1\n10;0;0,5;1\n20;1;0;1\n", "0,1,2,3\n10,1,2,3\n20,\"1\",2,3\n"}, choice);
}
TEST(FuzzImport, Maps) {
    const std::vector<std::string> examples = {
        R"({"time":{"column":"t","unit":"ms"},"world":"enu","sensors":[{"id":"a","segment":"Hips",)"
        R"("accel":["x","y","z"],"accel_unit":"g","axes":["y","-x","z"],"quaternion":["t","x","y","z"]}]})",
        R"({"rate_hz":100,"sensors":[{"id":"b","gyro":[1,2,3],"gyro_unit":"rad/s","mag":[2,3,4],"mag_unit":"uT"}]})"};
    feedDamaged(examples, kFewInputs, kMostImportGrowth_kb, [](const std::string& text, int64_t) {
        ImportChoice choice;
        choice.map = json::parse(text);
        if (choice.map.is_object())
            expectWhole(readImport(*findImportFormat("csv"),
                                   {{"a.csv", "t,x,y,z\n0,0,0,1\n10,0,0,1\n20,0,0,1\n"}}, choice, {}));
    });
}
void expectMarkers(const Result<MarkerRecording>& read) {
    if (!read) {
        EXPECT_FALSE(read.error().remedy.empty()) << read.error().message;
        return;
    }
    EXPECT_FALSE(read->names.empty());
    EXPECT_EQ(read->p_m.size(), read->rows() * read->names.size());
    EXPECT_TRUE(read->rate_hz >= 1 && read->rate_hz <= 100'000);
}
TEST(FuzzImport, C3d) {
    std::vector<std::string> examples;
    for (const int processor : {84, 85, 86})
        for (const bool floats : {false, true})
            examples.push_back(C3dExample(processor, floats).bytes());
    feedDamaged(examples, kFewInputs, kMostImportGrowth_kb,
                [](const std::string& bytes, int64_t) { expectMarkers(parseC3d(bytes, "a.c3d", {})); });
}
TEST(FuzzImport, Trc) {
    feedDamaged({trcExample()}, kFewInputs, kMostImportGrowth_kb,
                [](const std::string& bytes, int64_t) { expectMarkers(parseTrc(bytes, "a.trc", {})); });
}

}  // namespace
}  // namespace noctule::test
