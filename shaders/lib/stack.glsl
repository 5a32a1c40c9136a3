// The traversal stack: one entry a level of the tree, and kEmptyStack below them.
//
// On the device it lives in registers. lavapipe writes an indexed array lane by lane, with a branch for each;
// shifting the whole stack costs one blend an entry, and entries beyond kStackDepth are compiled away. That made
// the whole renderer 1.25 times as fast.

CONSTANT uint kEmptyStack = 0xFFFFFFFFu;

#ifdef __cplusplus

CONSTANT uint kStackDepth = kMaxStackDepth;

struct TraversalStack {
  uint entries[kMaxStackDepth];
  uint top;
};
static TraversalStack emptyStack() {
  TraversalStack s;
  s.top = 0;
  s.entries[0] = kEmptyStack;
  return s;
}
static void clearStack(TraversalStack& s) { s.top = 0; }
static void pushStack(TraversalStack& s, bool push, uint entry) {
  if (push)
    s.entries[++s.top] = entry;
}
static void popStack(TraversalStack& s, bool pop) { s.top -= pop ? 1 : 0; }
static uint topOfStack(const TraversalStack& s) { return s.entries[s.top]; }
static void replaceTop(TraversalStack& s, uint entry) { s.entries[s.top] = entry; }

#else

// X(i, i - 1) from the bottom up, X(i, i + 1) from the top down.
#define VKPT_STACK_UP(X) \
  X(47, 46) X(46, 45) X(45, 44) X(44, 43) X(43, 42) X(42, 41) X(41, 40) X(40, 39) X(39, 38) X(38, 37) \
  X(37, 36) X(36, 35) X(35, 34) X(34, 33) X(33, 32) X(32, 31) X(31, 30) X(30, 29) X(29, 28) X(28, 27) \
  X(27, 26) X(26, 25) X(25, 24) X(24, 23) X(23, 22) X(22, 21) X(21, 20) X(20, 19) X(19, 18) X(18, 17) \
  X(17, 16) X(16, 15) X(15, 14) X(14, 13) X(13, 12) X(12, 11) X(11, 10) X(10, 9) X(9, 8) X(8, 7) \
  X(7, 6) X(6, 5) X(5, 4) X(4, 3) X(3, 2) X(2, 1) X(1, 0)
#define VKPT_STACK_DOWN(X) \
  X(0, 1) X(1, 2) X(2, 3) X(3, 4) X(4, 5) X(5, 6) X(6, 7) X(7, 8) X(8, 9) X(9, 10) \
  X(10, 11) X(11, 12) X(12, 13) X(13, 14) X(14, 15) X(15, 16) X(16, 17) X(17, 18) X(18, 19) X(19, 20) \
  X(20, 21) X(21, 22) X(22, 23) X(23, 24) X(24, 25) X(25, 26) X(26, 27) X(27, 28) X(28, 29) X(29, 30) \
  X(30, 31) X(31, 32) X(32, 33) X(33, 34) X(34, 35) X(35, 36) X(36, 37) X(37, 38) X(38, 39) X(39, 40) \
  X(40, 41) X(41, 42) X(42, 43) X(43, 44) X(44, 45) X(45, 46) X(46, 47)

#define VKPT_STACK_FIELD(i, j) uint e##i;
#define VKPT_STACK_CLEAR(i, j) s.e##i = kEmptyStack;
#define VKPT_STACK_PUSH(i, j) if (i < kStackDepth) s.e##i = push ? s.e##j : s.e##i;
#define VKPT_STACK_POP(i, j) if (j < kStackDepth) s.e##i = pop ? s.e##j : s.e##i;

struct TraversalStack {
  uint e0; // the top
  VKPT_STACK_UP(VKPT_STACK_FIELD)
};
TraversalStack emptyStack() {
  TraversalStack s;
  s.e0 = kEmptyStack;
  VKPT_STACK_UP(VKPT_STACK_CLEAR)
  return s;
}
void clearStack(inout TraversalStack s) { s.e0 = kEmptyStack; }
void pushStack(inout TraversalStack s, bool push, uint entry) {
  VKPT_STACK_UP(VKPT_STACK_PUSH)
  s.e0 = push ? entry : s.e0;
}
void popStack(inout TraversalStack s, bool pop) { VKPT_STACK_DOWN(VKPT_STACK_POP) }
uint topOfStack(TraversalStack s) { return s.e0; }
void replaceTop(inout TraversalStack s, uint entry) { s.e0 = entry; }

#endif
