// SPDX-License-Identifier: MIT
// Results of made-up runs whose bias and noise are known, and what is said of them.
#include "tools/study/methods/row_result.h"

#include <doctest/doctest.h>

#include <cmath>

#include "tools/study/methods/verdict.h"

using namespace tress;

namespace {

/// A row whose relMSE is bias^2 + reference + noise / t, a sample a pixel each `step` seconds.
struct MadeRow {
    const char* methods;
    double bias, noise, build, step;
};

constexpr double kReference = 1e-5;

Json errors_at(const MadeRow& row, double seconds) {
    const double error = row.bias * row.bias + kReference + row.noise / seconds;
    const Json layer{
        {"relmse", error}, {"relmse_trimmed", error}, {"mean_ratio", 1 - row.bias}, {"flip", std::sqrt(error)}};
    return {{"whole", layer}, {"type2", layer}};
}

MeasuredRow measured(const MadeRow& row, int last_spp, int runs) {
    MeasuredRow m{parse_row(row.methods), {}};
    for (const StudyRow& paper : paper_rows())
        if (paper.name == m.row.name) m.row = paper;
    for (int run = 0; run < runs; ++run) {
        Json points = Json::array();
        for (int spp = 1; spp <= last_spp; spp *= 2)
            points.push_back({{"spp", spp}, {"seconds", spp * row.step}, {"errors", errors_at(row, spp * row.step)}});
        m.runs.push_back({{"row", m.row.name},
                          {"seconds", {{"build", row.build + run}}},
                          {"peak_rss_bytes", 1000000 * (run + 1)},
                          {"points", points}});
    }
    return m;
}

const Json kReferenceLine{{"errors", {{"whole", kReference}, {"type2", kReference}}}};

}  // namespace

TEST_CASE("bias, noise, times and equals of made-up rows are those they were made of") {
    const MadeRow ray{"RT/RT/-", 0, 0.1, 2, 0.5}, projection{"RT/P/-", 0.02, 0.02, 5, 1};
    const std::vector<Json> results = row_results({measured(ray, 32, 3), measured(projection, 16, 3)}, kReferenceLine);
    REQUIRE(results.size() == 2);
    const Json &r = results[0], &p = results[1];
    CHECK(r["spp"] == 16);           // the second row has no more
    CHECK(r["build_seconds"] == 3);  // the middle one of 2, 3, 4
    CHECK(r["render_seconds"] == 8);
    CHECK(r["total_seconds"] == 11);
    CHECK(p["total_seconds"] == 22);
    CHECK(p["times_as_fast"] == 0.5);
    CHECK(p["paper_times_as_fast"].get<double>() == doctest::Approx(29631.0 / 673));
    CHECK(r["peak_rss_bytes"] == 2000000);
    CHECK(r["layers"]["whole"]["bias"].get<double>() < 1e-6);  // without the reference's own error
    CHECK(p["layers"]["type2"]["bias"].get<double>() == doctest::Approx(0.02).epsilon(1e-6));
    CHECK(p["layers"]["type2"]["noise"].get<double>() == doctest::Approx(0.02).epsilon(1e-6));
    CHECK(p["layers"]["whole"]["signed_mean"].get<double>() == doctest::Approx(-0.02));
    for (const Json& row : results)
        for (const Json& at : row["equal_error"]) {
            const MadeRow& made = &row == &results[0] ? ray : projection;
            const double error = at["relmse"], floor = made.bias * made.bias;
            CAPTURE(at.dump());
            if (error <= floor)
                CHECK(at["seconds"].is_null());
            else
                CHECK(at["seconds"].get<double>() ==
                      doctest::Approx(made.build + 1 + made.noise / (error - floor)).epsilon(1e-6));
        }
    for (const Json& at : r["equal_time"]) {
        const double t = at["seconds"].get<double>() - 3;
        CAPTURE(at.dump());
        if (t <= 0)
            CHECK(at["relmse"].is_null());
        else
            CHECK(at["relmse"].get<double>() == doctest::Approx(0.1 / t).epsilon(1e-6));
        CHECK(at["beyond"] == (t < 0.5 || t > 16));
    }
    CHECK(r["equal_time"].size() >= 2);
    CHECK(r["equal_error"].size() >= 2);
}

TEST_CASE("the verdict names the quickest, those not worth it, those kept away by bias, and the paper's ratio") {
    const std::vector<Json> results =
        row_results({measured({"RT/RT/RT", 0, 0.4, 2, 1}, 64, 2), measured({"DSM/RT/-", 0, 1.5, 20, 2}, 64, 2),
                     measured({"RT/RT/-", 0, 0.3, 2, 1}, 64, 2), measured({"RT/P/-", 0.09, 0.01, 2, 1}, 64, 2)},
                    kReferenceLine);
    const Json verdict = verdict_of(results, kReferenceLine);
    const std::string text = verdict["text"];
    CAPTURE(text);
    CHECK(text.find("RT / P / – is the quickest") != std::string::npos);
    CHECK(text.find("RT / RT / – is the quickest") != std::string::npos);
    CHECK(text.find("Not worth it at any of these errors, by 1.25 times and more: RT / RT / RT and DSM / RT / –.") !=
          std::string::npos);
    CHECK(text.find("RT / P / – (9.0 %, its mean -9.0 %)") != std::string::npos);
    CHECK(text.find("2.36 times as fast in the paper; here it is 1.0 times at equal samples") != std::string::npos);
    CHECK(verdict["reference_is_enough"] == true);
    CHECK(verdict["reference"]["whole"]["share"].get<double>() ==
          doctest::Approx(kReference / (kReference + 0.3 / 64)).epsilon(1e-6));
}

TEST_CASE("a reference that errs by more than a tenth of the smallest error shown is not enough") {
    const std::vector<Json> results = row_results({measured({"RT/RT/-", 0, 1e-4, 1, 1}, 16, 1)}, kReferenceLine);
    CHECK(verdict_of(results, kReferenceLine)["reference_is_enough"] == false);  // 1e-5 of 1.6e-5
}
