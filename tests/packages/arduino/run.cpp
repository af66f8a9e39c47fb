/* SPDX-License-Identifier: MIT */
/* Runs a sketch until its frames end the program, on the displays of tests/packages/glue. */
#include "Arduino.h"

unsigned long millis()
{
    return 0;
}

int main()
{
    setup();
    for (;;) {
        loop();
    }
}
