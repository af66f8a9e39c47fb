/* SPDX-License-Identifier: MIT */
/*
 * Q16.16 matrices against exact or longer arithmetic.
 */
#include "support/vec.h"

#define PI_L 3.14159265358979323846264338L

/* Rows of a matrix in long double. */
typedef struct real4 {
    long double m[4][4];
} real4;

static real4 real4_of(const qtri_mat4 *m)
{
    real4 r;
    for (int i = 0; i < 16; i++) {
        r.m[i / 4][i % 4] = m->m[i / 4][i % 4] / 65536.L;
    }
    return r;
}

static real4 real4_identity(void)
{
    qtri_mat4 identity = qtri_mat4_identity();
    return real4_of(&identity);
}

static real4 real4_mul(const real4 *a, const real4 *b)
{
    real4 product;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            product.m[i][j] = 0;
            for (int k = 0; k < 4; k++) {
                product.m[i][j] += a->m[i][k] * b->m[k][j];
            }
        }
    }
    return product;
}

/* Rodrigues: COURSE formulae. */
static real4 real4_rotation(long double x, long double y, long double z, q16 degrees)
{
    real4 r = real4_identity();
    long double angle = degrees / 65536.L * (PI_L / 180);
    long double c = cosl(angle);
    long double s = sinl(angle);
    long double length = sqrtl(x * x + y * y + z * z);
    if (length == 0) {
        return r;
    }
    long double n[3] = {x / length, y / length, z / length};
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        int k = (i + 2) % 3;
        r.m[i][i] = c + n[i] * n[i] * (1 - c);
        r.m[i][j] = n[i] * n[j] * (1 - c) - n[k] * s;
        r.m[i][k] = n[i] * n[k] * (1 - c) + n[j] * s;
    }
    return r;
}

/* Largest difference in ULP, where the exact element is in range; else it must have saturated. */
static double error_of(const qtri_mat4 *m, const real4 *exact)
{
    long double worst = 0;
    for (int i = 0; i < 16; i++) {
        long double element = exact->m[i / 4][i % 4] * 65536;
        element = element > INT32_MAX ? INT32_MAX : (element < INT32_MIN ? INT32_MIN : element);
        long double error = fabsl(m->m[i / 4][i % 4] - element);
        worst = error > worst ? error : worst;
    }
    return (double)worst;
}

static void assert_near_matrix(const qtri_mat4 *m, const real4 *exact, double tolerance)
{
    double error = error_of(m, exact);
    if (!(error <= tolerance)) {
        fail_msg("off by %f ULP", error);
    }
}

static qtri_mat4 random_mat4(uint64_t *seed)
{
    qtri_mat4 m;
    int shift = random_in(seed, 0, 24);
    for (int i = 0; i < 16; i++) {
        m.m[i / 4][i % 4] = random_in(seed, 0, 20) == 0 ? INT32_MIN : random_bits32(seed) >> shift;
    }
    return m;
}

