// What probe/path_records.comp writes, for both languages.
#ifndef VKPT_PROBE_PATH_RECORDS_H
#define VKPT_PROBE_PATH_RECORDS_H

#ifdef __cplusplus
#include "shared/structs.h"
namespace vkpt::shared {
#endif

VKPT_CONSTANT uint kRecordedVertices = 12u; // of a path; the others are only counted
VKPT_CONSTANT uint kVertexFront = 1u;
VKPT_CONSTANT uint kVertexGoesOn = 2u;

struct VertexRecord {
  vec4 direction; // of the ray that led here, and its length
  vec4 gathered;  // radiance that the path gathered here
  uint triangle;  // in input order; 0xFFFFFFFF: none
  uint flags;
  uint unused0;
  uint unused1;
};

struct PathRecord {
  vec4 value;      // of the sample
  uint count;      // vertices
  uint unfinished; // 1: the path was given up, its steps were too many for one dispatch
  uint unused0;
  uint unused1;
  VertexRecord vertices[kRecordedVertices];
};

#ifdef __cplusplus
} // namespace vkpt::shared
#endif
#endif
