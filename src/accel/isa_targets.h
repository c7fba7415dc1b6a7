// SPDX-License-Identifier: MIT
// Instruction sets by name: which can run here, and where their kernels are.
#pragma once

#include <cstddef>
#include <vector>

#include "core/options.h"

namespace tress {

/// The instruction set that kernels asked for `isa` use. Throws InputError where the machine cannot run it.
Isa used_isa(Isa isa);

/// Instruction sets that this machine and this build can run, best first; scalar is always there.
std::vector<Isa> supported_isas();

/// Place of an instruction set's kernels in a table made by HWY_EXPORT in a source that includes highway_targets.h:
/// HWY_DISPATCH_TABLE(f)[kernel_index(isa)]. Throws as used_isa.
size_t kernel_index(Isa isa);

}  // namespace tress
