// SPDX-License-Identifier: Apache-2.0
// The robots beside the repository (../shared/data/robots); tests that need them skip without.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>

#include "core/robot/chain.h"
#include "core/robot/urdf_reader.h"

namespace noctule::robot {

inline const std::string kRobots = NOCTULE_SOURCE_DIR "/../shared/data/robots/";

class WithRobots : public ::testing::Test {
protected:
    void SetUp() override {
        if (!std::filesystem::exists(kRobots))
            GTEST_SKIP() << "needs ../shared/data/robots";
    }

    static RobotModel read(const std::string& file) {
        auto model = readUrdf(kRobots + file);
        EXPECT_TRUE(model) << (model ? "" : model.error().text());
        return model ? std::move(*model) : RobotModel{};
    }
    static Chain chain(const std::string& file, const std::string& base, const std::string& tip) {
        auto made = Chain::make(read(file), base, tip);
        EXPECT_TRUE(made) << (made ? "" : made.error().text());
        return std::move(made).value();
    }
};

}  // namespace noctule::robot
