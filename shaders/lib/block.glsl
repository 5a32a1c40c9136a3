// Blocks of 8 x 8 pixels. Within one the pixels lie in Morton order, so that a subgroup of 8 is a tile of 4 x 2.

uint columnInBlock(uint place) { return (place & 1u) | ((place >> 1u) & 2u) | ((place >> 2u) & 4u); }
uint rowInBlock(uint place) { return columnInBlock(place >> 1u); }
uint placeInBlock(uint column, uint row) {
  uint x = (column & 1u) | ((column & 2u) << 1u) | ((column & 4u) << 2u);
  uint y = (row & 1u) | ((row & 2u) << 1u) | ((row & 4u) << 2u);
  return x | (y << 1u);
}
