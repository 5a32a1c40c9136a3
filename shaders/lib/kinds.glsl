// Kinds of light path: what has happened to a path since the eye, in eight histories, and the kind it has if it
// meets light now. E eye, L light, S specular (Sr reflected, St transmitted), D any other scattering.
//   0 E   1 ES+   2 ES*D   3 ES*DD+   4 ES*DSr   5 ES*DSt   6 ES*DStSt   7 any other with an S behind the first D
// The tables hold one hexadecimal digit a history, history 0 in the lowest.
CONSTANT uint kHistoryEye = 0u;
CONSTANT uint kHistoryLight = 0u; // of a path from a light: light_path.glsl

uint afterDiffuse(uint history) { return (0x77773322u >> (4u * history)) & 15u; }
uint afterSpecular(uint history, bool transmitted) {
  uint table = transmitted ? 0x77677511u : 0x77777411u;
  return (MUTATE(TransmissionIsReflection, table, 0x77777411u) >> (4u * history)) & 15u;
}
bool behindDiffuse(uint history) { return history >= 2u; }
uint kindOf(uint history) { return (0x42423150u >> (4u * history)) & 15u; }

bool kindWanted(uint history) { return ((pathKinds() >> kindOf(history)) & 1u) != 0u; }
bool historyDead(uint history) { return ((deadHistories() >> history) & 1u) != 0u; }
