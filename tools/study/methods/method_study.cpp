// SPDX-License-Identifier: MIT
#include "tools/study/methods/method_study.h"

#include <algorithm>
#include <filesystem>

#include "core/error.h"
#include "core/plan.h"
#include "io/exr_file.h"
#include "io/load_scene.h"
#include "io/whole_file.h"
#include "tools/progress.h"
#include "tools/study/csv.h"
#include "tools/study/methods/method_page.h"
#include "tools/study/methods/reference.h"
#include "tools/study/methods/row_result.h"
#include "tools/study/methods/study_run.h"
#include "tools/study/methods/verdict.h"
#include "tools/study/sweep.h"

namespace tress {
namespace {

/// What a study does where nothing else is said.
struct Defaults {
    int longer_side;           // pixels
    int seeds;                 // runs a row
    double seconds;            // of rendering, a run
    double reference_seconds;  // both halves
    std::vector<std::string> sets;
};
// A first page in under two minutes: photons and shadow maps are coarser, so that preparing six rows takes half of it.
const Defaults kQuick{96, 1, 3, 24, {"photons.count=200000", "maps.grid=1"}};
const Defaults kFull{160, 3, 20, 600, {}};
constexpr double kPreparation = 8;  // seconds a run, expected before one is known

/// The scene's shape, its longer side so many pixels.
std::string size_text(const Camera& camera, int longer_side) {
    const double scale = std::min(1.0, double(longer_side) / std::max(camera.width, camera.height));
    const auto side = [&](int pixels) { return std::to_string(std::max(1, int(std::lround(scale * pixels)))); };
    return side(camera.width) + "x" + side(camera.height);
}

void set_defaults(MethodStudyArguments& a, const Defaults& defaults) {
    if (a.scene.size.empty()) a.scene.size = size_text(describe(a.scene).camera, defaults.longer_side);
    a.scene.sets.insert(a.scene.sets.begin(), defaults.sets.begin(), defaults.sets.end());  // the user's come later
    if (a.seeds == 0) a.seeds = defaults.seeds;
    if (a.reference_seconds == 0) a.reference_seconds = defaults.reference_seconds;
    if (!a.scene.flags.contains("time") && !a.scene.flags.contains("spp"))
        a.scene.flags["time"] = std::to_string(defaults.seconds);
}

/// The paper's rows and those asked for; of convergence those asked for alone, if any.
std::vector<StudyRow> rows_of(const MethodStudyArguments& a, MethodStudyKind kind) {
    std::vector<StudyRow> rows;
    for (const std::string& text : a.rows) rows.push_back(parse_row(text));
    if (a.all) {
        const std::vector<StudyRow> all = all_rows();
        rows.insert(rows.end(), all.begin(), all.end());
    }
    const std::vector<StudyRow> paper = paper_rows();
    if (kind == MethodStudyKind::methods || rows.empty()) rows.insert(rows.begin(), paper.begin(), paper.end());
    std::vector<StudyRow> unique;
    for (StudyRow& row : rows)
        if (std::none_of(unique.begin(), unique.end(), [&](const StudyRow& u) { return u.name == row.name; }))
            unique.push_back(std::move(row));
    return across(unique, grid(a.sweeps));
}

/// Types that any row computes. Throws where a row contradicts itself or a scene cannot be rendered so.
TypeSet types_of(const std::vector<StudyRow>& rows, const Scene& scene, const Options& base) {
    TypeSet types{};
    for (const StudyRow& row : rows) {
        const Options options = options_of(row, base);
        make_plan(scene, options);
        const TypeSet on = types_on(options);
        for (size_t type = 0; type < types.size(); ++type) types[type] |= on[type];
    }
    if (!any(types)) throw InputError("--row", "no type of light is on in any row, expected one");
    return types;
}

/// What is being made: emptied at the start, for a study that was killed leaves something, and gone at the end.
std::string work_folder(const MethodStudyArguments& a) {
    return (std::filesystem::path(a.output) / "study.part").string();
}

/// Runs what the log does not have yet, seed by seed, so that a study that is cut short has all rows.
class Runs {
public:
    Runs(const StudyScene& scene, const std::vector<StudyRow>& rows, const MethodStudyArguments& arguments)
        : scene_(scene), arguments_(arguments), progress_("study", arguments.quiet) {
        for (const StudyRow& row : rows) measured_.push_back({row, {}});
        budget_.seconds = scene.options.time;
        budget_.samples = arguments.scene.flags.contains("spp") ? scene.options.spp : 0;
    }

