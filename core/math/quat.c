#include "qtri/quat.h"

#include "dot.h"
#include "quat_q30.h"
#include "unit.h"

/* Functions for arrays read a struct by the address of its first component. */
typedef char qtri_quat_is_packed[sizeof(qtri_quat) == 4 * sizeof(q16) ? 1 : -1];

qtri_quat qtri_quat_identity(void)
{
    qtri_quat identity = {Q16_ONE, 0, 0, 0};
    return identity;
}

qtri_quat qtri_quat_from_q30(const int32_t q_q30[4])
{
    qtri_quat result = {qtri_q30_to_q16(q_q30[0]), qtri_q30_to_q16(q_q30[1]),
                        qtri_q30_to_q16(q_q30[2]), qtri_q30_to_q16(q_q30[3])};
    return result;
}

qtri_quat qtri_quat_conjugate(qtri_quat a)
{
    qtri_quat result = {a.w, q16_neg(a.x), q16_neg(a.y), q16_neg(a.z)};
    return result;
}

q16 qtri_quat_dot(qtri_quat a, qtri_quat b)
{
    return qtri_dot((const q16 *)&a, (const q16 *)&b, 4);
}

qtri_quat qtri_quat_normalize(qtri_quat a)
{
    int32_t q_q30[4];
    qtri_rotation_unit(q_q30, (const q16 *)&a);
    return qtri_quat_from_q30(q_q30);
}
