#include "fused.h"

#include "pairs.h"

#if QTRI_PAIRS
const qtri_fused qtri_fused_565 = {qtri_flat_pairs, qtri_smooth_pairs, qtri_copy_pairs};
#else
const qtri_fused qtri_fused_565 = {qtri_flat_less, qtri_smooth_less, qtri_copy_less};
#endif
