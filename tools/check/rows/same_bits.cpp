// SPDX-License-Identifier: MIT
#include "tools/check/rows/same_bits.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "accel/isa_targets.h"
#include "tools/check/support/method_sets.h"
#include "tools/check/support/pictures.h"
#include "tools/check/support/tufts.h"

namespace tress {
namespace {

using namespace test;
using tbb::global_control;

constexpr int kMostThreads = 3;

/// Two tiles, one of them cut short.
Scene small_picture() {
    Scene scene = two_tufts(40);
    scene.camera.height = 16;
    return scene;
}

/// With that many threads, however many cores there are; fewer where the process is held to fewer.
template <class Work>
auto with_threads(int threads, const Work& work) {
    const global_control limit(global_control::max_allowed_parallelism, size_t(threads));
    tbb::task_arena arena(int(global_control::active_value(global_control::max_allowed_parallelism)));
    return arena.execute(work);
}

LayeredImage in_passes_of_one(const Scene& scene, const Options& options) {
    const Plan plan = make_plan(scene, options);
    const PreparedScene prepared = prepare(scene, plan, options);
    RenderState state = make_state(scene, plan);
    for (int pass = 0; pass < options.spp; ++pass) advance(state, scene, prepared, plan, options, 1);
    return develop(state.film);
}

/// Pictures against the first of their kind.
struct Comparison {
    size_t pictures = 0, values = 0, different = 0;

    void add(const LayeredImage& first, const LayeredImage& other) {
        ++pictures;
        values += test::values(other);
        different += different_values(first, other);
    }
    Figure figure(const std::string& how) const {
        return exactly("values whose bits differ, of " + std::to_string(values) + " in " + std::to_string(pictures) +
                           " pictures " + how,
                       double(different), 0);
    }
};

}  // namespace

Outcome measure_threads_and_passes(const CheckSettings& settings) {
    const Scene scene = small_picture();
    Comparison threads, passes;
    const std::vector<MethodSet> sets = method_sets(settings.isa);
    for (const MethodSet& set : sets) {
        const LayeredImage one = with_threads(1, [&] { return render(scene, set.options).picture; });
        threads.add(one, with_threads(2, [&] { return render(scene, set.options).picture; }));
        passes.add(one, with_threads(kMostThreads, [&] { return in_passes_of_one(scene, set.options); }));
    }
    const global_control most(global_control::max_allowed_parallelism, kMostThreads);
    return {
        {threads.figure("by 2 threads against 1"), passes.figure("by 3 threads, in passes of one sample, against 1"),
         told("threads that may run here, of 3",
              double(global_control::active_value(global_control::max_allowed_parallelism)))},
        {}};
}

Outcome measure_instruction_sets(const CheckSettings& settings) {
    const Scene scene = small_picture();
    Comparison sets;
    std::string names;
    for (const Isa isa : supported_isas()) names += (names.empty() ? "" : ", ") + std::string(isa_name(isa));
    for (const MethodSet& set : method_sets(settings.isa)) {
        const LayeredImage first = render(scene, set.options).picture;
        Options options = set.options;
        for (const Isa isa : supported_isas()) {
            options.isa = isa;
            if (isa != settings.isa) sets.add(first, render(scene, options).picture);
        }
    }
    return {{sets.figure("by " + names)}, {}};
}

}  // namespace tress
