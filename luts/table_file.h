/* NAME.bin, which `warplut bake` writes: this struct, little-endian, in C11 and C++. */
#pragma once

#include <stdint.h>

struct WarplutTableFile {
  char magic[8];                   /* "warplut" */
  uint32_t version, nodes, layers; /* 1; 33 per axis; groups of four taps */
  uint32_t prefilter;              /* 0: none, 1: recursive, 2: FIR (luts/prefilter.h) */
  float side, pole;                /* of the prefilter; 0 without; the pole 0 with a FIR */
  uint32_t reach;                  /* of a FIR */
  float taps[8];                   /* of a FIR: t_0 to t_reach, then 0 */
  uint32_t padding;                /* 0 */
  uint16_t halves[1];              /* layers x 33 x 33 x 4, as the texels of the texture */
};
