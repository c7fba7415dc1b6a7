// SPDX-License-Identifier: MIT
// What tells one groom from another: numbers only, read by hair_path.h and groom.cpp. Lengths in cm.
#pragma once

#include <span>
#include <string_view>

namespace tress {

enum class Combing {
    parted,  // away from a parting at the left, and from the whorl at the crown
    whorl,   // in a spiral about the whorl
};

struct GroomStyle {
    std::string_view name;
    int points;  // a strand
    Combing combing;
    float crown_length, nape_length;  // of strands, by the height of their roots
    float cut;                        // power of the height: above 1 the sides are nearer to the nape's length
    float shortest;                   // of a strand, relative to the length meant at its root
    float lift;                       // of the root's direction: 0 combed flat, 1 along the normal
    float comb;                       // turn towards the combed direction, 1/cm, near the root
    float weight;                     // turn towards the ground, 1/cm
    float volume;                     // thickness of the hair lying on the head
    int locks;                        // small clumps on the whole scalp
    float large_clump, small_clump;   // how far clumps draw their strands together at the tips, 0 to 1
    float wave_width, wave_length;    // radius and period of the waves
    float roundness;                  // of the waves: 0 flat, 1 a helix
    float unison;                     // how far neighbouring locks wave alike: 0 not at all, 1 as one
    float wave_start;                 // arc length over which the waves grow to their width
    float disorder;                   // how far strands stray from their clump, cm at the tip
    float flyaways;                   // fraction of the strands
};

std::span<const GroomStyle> groom_styles();

}  // namespace tress