/* COURSE scene 1. */
TEST(plane_transforms)
{
    qtri_vec2 p = {Q16(2), Q16(1)};
    qtri_vec2 by[2] = {{Q16(1), Q16(2)}, {Q16(2), Q16(1)}};
    static const double expected[2][2] = {{1.70710678, 4.12132034}, {2.70710678, 3.12132034}};
    qtri_mat3 turn = qtri_mat3_rotate_deg(Q16(45));
    for (int i = 0; i < 2; i++) {
        qtri_mat3 move = qtri_mat3_translate(by[i]);
        qtri_mat3 both = qtri_mat3_mul(&move, &turn);
        qtri_vec2 result = qtri_mat3_point(&both, p);
        assert_near(real(result.x), expected[i][0], 2 / 65536.);
        assert_near(real(result.y), expected[i][1], 2 / 65536.);
        result = qtri_mat3_vector(&both, p); /* a vector does not move */
        assert_near(real(result.x), .70710678, 2 / 65536.);
        assert_near(real(result.y), 2.12132034, 2 / 65536.);
    }
    qtri_vec2 factor = {Q16(-2), Q16(0.5)};
    qtri_mat3 scale = qtri_mat3_scale(factor);
    qtri_vec2 scaled = qtri_mat3_point(&scale, p);
    assert_int_equal(scaled.x, Q16(-4));
    assert_int_equal(scaled.y, Q16(0.5));
    qtri_mat3 shear = qtri_mat3_shear(Q16(3), Q16(-1));
    qtri_vec2 sheared = qtri_mat3_point(&shear, p);
    assert_int_equal(sheared.x, Q16(5));
    assert_int_equal(sheared.y, Q16(-1));

    qtri_mat3 flip = qtri_mat3_reflect_deg(0);
    qtri_vec2 mirrored = qtri_mat3_point(&flip, p);
    assert_true(mirrored.x == Q16(2) && mirrored.y == Q16(-1));
    flip = qtri_mat3_reflect_deg(Q16(90));
    mirrored = qtri_mat3_point(&flip, p);
    assert_true(mirrored.x == Q16(-2) && mirrored.y == Q16(1));
    flip = qtri_mat3_reflect_deg(Q16(45) - Q16(180));
    mirrored = qtri_mat3_point(&flip, p);
    assert_true(mirrored.x == Q16(1) && mirrored.y == Q16(2));

    uint64_t seed = 41;
    for (int i = 0; i < 100000; i++) {
        q16 degrees = random_any(&seed);
        long double angle = degrees / 65536.L * (PI_L / 180);
        qtri_vec2 centre = {random_any(&seed), random_any(&seed)};
        qtri_mat3 about = qtri_mat3_rotate_about_deg(degrees, centre);
        qtri_mat3 mirror = qtri_mat3_reflect_deg(degrees);
        assert_near(about.m[0][0], (double)(cosl(angle) * 65536), .52);
        assert_near(about.m[1][0], (double)(sinl(angle) * 65536), .52);
        assert_near(mirror.m[0][0], (double)(cosl(2 * angle) * 65536), .52);
        assert_near(mirror.m[0][1], (double)(sinl(2 * angle) * 65536), .52);
        assert_true(mirror.m[1][1] == -mirror.m[0][0] && mirror.m[1][0] == mirror.m[0][1]);
        if (labs(centre.x) < Q16(8000) && labs(centre.y) < Q16(8000)) {
            qtri_vec2 still = qtri_mat3_point(&about, centre);
            assert_in_range(still.x - centre.x + 1, 0, 2);
            assert_in_range(still.y - centre.y + 1, 0, 2);
        }
    }
}

/*
 * Four products at the limits of every way to add them: sums around 2^64, which are 0 in 64 bits,
 * and around 2^47, which is where results saturate, of factors of every length.
 */
TEST(sums_at_the_limits)
{
    uint64_t seed = 14;
    for (int n = 0; n < 200000; n++) {
        q16 rows[8]; /* a row, and what it is multiplied by */
        qtri_mat4 m = {{{0}}};
        int bit = n % 2 == 0 ? 31 : random_in(&seed, 16, 31);
        int other = n % 2 == 0 ? 31 : random_in(&seed, 45, 47) - bit;
        int spread = n % 4 == 0 ? 3 : 20000;
        for (int i = 0; i < 8; i++) {
            int64_t size = ((int64_t)1 << (i < 4 ? bit : other)) - random_in(&seed, -3, spread);
            int64_t x = random_in(&seed, 0, 9) == 0 ? size : -size;
            rows[i] = (q16)(x > INT32_MAX ? INT32_MAX : x < INT32_MIN ? INT32_MIN : x);
        }
        int at = random_in(&seed, 0, 3);
        int128 sum = 0;
        for (int i = 0; i < 4; i++) {
            m.m[at][i] = rows[i];
            sum += (int128)rows[i] * rows[4 + i];
        }
        const q16 expected = q16_of_products(sum);
        q16 narrow[4];
        q16 image[4];
        qtri_vec4 a = {rows[0], rows[1], rows[2], rows[3]};
        qtri_vec4 b = {rows[4], rows[5], rows[6], rows[7]};
        qtri_mat4_times(image, &m, rows + 4);
        narrow_mat4_times(narrow, &m, rows + 4);
        for (int i = 0; i < 4; i++) {
            assert_int_equal(image[i], i == at ? expected : 0);
            assert_int_equal(narrow[i], i == at ? expected : 0);
        }
        assert_int_equal(qtri_vec4_dot(a, b), expected);
    }
}

