// Fewer explicit bits in the mantissas of a table's samples, so that what is left compresses.

#if BRDFTAB_TABLE_DOUBLE
typedef ulong table_bits;
#define TABLE_EXPONENT 0x7ff0000000000000UL
#else
typedef uint table_bits;
#define TABLE_EXPONENT 0x7f800000U
#endif

// To nearest, ties to even; samples as integers, [rows][row]. Left as they are: subnormal numbers, whose
// relative error would have no bound, and what would round to infinity.
__kernel void round_mantissas(__global table_bits *restrict samples, int row, int dropped_bits) {
  const size_t k = get_global_id(1) * row + get_global_id(0);
  const table_bits one = 1;
  const table_bits bits = samples[k];
  const table_bits odd = (bits >> dropped_bits) & one;
  const table_bits rounded =
      (bits + ((one << (dropped_bits - 1)) - one) + odd) & ~((one << dropped_bits) - one);
  const int is_normal = (bits & TABLE_EXPONENT) != 0 && (bits & TABLE_EXPONENT) != TABLE_EXPONENT;
  samples[k] = is_normal && (rounded & TABLE_EXPONENT) != TABLE_EXPONENT ? rounded : bits;
}
