/* SPDX-License-Identifier: MIT */
/* The program around the glue's example. */
#include "../../../port/examples/example.h"

int main(void)
{
    (void)example_run();
    return 1; /* frames end it */
}