TEST(products)
{
    uint64_t seed = 13;
    for (int n = 0; n < 40000; n++) {
        qtri_mat4 a = random_mat4(&seed);
        qtri_mat4 b = random_mat4(&seed);
        qtri_mat4 product = qtri_mat4_mul(&a, &b);
        qtri_mat4 transposed = qtri_mat4_transpose(&a);
        qtri_vec4 v = {b.m[0][0], b.m[1][0], b.m[2][0], b.m[3][0]};
        qtri_vec3 v3 = {v.x, v.y, v.z};
        qtri_vec4 image = qtri_mat4_vec4(&a, v);
        qtri_vec3 point = qtri_mat4_point(&a, v3);
        qtri_vec3 vector = qtri_mat4_vector(&a, v3);
        qtri_mat3 a3 = qtri_mat4_linear(&a);
        qtri_mat3 b3 = qtri_mat4_linear(&b);
        qtri_mat3 product3 = qtri_mat3_mul(&a3, &b3);
        qtri_mat3 transposed3 = qtri_mat3_transpose(&a3);
        qtri_vec3 image3 = qtri_mat3_vec3(&a3, v3);
        qtri_vec2 v2 = {v.x, v.y};
        qtri_vec2 point2 = qtri_mat3_point(&a3, v2);
        qtri_vec2 vector2 = qtri_mat3_vector(&a3, v2);
        const q16 column[4] = {image.x, image.y, image.z, image.w};
        const q16 argument[4] = {v.x, v.y, v.z, v.w};
        q16 narrow[4];
        narrow_mat4_times(narrow, &a, argument);
        assert_memory_equal(narrow, column, sizeof column);
        const q16 column3[3] = {image3.x, image3.y, image3.z};
        const q16 points[3] = {point.x, point.y, point.z};
        const q16 vectors[3] = {vector.x, vector.y, vector.z};
        const q16 points2[2] = {point2.x, point2.y};
        const q16 vectors2[2] = {vector2.x, vector2.y};
        for (int i = 0; i < 4; i++) {
            assert_int_equal(column[i], product.m[i][0]);
            for (int j = 0; j < 4; j++) {
                int128 sum = 0;
                int128 sum3 = 0;
                for (int k = 0; k < 4; k++) {
                    sum += (int128)a.m[i][k] * b.m[k][j];
                    sum3 += k < 3 ? (int128)a.m[i][k] * b.m[k][j] : 0;
                }
                assert_int_equal(product.m[i][j], q16_of_products(sum));
                assert_int_equal(transposed.m[i][j], a.m[j][i]);
                if (i < 3 && j < 3) {
                    assert_int_equal(product3.m[i][j], q16_of_products(sum3));
                    assert_int_equal(transposed3.m[i][j], a.m[j][i]);
                }
                if (i < 3 && j == 0) {
                    assert_int_equal(column3[i], q16_of_products(sum3));
                    assert_int_equal(vectors[i], q16_of_products(sum3));
                    sum3 += (int128)a.m[i][3] * 65536;
                    assert_int_equal(points[i], q16_of_products(sum3));
                }
            }
            if (i < 2) {
                int128 sum = (int128)a.m[i][0] * v.x + (int128)a.m[i][1] * v.y;
                assert_int_equal(vectors2[i], q16_of_products(sum));
                sum += (int128)a.m[i][2] * 65536;
                assert_int_equal(points2[i], q16_of_products(sum));
            }
        }
    }
    const qtri_mat4 identity = qtri_mat4_identity();
    const qtri_mat3 identity3 = qtri_mat3_identity();
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            const q16 expected = i == j ? Q16_ONE : 0;
            assert_int_equal(identity.m[i][j], expected);
            assert_true(i == 3 || j == 3 || identity3.m[i][j] == expected);
        }
    }
}

/* det of the rows and columns in the masks: exact while elements are below 2^29. */
static int128 minor_of(const q16 *m, int n, unsigned rows, unsigned columns)
{
    int row = 0;
    if (rows == 0) {
        return 1;
    }
    while ((rows >> row & 1) == 0) {
        row++;
    }
    int128 sum = 0;
    int sign = 1;
    for (int j = 0; j < n; j++) {
        if ((columns >> j & 1) != 0) {
            int128 rest = minor_of(m, n, rows & ~(1u << row), columns & ~(1u << j));
            sum += sign * m[row * n + j] * rest;
            sign = -sign;
        }
    }
    return sum;
}

/* det / 2^(16 (n - 1)), halves up. */
static q16 determinant_of(int128 det, int n)
{
    int128 unit = (int128)1 << (16 * (n - 1));
    return saturated(floor_div(det + unit / 2, unit));
}

