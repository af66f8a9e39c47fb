#include "qtri/material.h"

struct qtri_fill {
    uint8_t lines; /* a triangle */
};

const qtri_fill qtri_wireframe = {3};
