// SPDX-License-Identifier: MIT
// What ran: the machine, the compiler, the program.
#pragma once

#include <string>

namespace tress {

std::string processor_name();     // as the system calls it; "unknown" where it does not say
std::string compiler_name();      // of this program
std::string program_signature();  // 16 digits that differ where the program's bytes do

}  // namespace tress