static double worst_inverse;

/* inverse = 2^32 cofactor / det, whatever n is. */
static void check_inverse(const q16 *inverse, const q16 *m, int n, int128 det)
{
    unsigned all = (1u << n) - 1;
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            int128 cofactor = minor_of(m, n, all & ~(1u << j), all & ~(1u << i));
            cofactor = ((i + j) & 1) != 0 ? -cofactor : cofactor;
            long double exact = (long double)cofactor / (long double)det * 4294967296.L;
            exact = exact > INT32_MAX ? INT32_MAX : (exact < INT32_MIN ? INT32_MIN : exact);
            long double error = fabsl(inverse[i * n + j] - exact);
            worst_inverse = fmax(worst_inverse, (double)error);
        }
    }
}

TEST(inverses)
{
    uint64_t seed = 42;
    int singular = 0;
    int saturating = 0;
    for (int n = 0; n < 60000; n++) {
        qtri_mat4 m;
        int shift = random_in(&seed, 3, 31);
        for (int i = 0; i < 16; i++) {
            m.m[i / 4][i % 4] = random_bits32(&seed) >> shift;
        }
        if (n % 4 == 0) { /* a row that depends on another, or nearly */
            for (int j = 0; j < 4; j++) {
                m.m[2][j] = m.m[0][j];
            }
            m.m[2][1] += n % 8 == 0 ? 0 : random_in(&seed, 0, 3);
        }
        qtri_mat4 inverse;
        int128 det = minor_of(m.m[0], 4, 15, 15);
        assert_int_equal(qtri_mat4_determinant(&m), determinant_of(det, 4));
        assert_int_equal(qtri_mat4_inverse(&inverse, &m), det != 0);
        qtri_mat4 identity = qtri_mat4_identity();
        if (det == 0) {
            assert_memory_equal(&inverse, &identity, sizeof identity);
            singular++;
        } else {
            check_inverse(inverse.m[0], m.m[0], 4, det);
            saturating += inverse.m[0][0] == INT32_MAX || inverse.m[0][0] == INT32_MIN;
        }
        qtri_mat4 affine = m;
        for (int j = 0; j < 4; j++) {
            affine.m[3][j] = identity.m[3][j];
        }
        qtri_mat4 expected;
        bool regular = qtri_mat4_inverse(&expected, &affine);
        assert_int_equal(qtri_mat4_inverse_affine(&inverse, &m), regular);
        assert_memory_equal(&inverse, &expected, sizeof expected);
        assert_memory_equal(inverse.m[3], identity.m[3], sizeof identity.m[3]);

        qtri_mat3 linear = qtri_mat4_linear(&m);
        qtri_mat3 normals;
        int128 det3 = minor_of(linear.m[0], 3, 7, 7);
        assert_int_equal(qtri_mat3_determinant(&linear), determinant_of(det3, 3));
        assert_int_equal(qtri_mat4_normal_matrix(&normals, &m), det3 != 0);
        assert_int_equal(qtri_mat3_inverse(&linear, &linear), det3 != 0); /* in place */
        linear = qtri_mat3_transpose(&linear);
        assert_memory_equal(&linear, &normals, sizeof normals);
        if (det3 != 0) {
            linear = qtri_mat4_linear(&m);
            normals = qtri_mat3_transpose(&normals);
            check_inverse(normals.m[0], linear.m[0], 3, det3);
        }
    }
    print_message("inverse: %.6f ULP; %d singular, %d saturating\n", worst_inverse, singular,
                  saturating);
    assert_true(worst_inverse <= .5001 && singular > 5000 && saturating > 100);
}

