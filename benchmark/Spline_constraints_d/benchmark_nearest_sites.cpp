// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Which site is nearest in 100,000 random points of each of eight random diagrams: by `nearest_sites()`, and by the
// faces of the arrangement, beside distances from the curves that are found by dense samples. `regions` is the number
// of regions that were found, of those that there are; `wrong_faces` counts faces whose region is farther than the
// nearest curve by more than twice the error of chords, 0.001 here, `wrong_sites` sites that are farther than that by
// more than rounding. `next_to_edges` is the number of points between an edge and its chord, where the face has another
// region than the nearest site.
#include "nearest_site_checks.h"

#include <benchmark/benchmark.h>

namespace {

using namespace nearest_site_checks;

void nearest_sites(benchmark::State& state)
{
  const Scene asked = scene(static_cast<int>(state.range(0)), 1);
  state.SetLabel(asked.kind);
  for (auto _ : state) {
    const Nearest_site_check check(asked);
    const Answers answers = check.answers(100000, 0.001, 2);
    const auto set = [&](const char* name, auto value) { state.counters[name] = static_cast<double>(value); };
    set("complete", answers.is_complete && answers.has_same_topology);
    set("queries", answers.queries);
    set("regions", answers.regions);
    set("of", check.diagram().number_of_regions());
    set("wrong_faces", answers.wrong_faces);
    set("wrong_sites", answers.wrong_sites);
    set("next_to_edges", answers.other_regions);
    if (answers.wrong_faces != 0 || answers.wrong_sites != 0)
      state.SkipWithError("an answer is wrong");
  }
}
BENCHMARK(nearest_sites)->DenseRange(0, number_of_kinds - 1)->Iterations(1)->Unit(benchmark::kMillisecond);

} // namespace
