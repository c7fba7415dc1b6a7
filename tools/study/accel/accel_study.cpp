// SPDX-License-Identifier: MIT
#include "tools/study/accel/accel_study.h"

#include <tbb/global_control.h>

#include <filesystem>

#include "gather/prepared_scene.h"
#include "io/load_scene.h"
#include "io/whole_file.h"
#include "tools/progress.h"
#include "tools/study/accel/tree_page.h"
#include "tools/study/accel/tree_result.h"
#include "tools/study/accel/tree_run.h"
#include "tools/study/accel/tree_spread.h"
#include "tools/study/csv.h"

namespace tress {
namespace {

/// What a study does where nothing else is said.
struct Defaults {
    int rounds;
    double seconds;  // of tracing, a set
};
constexpr Defaults kQuick{1, 0.4}, kFull{3, 1};

class TreeRuns {
public:
    TreeRuns(const StudyScene& scene, std::vector<TreeRow> rows, int rounds, double seconds, bool quiet)
        : scene_(scene), rounds_(rounds), seconds_(seconds), progress_("study", quiet) {
        for (TreeRow& row : rows) measured_.push_back({std::move(row), {}});
    }

    /// Round by round, so that a study that is cut short has all rows, and a machine's moods meet all alike.
    std::vector<MeasuredTree> measure(const SegmentView& segments, const std::vector<TreeRays>& rays, StudyLog& log) {
        double done = 0;
        for (int round = 0; round < rounds_; ++round)
            for (MeasuredTree& tree : measured_) {
                progress_.update(
                    done++ / (double(measured_.size()) * rounds_),
                    tree.row.name + ", round " + std::to_string(round + 1) + " of " + std::to_string(rounds_));
                const Json* known = log.find(tree_key(scene_, tree.row, round, seconds_));
                if (!known) log.add(run_tree(scene_, segments, rays, tree.row, round, seconds_));
                tree.runs.push_back(*log.find(tree_key(scene_, tree.row, round, seconds_)));
            }
        progress_.finish("done");
        return std::move(measured_);
    }

private:
    const StudyScene& scene_;
    int rounds_;
    double seconds_;
    Progress progress_;
    std::vector<MeasuredTree> measured_;
};

std::vector<Json> all_runs(const std::vector<MeasuredTree>& trees) {
    std::vector<Json> runs;
    for (const MeasuredTree& tree : trees) runs.insert(runs.end(), tree.runs.begin(), tree.runs.end());
    return runs;
}

}  // namespace

void run_accel_study(const AccelStudyArguments& a) {
    const Defaults defaults = a.quick ? kQuick : kFull;
    const int rounds = a.rounds ? a.rounds : defaults.rounds;
    std::vector<TreeRow> rows = tree_rows(a.rows, a.sweeps, a.quick);
    std::filesystem::create_directories(a.output);
    const auto file = [&](const char* name) { return (std::filesystem::path(a.output) / name).string(); };
    check_writable(file("study.jsonl"));
    StudyLog log(file("study.jsonl"));

    const SceneDescription description = describe(a.scene);
    const double seconds = a.scene.flags.contains("time") ? description.options.time : defaults.seconds;
    const LoadedScene loaded = load_scene(description);
    const StudyScene scene = study_scene(a.scene, description, loaded.scene);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, size_t(scene.threads));
    const Plan plan = plan_tree_rays(loaded.scene);
    PreparedScene prepared = prepare(loaded.scene, plan, scene.options);
    const std::vector<TreeRays> rays = make_tree_rays(loaded.scene, plan, prepared, scene.options);
    prepared.hair = {};  // its memory is for the trees

    const std::vector<MeasuredTree> trees =
        TreeRuns(scene, std::move(rows), rounds, seconds, a.quiet).measure(prepared.segments, rays, log);
    const std::vector<Json> results = tree_results(trees, {scene.options, scene.segments}, scene.threads);
    const Json spread = tree_spread(results);
    Json head = header(scene, "accel");
    head["rounds"] = rounds;
    head["seconds_a_set"] = seconds;
    head["quick"] = a.quick;
    head["rays"] = Json::object();
    for (const TreeRays& set : rays) head["rays"][set.name] = set.rays.size();
    std::vector<Json> derived = results;
    derived.push_back(spread);
    log.write(head, derived);
    write_text_file(file("rows.csv"), rows_csv(results));
    write_text_file(file("runs.csv"), rows_csv(all_runs(trees)));
    write_page(make_tree_page(head, results, spread), a.output);
    if (!a.quiet) std::fprintf(stderr, "%s\n", file("index.html").c_str());
}

}  // namespace tress