/* The whole range, where 128 bits are not enough to check by. */
TEST(large_inverses)
{
    uint64_t seed = 43;
    qtri_mat4 lowest;
    for (int i = 0; i < 16; i++) {
        lowest.m[i / 4][i % 4] = INT32_MIN;
    }
    qtri_mat4 inverse;
    assert_false(qtri_mat4_inverse(&inverse, &lowest));
    assert_int_equal(qtri_mat4_determinant(&lowest), 0);
    /* Hadamard's matrix: the largest determinants there are; H H = 4. */
    for (int size = 4; size <= 31; size += 9) {
        qtri_mat4 h;
        for (int i = 0; i < 4; i++) {
            for (int j = 0; j < 4; j++) {
                bool odd = ((i & j) == 1) || ((i & j) == 2);
                int64_t element = (odd ? -1 : 1) * ((int64_t)1 << size);
                h.m[i][j] = saturated(element);
            }
        }
        assert_true(qtri_mat4_inverse(&inverse, &h));
        for (int i = 0; i < 16; i++) {
            double expected = (h.m[i / 4][i % 4] < 0 ? -1 : 1) * ldexp(1, 30 - size);
            assert_near(inverse.m[i / 4][i % 4], expected, .5001);
        }
    }
    for (int n = 0; n < 20000; n++) { /* the determinant's sign and rank */
        qtri_mat4 m = random_mat4(&seed);
        q16 det = qtri_mat4_determinant(&m);
        qtri_mat4 swapped = m;
        for (int j = 0; j < 4; j++) {
            swapped.m[1][j] = m.m[3][j];
            swapped.m[3][j] = m.m[1][j];
        }
        q16 minus = qtri_mat4_determinant(&swapped);
        bool ends =
            (det == INT32_MIN && minus == INT32_MAX) || (det == INT32_MAX && minus == INT32_MIN);
        assert_true(ends || minus == -det || minus == 1 - det); /* halves go up */
        for (int j = 0; j < 4; j++) {
            swapped.m[3][j] = swapped.m[0][j];
        }
        assert_false(qtri_mat4_inverse(&inverse, &swapped));
    }
}

TEST(builders)
{
    qtri_vec3 p = vec3_of(1, 2, 3);
    qtri_vec3 by = vec3_of(-4, 5, 0.5);
    qtri_mat4 m = qtri_mat4_translate(by);
    qtri_vec3 r = qtri_mat4_point(&m, p);
    assert_true(r.x == Q16(-3) && r.y == Q16(7) && r.z == Q16(3.5));
    r = qtri_mat4_vector(&m, p);
    assert_true(r.x == p.x && r.y == p.y && r.z == p.z);
    m = qtri_mat4_scale(by);
    r = qtri_mat4_point(&m, p);
    assert_true(r.x == Q16(-4) && r.y == Q16(10) && r.z == Q16(1.5));
    m = qtri_mat4_shear(Q16(1), Q16(2), Q16(3), Q16(4), Q16(5), Q16(6));
    r = qtri_mat4_point(&m, p);
    assert_true(r.x == Q16(1 + 2 + 6) && r.y == Q16(2 + 3 + 12) && r.z == Q16(3 + 5 + 12));

    /* Quarter turns are exact, and right-handed: x to y about z, y to z about x, z to x about y. */
    m = qtri_mat4_rotate_z_deg(Q16(90));
    r = qtri_mat4_point(&m, p);
    assert_true(r.x == -p.y && r.y == p.x && r.z == p.z);
    m = qtri_mat4_rotate_x_deg(Q16(90));
    r = qtri_mat4_point(&m, p);
    assert_true(r.x == p.x && r.y == -p.z && r.z == p.y);
    m = qtri_mat4_rotate_y_deg(Q16(90));
    r = qtri_mat4_point(&m, p);
    assert_true(r.x == p.z && r.y == p.y && r.z == -p.x);
}

TEST(rotations)
{
    uint64_t seed = 45;
    double worst = 0;
    for (int n = 0; n < 50000; n++) {
        q16 degrees = n < 16 ? Q16(90) * (n - 8) : random_any(&seed);
        qtri_mat4 x = qtri_mat4_rotate_x_deg(degrees);
        qtri_mat4 y = qtri_mat4_rotate_y_deg(degrees);
        qtri_mat4 z = qtri_mat4_rotate_z_deg(degrees);
        real4 exact = real4_rotation(1, 0, 0, degrees);
        worst = fmax(worst, error_of(&x, &exact));
        exact = real4_rotation(0, 1, 0, degrees);
        worst = fmax(worst, error_of(&y, &exact));
        exact = real4_rotation(0, 0, 1, degrees);
        worst = fmax(worst, error_of(&z, &exact));

        qtri_vec3 axis = random_vec3(&seed);
        qtri_mat4 any = qtri_mat4_rotate_axis_deg(axis, degrees);
        exact = real4_rotation(axis.x, axis.y, axis.z, degrees);
        worst = fmax(worst, error_of(&any, &exact));

        qtri_vec3 point = vec3_of(random_in(&seed, -5000, 5000), random_in(&seed, -5000, 5000),
                                  random_in(&seed, -5000, 5000));
        qtri_mat4 about = qtri_mat4_rotate_about_deg(axis, degrees, point);
        qtri_vec3 still = qtri_mat4_point(&about, point);
        assert_in_range(still.x - point.x + 1, 0, 2);
        assert_in_range(still.y - point.y + 1, 0, 2);
        assert_in_range(still.z - point.z + 1, 0, 2);
        for (int i = 0; i < 12; i++) {
            assert_true(i % 4 == 3 || about.m[i / 4][i % 4] == any.m[i / 4][i % 4]);
        }
    }
    for (int axis = 0; axis < 3; axis++) { /* right angles about an axis: exact */
        qtri_vec3 n = {axis == 0, axis == 1, axis == 2 ? INT32_MIN : 0};
        for (int turn = -8; turn <= 8; turn++) {
            qtri_mat4 m = qtri_mat4_rotate_axis_deg(n, Q16(90) * turn);
            for (int i = 0; i < 16; i++) {
                q16 element = m.m[i / 4][i % 4];
                assert_true(element == 0 || element == Q16_ONE || element == -Q16_ONE);
            }
        }
    }
    print_message("rotations: %.4f ULP\n", worst);
    assert_true(worst <= .51);
}

