// SPDX-License-Identifier: MIT
// A legend entry of a plot hides and shows its series.

function toggleSeries(plot, entry) {
  const off = !entry.classList.contains("off");
  for (const part of plot.querySelectorAll(".series, .legend")) {
    if (part.dataset.series === entry.dataset.series) part.classList.toggle("off", off);
  }
  entry.setAttribute("aria-pressed", String(!off));
}

function startLegendEntry(plot, entry) {
  entry.setAttribute("aria-pressed", String(!entry.classList.contains("off")));
  entry.addEventListener("click", () => toggleSeries(plot, entry));
  entry.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    if (!event.repeat) toggleSeries(plot, entry);
  });
}

function startLegends() {
  for (const plot of document.querySelectorAll("svg.plot")) {
    for (const entry of plot.querySelectorAll(".legend[data-series]")) startLegendEntry(plot, entry);
  }
}