    std::vector<MeasuredRow> measure(const TypeSet& types, StudyLog& log, Reference& reference) {
        const double run = budget_.seconds > 0 ? budget_.seconds + kPreparation : kPreparation;
        const double all = arguments_.reference_seconds + run * double(measured_.size()) * arguments_.seeds;
        double done = 0;
        progress_.update(0, "the reference, by paths");
        reference =
            make_reference(scene_, types, arguments_.reference_seconds, references_folder(), work_folder(arguments_));
        if (!log.find(reference.line["key"])) log.add(reference.line);
        done += arguments_.reference_seconds;
        for (int seed = 0; seed < arguments_.seeds; ++seed)
            for (MeasuredRow& row : measured_) {
                progress_.update(done / all, row.row.name + ", run " + std::to_string(seed + 1) + " of " +
                                                 std::to_string(arguments_.seeds));
                row.runs.push_back(run_once(row.row, seed, log, reference));
                done += run;
            }
        progress_.finish("done");
        return std::move(measured_);
    }

private:
    std::string references_folder() const {
        if (!arguments_.references.empty()) return arguments_.references;
        return (std::filesystem::path(arguments_.output) / "reference").string();
    }

    Json run_once(const StudyRow& row, int seed, StudyLog& log, const Reference& reference) {
        Budget budget = budget_;
        budget.seed = scene_.options.seed + uint64_t(seed);
        const Json* known = log.find(run_key(scene_, row, budget, reference));
        if (known && std::filesystem::exists(std::filesystem::path(arguments_.output) / (*known)["picture"]))
            return *known;
        Json line = run_row(scene_, row, budget, reference, arguments_.output, work_folder(arguments_));
        log.add(line);
        return line;
    }

    const StudyScene& scene_;
    const MethodStudyArguments& arguments_;
    Progress progress_;
    std::vector<MeasuredRow> measured_;
    Budget budget_;
};

void write_results(const MethodStudyArguments& arguments, MethodStudyKind kind, const StudyScene& scene,
                   const std::vector<MeasuredRow>& rows, const Reference& reference, const StudyLog& log) {
    const std::filesystem::path folder(arguments.output);
    const auto write = [&](const std::string& name, const std::string& text) {
        write_text_file((folder / name).string(), text);
    };
    MethodResults results{header(scene, kind == MethodStudyKind::methods ? "methods" : "convergence"),
                          reference.line,
                          row_results(rows, reference.line),
                          {}};
    results.header["runs_a_row"] = arguments.seeds;
    results.header["seconds_a_run"] = scene.options.time;
    results.header["quick"] = arguments.quick;
    results.verdict = verdict_of(results.rows, results.reference);
    std::vector<Json> derived = results.rows;
    derived.push_back(results.verdict);
    log.write(results.header, derived);
    write("rows.csv", rows_csv(results.rows));
    write("points.csv", points_csv(rows));

    Page page = make_method_page(results, rows);
    page.plots_first = kind == MethodStudyKind::convergence;
    page.exposure = scene.options.film.exposure;
    page.pictures.push_back({"reference", reference.picture});
    for (const MeasuredRow& row : rows)
        page.pictures.push_back({row.row.name, read_exr((folder / row.runs.front()["picture"]).string())});
    write_page(page, arguments.output);
}

}  // namespace

void run_method_study(MethodStudyArguments arguments, MethodStudyKind kind) {
    set_defaults(arguments, arguments.quick ? kQuick : kFull);
    std::filesystem::create_directories(arguments.output);
    const std::string log_file = (std::filesystem::path(arguments.output) / "study.jsonl").string();
    check_writable(log_file);
    StudyLog log(log_file);
    const std::vector<StudyRow> rows = rows_of(arguments, kind);
    const SceneDescription description = describe(arguments.scene);
    auto loaded = std::make_unique<LoadedScene>(load_scene(description));
    const StudyScene scene = study_scene(arguments.scene, description, loaded->scene);
    const TypeSet types = types_of(rows, loaded->scene, scene.options);
    loaded.reset();  // its memory is for the renders
    Reference reference;
    std::filesystem::remove_all(work_folder(arguments));
    std::filesystem::create_directories(work_folder(arguments));
    const std::vector<MeasuredRow> measured = Runs(scene, rows, arguments).measure(types, log, reference);
    std::filesystem::remove_all(work_folder(arguments));
    write_results(arguments, kind, scene, measured, reference, log);
    if (!arguments.quiet)
        std::fprintf(stderr, "%s\n", (std::filesystem::path(arguments.output) / "index.html").c_str());
}

}  // namespace tress