TEST(euler_orders)
{
    static const qtri_euler order[6] = {QTRI_EULER_XYZ, QTRI_EULER_XZY, QTRI_EULER_YXZ,
                                        QTRI_EULER_YZX, QTRI_EULER_ZXY, QTRI_EULER_ZYX};
    static const int axes[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                   {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    uint64_t seed = 46;
    double worst = 0;
    for (int n = 0; n < 20000; n++) {
        qtri_vec3 degrees = random_vec3(&seed);
        const q16 angle[3] = {degrees.x, degrees.y, degrees.z};
        const qtri_mat4 named[6] = {qtri_mat4_rotate_euler_deg(degrees, QTRI_EULER_XYZ),
                                    qtri_mat4_rotate_euler_deg(degrees, QTRI_EULER_XZY),
                                    qtri_mat4_rotate_euler_deg(degrees, QTRI_EULER_YXZ),
                                    qtri_mat4_rotate_euler_deg(degrees, QTRI_EULER_YZX),
                                    qtri_mat4_rotate_euler_deg(degrees, QTRI_EULER_ZXY),
                                    qtri_mat4_rotate_euler_deg(degrees, QTRI_EULER_ZYX)};
        for (int k = 0; k < 6; k++) {
            real4 exact = real4_identity();
            for (int step = 0; step < 3; step++) { /* the first turn is nearest the vector */
                int axis = axes[k][step];
                real4 turn = real4_rotation(axis == 0, axis == 1, axis == 2, angle[axis]);
                exact = real4_mul(&turn, &exact);
            }
            qtri_mat4 m = qtri_mat4_rotate_euler_deg(degrees, order[k]);
            assert_memory_equal(&m, &named[k], sizeof m);
            worst = fmax(worst, error_of(&m, &exact));
        }
    }
    (void)qtri_mat4_rotate_euler_deg(vec3_of(1, 2, 3), (qtri_euler)0x3FF); /* defined */
    print_message("Euler: %.4f ULP\n", worst);
    assert_true(worst <= .51);
}

TEST(reflections)
{
    uint64_t seed = 47;
    for (int n = 0; n < 50000; n++) {
        qtri_vec3 normal = random_vec3(&seed);
        qtri_vec4 plane = {normal.x, normal.y, normal.z, random_any(&seed)};
        const long double e[4] = {plane.x, plane.y, plane.z, plane.w};
        long double square = e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
        qtri_mat4 m = qtri_mat4_reflect(plane);
        real4 exact = real4_identity();
        for (int i = 0; i < 3 && square != 0; i++) {
            for (int j = 0; j < 4; j++) {
                exact.m[i][j] -= 2 * e[i] * e[j] / square;
            }
        }
        assert_near_matrix(&m, &exact, .5001);
    }
    qtri_vec4 ground = {0, Q16(2), 0, Q16(-6)}; /* y = 3 */
    qtri_mat4 m = qtri_mat4_reflect(ground);
    qtri_vec3 r = qtri_mat4_point(&m, vec3_of(1, 2, 3));
    assert_true(r.x == Q16(1) && r.y == Q16(4) && r.z == Q16(3));
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
