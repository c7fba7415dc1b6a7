// SPDX-License-Identifier: MIT
// What the page does once it is there.

startLegends();
startViewer();
