// SPDX-License-Identifier: MIT
#include "io/read_fiber.h"

#include <doctest/doctest.h>

#include "core/error.h"

using namespace tress;

namespace {

FiberDescription read(const std::vector<std::string>& assignments, const FiberDescription& before = {}) {
    return read_fiber(assignments, "--fiber", before);
}

std::string error_of(const std::vector<std::string>& assignments) {
    try {
        read(assignments);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("what is assigned changes, the rest stays") {
    FiberDescription before;
    before.parameters.beta_m = 0.2f;
    before.absorption = Melanin{0.25f, 0.5f};
    const FiberDescription fiber = read({"eumelanin=8", "alpha=3"}, before);
    CHECK(fiber.parameters.beta_m == 0.2f);
    CHECK(fiber.parameters.alpha_degrees == 3);
    REQUIRE(std::holds_alternative<Melanin>(fiber.absorption));
    CHECK(std::get<Melanin>(fiber.absorption).eumelanin == 8);
    CHECK(std::get<Melanin>(fiber.absorption).pheomelanin == 0.5f);
}

TEST_CASE("colours have commas, models have names") {
    const FiberDescription fiber = read({"color=0.8,0.5,0.2", "model=marschner"});
    CHECK(std::get<FiberColor>(fiber.absorption).value == Rgb(0.8f, 0.5f, 0.2f));
    CHECK(fiber.parameters.model == FiberModel::marschner);
}

TEST_CASE("what is wrong is named with its key") {
    CHECK(error_of({"eumelanin"}).find("expected key=value") != std::string::npos);
    CHECK(error_of({"eumelanine=1"}).find("nearest known: 'eumelanin'") != std::string::npos);
    CHECK(error_of({"eumelanin=much"}).find("--fiber: eumelanin") != std::string::npos);
    CHECK(error_of({"color=1,2"}).find("--fiber: color") != std::string::npos);
    CHECK(error_of({"color=0.1,0.2,0.3", "eumelanin=1"}).find("more than one") != std::string::npos);
    CHECK(error_of({"eta=1", "eta=2"}).find("twice") != std::string::npos);
    CHECK(error_of({"eumelanin=nan"}).find("--fiber: eumelanin") != std::string::npos);
}
